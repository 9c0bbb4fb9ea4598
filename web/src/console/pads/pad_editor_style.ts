import { css } from "lit";
import { entry } from "../../ui/theme";

export const padEditorStyle = css`
  :host {
    border-color: var(--attention);
  }
  .body {
    flex: 1;
    min-height: 0;
    display: grid;
    grid-template-columns: minmax(0, 1fr) 232px;
    gap: 6px;
  }
  .look {
    pointer-events: auto;
    cursor: grab;
    touch-action: none;
  }
  .look.chosen canvas {
    border-color: var(--attention);
  }
  .field.over {
    outline: 3px dashed var(--coming);
    outline-offset: -3px;
  }
  .dot {
    opacity: 0.6;
  }
  .tools {
    display: grid;
    grid-template-columns: repeat(6, minmax(0, 1fr)); /* all of them in sight in a panel as low as 180 px */
    align-content: start;
    gap: 4px;
    min-height: 0;
    overflow: hidden auto;
    scrollbar-width: thin;
    scrollbar-color: var(--edge) transparent;
  }
  .tools > * {
    grid-column: span 2;
  }
  .tools > :is(.half, .search) {
    grid-column: span 3;
  }
  .tools > :is(.whole, input) {
    grid-column: 1 / -1;
  }
  .tools button {
    min-width: 0;
    padding: 0 4px;
    color: var(--text);
    font-size: 12px;
  }
  input {
    ${entry}
    width: 100%;
    min-height: 28px;
  }
  .note {
    margin: 0;
    color: var(--dim);
    font-size: 12px;
    overflow-wrap: anywhere;
  }
  .note:empty {
    display: none;
  }
  .note.wrong {
    color: var(--attention);
  }
  .search {
    position: relative;
    display: grid;
    gap: 2px;
  }
  .found button {
    display: block;
    width: 100%;
    overflow: hidden;
    text-align: left;
    text-overflow: ellipsis;
    white-space: nowrap;
  }
  .found button.first {
    border-color: var(--hand);
  }
  .hint {
    position: absolute;
    inset: auto 8px 8px;
    padding: 4px 8px;
    border-radius: 4px;
    text-align: center;
    color: var(--attention);
    background: #000c;
    pointer-events: none;
  }
  @container pads (max-width: 480px) {
    .body {
      grid-template-columns: minmax(0, 1fr) 112px;
    }
    .tools > * {
      grid-column: span 3;
    }
    .tools > :is(.half, .search) {
      grid-column: 1 / -1;
    }
  }
`;
