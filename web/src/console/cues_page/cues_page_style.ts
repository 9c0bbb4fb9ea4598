/** How the cue page is laid out: on a desk beside each other, on a phone below each other, on paper the list alone. */

import { css } from "lit";
import { ellipsis, flow } from "../../ui/theme";

export const cuesPageStyle = css`
  :host {
    display: grid;
    grid-template: "head head" auto "form form" auto "list side" minmax(0, 1fr) "list go" auto / minmax(0, 1fr) 380px;
    gap: 6px;
    min-height: 0;
    height: calc(100dvh - var(--bar, 0px));
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
    display: grid;
    grid-template-columns: minmax(0, 1fr) auto;
    align-items: start;
    gap: 8px;
    padding: 0 4px;
  }
  .bar {
    ${flow}
    gap: 4px 8px;
    min-height: 46px;
  }
  h1 span {
    font-weight: 400;
  }
  nav {
    display: flex;
    gap: 12px;
  }
  .bar button {
    min-height: var(--finger, 36px);
  }
  .bar button:not([aria-pressed="true"]) {
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
    min-height: var(--finger, 32px);
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
  .printed {
    display: none;
  }
  .panic:hover {
    color: var(--attention);
  }
  .panic {
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
  }
  @media (max-width: 1100px) {
    :host,
    :host([editing]) {
      grid-template-columns: minmax(0, 1fr) 340px;
    }
  }
  @media (max-width: 1400px) {
    :host([editing]) .step span {
      display: none;
    }
  }
  @media (max-width: 900px) {
    h1,
    .step span {
      display: none;
    }
    .bar {
      gap: 4px 6px;
    }
  }
  @media (max-width: 720px) {
    :host {
      grid-template: "head" auto "form" auto "side" auto "list" minmax(0, 1fr) "go" auto / minmax(0, 1fr);
      gap: 4px;
      padding: 4px;
    }
    :host([editing]) {
      grid-template: "head" auto "form" auto "side" minmax(0, 1fr) "go" auto / minmax(0, 1fr);
    }
    :host([editing]) omote-cue-list {
      grid-area: side;
    }
    :host([editing]) omote-cue-editor,
    :host([editing][opened]) omote-cue-list {
      display: none;
    }
    :host([editing][opened]) omote-cue-editor {
      display: block;
    }
    omote-cue-air {
      max-height: 24dvh;
    }
    a[target="_blank"],
    .print,
    .help {
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
    .bar > :not(h1, .printed),
    .panic,
    omote-cue-air,
    omote-cue-editor,
    omote-cue-go,
    .form {
      display: none;
    }
    h1,
    .printed {
      display: block;
      color: #000;
    }
    omote-cue-list.panel {
      background: none;
      border: 0;
    }
  }
`;
