/** The look of the page that compares runs: charts beside the table on a desk, below each other on a phone. */

import { css } from "lit";
import { flow, selectable } from "../../ui/theme";

export const runsPageStyle = css`
  :host {
    display: grid;
    grid-template-columns: minmax(0, 1fr) 400px;
    grid-template-rows: auto auto 1fr;
    align-content: start;
    gap: 6px 12px;
    padding: 6px 12px 30px;
  }
  header,
  :host > p {
    grid-column: 1 / -1;
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
  .choice {
    display: flex;
    flex: 1 1 280px;
    gap: 4px;
    min-width: 0;
  }
  .choice select {
    flex: 1;
    min-width: 0;
  }
  :is(button, select) {
    min-width: 44px;
    min-height: 44px;
    color: var(--text);
  }
  .choice button {
    font-weight: 800;
  }
  .choice button[aria-pressed="true"] {
    background: var(--raised);
    border-color: currentColor;
  }
  .choice button[aria-pressed="false"] {
    opacity: 0.45;
    text-decoration: line-through;
  }
  .tools {
    ${flow}
    gap: 6px;
    padding: 2px 0;
  }
  .tools select {
    max-width: 100%;
  }
  .charts {
    display: grid;
    gap: 4px;
    padding-top: 4px;
    border-radius: 4px;
  }
  main {
    grid-row: span 2;
    min-width: 0;
  }
  .look {
    display: grid;
    align-content: start;
    gap: 8px;
  }
  iframe {
    width: 100%;
    aspect-ratio: 16 / 10;
    border: 1px solid var(--line);
    background: #000;
  }
  .row {
    ${flow}
    gap: 6px;
  }
  .at {
    font-size: 18px;
  }
  .hint,
  .none {
    color: var(--dim);
  }
  table {
    ${selectable}
    border-collapse: collapse;
    width: 100%;
  }
  caption {
    padding: 4px 0;
    text-align: left;
    color: var(--dim);
  }
  :is(th, td) {
    padding: 0 6px 0 0;
    font-weight: 400;
    text-align: right;
    border-bottom: 1px solid var(--line);
  }
  thead th {
    color: var(--dim);
    vertical-align: bottom;
  }
  th:first-child {
    text-align: left;
  }
  tbody th button {
    min-height: 44px;
    font-weight: 700;
  }
  tr[aria-selected="true"] {
    background: var(--raised);
  }
  .late {
    color: var(--attention);
  }
  .early {
    color: var(--focus);
  }
  @media (max-width: 1000px) {
    :host {
      grid-template: none / minmax(0, 1fr);
    }
    main {
      grid-row: auto;
    }
    .look {
      position: sticky;
      top: 0;
      z-index: 1;
      order: -1;
      background: var(--ground);
    }
    header,
    .lost {
      order: -2;
    }
    iframe {
      height: 26vh;
      aspect-ratio: auto;
    }
    .quantities {
      flex-wrap: nowrap;
      overflow-x: auto;
    }
    .quantities button {
      flex: none;
    }
  }
`;
