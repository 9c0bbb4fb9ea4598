import { css } from "lit";
import { entry, flow } from "../../ui/theme";
import { low, narrow } from "../controls/screen_sizes";

export const padPanelStyle = css`
  :host {
    display: flex;
    flex-direction: column;
    gap: 6px;
    min-width: 0;
    min-height: 0;
    padding: 6px;
    overflow: hidden;
  }
  .head {
    ${flow}
    gap: 6px;
    flex: none;
  }
  .head h2 {
    padding: 0 4px;
  }
  .head button,
  .head select {
    color: var(--text);
  }
  .head .close {
    margin-left: auto;
  }
  .head input {
    ${entry}
    min-height: 28px;
    width: 130px;
  }
  .head form {
    ${flow}
    gap: 6px;
  }
  .head a {
    color: var(--focus);
  }
  .pads {
    flex: 1;
    min-height: 0;
    display: flex;
    gap: 6px;
    overflow: auto hidden;
    container: pads / size;
    overflow-anchor: none; /* a pad that is put first is seen */
    scrollbar-width: thin;
    scrollbar-color: var(--edge) transparent;
  }
  omote-blend-pad,
  omote-pad-editor {
    flex: 0 0 min(100cqw, max(180px, 100cqh - 22px));
    height: 100%;
  }
  omote-pad-editor {
    flex-basis: min(100cqw, max(320px, 100cqh + 214px));
  }
  .star[aria-pressed="true"] {
    color: var(--attention);
    background: none;
    border-color: var(--line);
  }
  .none {
    padding: 12px;
    color: var(--dim);
  }
  @media ${narrow} or ${low} {
    .head h2 {
      display: none;
    }
    .head .close {
      display: none; /* the keys of the views stand below */
    }
  }
  @media ${low} {
    .head .close {
      display: block;
    }
  }
`;
