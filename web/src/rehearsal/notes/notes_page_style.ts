/** The look of the notes page: one column that a phone shows whole; on paper the notes alone. */

import { css } from "lit";
import { entry, flow } from "../../ui/theme";

export const notesPageStyle = css`
  :host {
    max-width: 900px;
    margin: 0 auto;
    padding: 6px 12px 40px;
  }
  header {
    padding: 0;
  }
  nav {
    display: flex;
    gap: 4px;
  }
  nav a {
    display: grid;
    place-content: center;
    min-width: 44px;
    min-height: 44px;
    padding: 0 4px;
  }
  .air {
    margin-left: auto;
    font-size: 18px;
    color: var(--dim);
  }
  .air b {
    color: var(--air);
  }
  form {
    position: sticky;
    top: 0;
    z-index: 1;
    display: grid;
    grid-template-columns: minmax(0, 1fr) 150px auto;
    align-items: end;
    gap: 4px 8px;
    padding: 8px 0;
    background: var(--ground);
  }
  label {
    display: grid;
    gap: 3px;
    color: var(--dim);
  }
  .note:has(+ .add) {
    grid-column: span 2;
  }
  input {
    ${entry}
    width: 100%;
    min-height: 48px;
    font-size: 18px; /* below 16 a phone zooms in */
  }
  .add {
    min-width: 84px;
    min-height: 48px;
    font-size: 16px;
    color: var(--text);
  }
  .stamp {
    grid-column: 1 / -1;
    min-height: 16px;
    color: var(--dim);
  }
  .tools {
    ${flow}
    gap: 6px;
    padding: 4px 0 8px;
  }
  .tools :is(button, select) {
    min-width: 44px;
    min-height: 44px;
    color: var(--text);
  }
  .count {
    flex: 1;
    color: var(--dim);
  }
  .restore {
    max-width: 100%;
    overflow: hidden;
    text-overflow: ellipsis;
  }
  @media (max-width: 600px) {
    form {
      grid-template-columns: minmax(0, 1fr) auto;
    }
    .note {
      grid-column: 1 / -1;
    }
    .note:has(+ .add) {
      grid-column: span 1;
    }
  }
  @media print {
    :host {
      --text: #000;
      --dim: #333;
      --line: #999;
      --ground: #fff;
    }
    form,
    nav,
    .tools,
    .lost {
      display: none;
    }
  }
`;
