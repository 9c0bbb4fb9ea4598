/** The look of the replay page: the picture over all, the line of time below it. */

import { css } from "lit";
import { ellipsis, emptyBar, flow } from "../ui/theme";

export const pageStyle = css`
  :host {
    display: grid;
    grid-template-rows: minmax(0, 1fr) auto;
    height: 100dvh;
    background: #000;
  }
  iframe {
    width: 100%;
    height: 100%;
    border: 0;
  }
  footer {
    display: grid;
    gap: 6px;
    padding: 8px 12px 10px;
    background: var(--panel);
    border-top: 1px solid var(--line);
  }
  .row {
    ${flow}
    gap: 6px 10px;
  }
  button,
  select {
    min-height: 44px;
  }
  button {
    min-width: 44px;
  }
  .play {
    min-width: 88px;
  }
  .time {
    font-variant-numeric: tabular-nums;
    font-size: 18px;
  }
  .said {
    ${ellipsis}
    flex: 1 1 12em;
    color: var(--dim);
  }
  .wrong {
    color: var(--attention);
  }
  .line {
    position: relative;
    height: 44px;
    background: #000;
    border: 1px solid var(--line);
    border-radius: 4px;
    touch-action: none;
    cursor: pointer;
  }
  .line:focus-visible {
    outline: 2px solid var(--focus);
  }
  .played {
    ${emptyBar}
    background: var(--raised);
  }
  .loop {
    position: absolute;
    inset: 0 auto;
    background: #3fd48033;
    border-inline: 2px solid var(--coming);
  }
  .moment {
    position: absolute;
    top: 0;
    bottom: 0;
    width: 2px;
    background: var(--faint);
  }
  .moment.panic {
    background: var(--air);
  }
  .moment.mark_moment {
    background: var(--attention);
  }
  .here {
    position: absolute;
    top: 0;
    bottom: 0;
    width: 2px;
    background: var(--hand);
  }
`;
