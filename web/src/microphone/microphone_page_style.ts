/** The look of the microphone page. */

import { css } from "lit";
import { entry, flow } from "../ui/theme";

export const pageStyle = css`
  :host {
    --finger: 44px;
    font-size: 15px;
  }
  main {
    display: grid;
    grid-template-columns: repeat(auto-fit, minmax(min(100%, 420px), 1fr));
    gap: 8px;
    max-width: 1100px;
    margin: 0 auto;
  }
  .panel {
    display: grid;
    align-content: start;
    gap: 12px;
    padding: 14px;
    min-width: 0;
  }
  .wide {
    grid-column: 1 / -1;
  }
  .row {
    ${flow}
    gap: 8px 12px;
    min-width: 0;
  }
  .row > label {
    display: grid;
    gap: 4px;
    flex: 1 1 190px;
    min-width: 0;
    color: var(--dim);
  }
  label.check {
    display: flex;
    align-items: center;
    gap: 10px;
    min-height: 32px;
    color: var(--text);
  }
  select,
  input[type="text"],
  button {
    min-height: 40px;
    min-width: 0;
    max-width: 100%;
  }
  input[type="text"] {
    ${entry}
  }
  button {
    padding: 0 16px;
    color: var(--text);
  }
  .start {
    flex: 2 1 180px;
    min-height: 60px;
    font-size: 18px;
    font-weight: 700;
  }
  .start.on {
    color: #fff;
    background: var(--air-deep);
    border-color: var(--air);
  }
  .talk {
    flex: 2 1 180px;
    min-height: 60px;
    font-size: 16px;
    touch-action: none;
  }
  .talk.on {
    color: var(--ground);
    background: var(--hand);
  }
  .mute {
    flex: 1 1 90px;
    min-height: 60px;
  }
  .meter {
    position: relative;
    height: 26px;
    overflow: hidden;
    background: #000;
    border: 1px solid var(--line);
    border-radius: 4px;
  }
  .meter i {
    position: absolute;
    inset: 0;
    transform-origin: left;
    background: var(--faint);
  }
  .meter.speaks i {
    background: var(--coming);
  }
  .meter.over i {
    background: var(--air);
  }
  .status {
    font-size: 20px;
    font-weight: 600;
    overflow-wrap: anywhere;
  }
  .hint {
    line-height: 1.45;
    color: var(--dim);
  }
  .notice {
    padding: 10px 12px;
    line-height: 1.4;
    color: var(--text);
    background: #2a2108;
    border: 1px solid var(--attention);
    border-radius: 6px;
    overflow-wrap: anywhere;
    user-select: text;
  }
  blockquote {
    padding: 10px 14px;
    font-size: 19px;
    line-height: 1.4;
    background: #000;
    border-left: 3px solid var(--edge);
  }
`;
