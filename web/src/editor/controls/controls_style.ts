import { css } from "lit";
import { entry, flow } from "../../ui/theme";

/** Fields, choices and rows of controls, as wide as a finger where fingers are used. */
export const controls = css`
  button {
    min-height: 30px;
  }
  button.main {
    color: #04140a;
    background: var(--coming);
    border-color: var(--coming);
    font-weight: 700;
  }
  button.quiet {
    background: none;
    border-color: transparent;
  }
  button.icon {
    min-width: 30px;
    padding: 0 4px;
  }
  input:not([type]),
  input[type="text"],
  input[type="search"],
  select {
    ${entry}
    font-size: 12.5px;
    min-height: 30px;
  }
  input::placeholder {
    color: var(--faint);
  }
  input[type="range"] {
    accent-color: var(--text);
    min-width: 40px;
    height: 24px;
    margin: 0;
    background: none;
  }
  input[type="checkbox"] {
    accent-color: var(--text);
    width: 16px;
    height: 16px;
    margin: 0;
  }
  label {
    color: var(--dim);
  }
  p {
    color: var(--dim);
    max-width: 60ch;
  }
  a {
    color: var(--text);
  }
  .row {
    ${flow}
    gap: 6px;
  }
  .grow {
    flex: 1;
    min-width: 0;
  }
  .note {
    color: var(--faint);
    font-size: 12px;
  }
  @media (pointer: coarse) {
    button,
    select,
    input:not([type]),
    input[type="text"],
    input[type="search"] {
      min-height: 40px;
    }
    button.icon {
      min-width: 40px;
    }
    input[type="range"] {
      height: 40px;
    }
    input[type="checkbox"] {
      width: 24px;
      height: 24px;
    }
  }
`;

/** A panel on the right: sections under each other. */
export const panel = css`
  :host {
    display: grid;
    grid-template-columns: minmax(0, 1fr);
    align-content: start;
    gap: 10px;
    padding: 10px;
  }
  ul,
  ol {
    display: grid;
    gap: 6px;
  }
  li.card {
    background: var(--raised);
    border: 1px solid var(--line);
    border-radius: 5px;
    padding: 6px 8px;
    display: grid;
    gap: 4px;
  }
`;
