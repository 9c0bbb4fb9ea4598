/** How the cue page is laid out: on a desk beside each other, on a phone below each other, on paper the list alone. */

import { css } from "lit";
import { ellipsis } from "../../ui/theme";

export const cuesPageStyle = css`
  :host {
    display: grid;
    grid-template: "head head" auto "form form" auto "list side" minmax(0, 1fr) "list go" auto / minmax(0, 1fr) 380px;
    gap: 6px;
    height: 100dvh;
    overflow: hidden;
  }
  :host([editing]) {
    grid-template-columns: minmax(0, 1fr) minmax(400px, 36%);
  }
  :host([far]) {
    display: block;
    padding: 0;
  }
  header {
    grid-area: head;
    gap: 4px 8px;
    min-width: 0;
    padding: 0 4px;
  }
  nav {
    display: flex;
    gap: 12px;
  }
  header button {
    min-height: 36px;
    color: var(--text);
  }
  .step span {
    ${ellipsis}
    display: inline-block;
    max-width: 130px;
    vertical-align: bottom;
  }
  .locked {
    font-weight: 700;
    color: var(--attention);
  }
  .lock[aria-pressed="true"] {
    color: #1c1500;
    background: var(--attention);
    border-color: var(--attention);
  }
  .form {
    grid-area: form;
  }
  omote-cue-list {
    grid-area: list;
  }
  omote-cue-list > button {
    min-height: 32px;
    color: var(--text);
  }
  omote-cue-air,
  omote-cue-editor {
    grid-area: side;
    min-height: 0;
  }
  omote-cue-go {
    grid-area: go;
  }
  .notice {
    flex: 1 1 160px;
    min-width: 0;
    max-height: 40px;
    overflow: auto;
    color: var(--attention);
    overflow-wrap: anywhere;
  }
  .notice.done {
    color: var(--text);
  }
  header .panic {
    min-width: 110px;
    min-height: 44px;
    font-size: 16px;
    font-weight: 800;
    letter-spacing: 0.14em;
    color: var(--attention);
    background: #241a02;
    border: 2px solid var(--attention);
    border-radius: 6px;
    touch-action: none;
  }
  @media (pointer: coarse) {
    :host {
      --finger: 44px;
    }
    nav a {
      display: grid;
      place-content: center;
      min-width: 44px;
      min-height: 44px;
    }
    omote-cue-list > button {
      min-height: 44px;
    }
  }
  @media (max-width: 1100px) {
    :host,
    :host([editing]) {
      grid-template-columns: minmax(0, 1fr) 340px;
    }
  }
  @media (max-width: 720px) {
    :host {
      grid-template: "head" auto "form" auto "side" auto "list" minmax(0, 1fr) "go" auto / minmax(0, 1fr);
      gap: 4px;
      padding: 4px;
    }
    :host([editing]) {
      grid-template: "head" auto "form" auto "list" minmax(0, 2fr) "side" minmax(0, 3fr) "go" auto / minmax(0, 1fr);
    }
    omote-cue-air {
      max-height: 24dvh;
    }
    h1,
    .print,
    .help,
    .step span {
      display: none;
    }
    .notice {
      order: 1;
      flex: 1 0 100%;
    }
  }
  @media print {
    :host {
      display: block;
      height: auto;
      overflow: visible;
      background: #fff;
    }
    header > :not(h1),
    omote-cue-air,
    omote-cue-editor,
    omote-cue-go,
    .form {
      display: none;
    }
    h1 {
      color: #000;
    }
  }
`;
