/** The look of the replay page: the picture over all, the line of time below it. */

import { css } from "lit";
import { ellipsis, emptyBar, entry, flow } from "../ui/theme";

export const pageStyle = css`
  :host {
    display: grid;
    grid-template: minmax(0, 1fr) auto / minmax(0, 1fr);
    height: 100dvh;
    background: #000;
  }
  .picture {
    display: grid;
    grid-template-columns: minmax(0, 1fr) auto;
    min-height: 0;
  }
  aside {
    display: grid;
    grid-template-rows: auto auto auto minmax(0, 1fr);
    width: min(400px, 40vw);
    min-height: 0;
    padding: 8px 12px;
    background: var(--panel);
    border-left: 1px solid var(--line);
  }
  form {
    display: flex;
    gap: 6px;
  }
  input {
    ${entry}
    flex: 1;
    min-height: 44px;
    font-size: 16px;
  }
  omote-note-list {
    grid-row: 4;
    min-height: 0;
    overflow: auto;
  }
  .row a {
    display: grid;
    place-content: center;
    min-height: 44px;
    padding: 0 6px;
    color: var(--focus);
  }
  @media (max-width: 700px) {
    .picture {
      grid-template: minmax(0, 1fr) minmax(0, 1fr) / minmax(0, 1fr);
    }
    .picture iframe:only-child {
      grid-row: 1 / -1;
    }
    aside {
      width: auto;
      border-left: 0;
    }
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
