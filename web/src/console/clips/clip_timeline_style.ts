/** How the time line of a clip looks: on a desk the controls of a lane stand left of its curve, on a phone above it. */

import { css } from "lit";
import { ellipsis, entry, flow } from "../../ui/theme";

export const clipTimelineStyle = css`
  :host {
    --head: 288px;
    position: relative;
    min-height: 0;
    min-width: 0;
    overflow: hidden;
    display: grid;
  }
  .scroll {
    overflow: auto;
    overscroll-behavior: contain;
    scrollbar-color: var(--edge) transparent;
  }
  .content {
    position: relative;
    min-height: 100%;
    width: max-content;
  }
  .row {
    display: grid;
    grid-template-columns: var(--head) var(--length);
    border-bottom: 1px solid var(--line);
  }
  .head {
    position: sticky;
    left: 0;
    z-index: 3;
    ${flow}
    align-content: center;
    gap: 4px;
    padding: 5px 8px;
    background: var(--panel);
    border-right: 1px solid var(--line);
  }
  .ruler-row {
    position: sticky;
    top: 0;
    z-index: 4;
    background: var(--panel);
  }
  .ruler-row .head {
    z-index: 5;
  }
  .ruler,
  .body {
    position: relative;
    overflow: hidden;
    touch-action: pan-y;
    cursor: text;
  }
  .ruler {
    min-height: 52px;
    cursor: pointer;
  }
  .mark {
    position: absolute;
    top: 0;
    padding-left: 4px;
    font-size: 11px;
    line-height: 18px;
    color: var(--dim);
    border-left: 1px solid var(--edge);
    pointer-events: none;
  }
  .trim {
    position: absolute;
    top: 20px;
    bottom: 4px;
    background: #22303f;
    border: 1px solid #4a6a8a;
    pointer-events: none;
  }
  .trim svg {
    position: absolute;
    inset: 0;
    width: 100%;
    height: 100%;
  }
  .trim path {
    fill: none;
    stroke: var(--focus);
    stroke-width: 2;
    vector-effect: non-scaling-stroke;
  }
  .handle {
    position: absolute;
    top: 18px;
    bottom: 2px;
    z-index: 1;
    width: 14px;
    margin-left: -7px;
    border: 3px solid var(--focus);
    background: #0008;
    cursor: ew-resize;
    touch-action: none;
  }
  .handle.from {
    margin-left: 0;
    border-right: 0;
  }
  .handle.to {
    margin-left: -14px;
    border-left: 0;
  }
  .name {
    ${entry}
    flex: 1 1 80px;
    min-height: var(--finger, 28px);
    font-size: 14px;
  }
  .number {
    min-width: 14px;
    color: var(--dim);
  }
  .head button {
    min-height: var(--finger, 28px);
    padding: 0 7px;
    color: var(--text);
  }
  .mute[aria-pressed="true"] {
    color: #1c1500;
    background: var(--attention);
    border-color: var(--attention);
  }
  .line {
    ${flow}
    flex: 1 0 100%;
    flex-wrap: nowrap;
    gap: 3px;
  }
  .line label {
    ${flow}
    flex-wrap: nowrap;
    gap: 4px;
    color: var(--dim);
    font-size: 12px;
  }
  .line input[type="range"] {
    width: 84px;
    min-height: var(--finger, 24px);
  }
  .line .seconds {
    ${entry}
    width: 58px;
    padding: 0 4px;
    min-height: var(--finger, 28px);
    text-align: right;
  }
  .parts button {
    flex: 1 1 0;
    min-width: 0;
    padding: 0;
    font-size: 11.5px;
    color: var(--faint);
  }
  .parts button[aria-pressed="true"] {
    color: var(--text);
    background: #2b3442;
    border-color: #4a6a8a;
  }
  .lane.chosen .head {
    box-shadow: inset 4px 0 var(--hand);
  }
  .lane.chosen .body {
    background: #15191e;
  }
  .body {
    min-height: 92px;
  }
  .block {
    position: absolute;
    top: 6px;
    bottom: 6px;
    border: 1px solid #4a6a8a;
    border-radius: 4px;
    background: #18222e;
    overflow: hidden;
  }
  .lane.muted .block {
    opacity: 0.4;
  }
  .strip {
    ${ellipsis}
    height: var(--strip, 20px);
    padding: 0 6px;
    font-size: 11px;
    line-height: var(--strip, 20px);
    color: #d7e6f7;
    background: #2d4661;
    cursor: grab;
    touch-action: none;
  }
  .block svg {
    position: absolute;
    inset: var(--strip, 20px) 0 0;
    width: 100%;
    height: calc(100% - var(--strip, 20px));
    pointer-events: none;
  }
  .block path {
    fill: none;
    stroke-width: 1.5;
    vector-effect: non-scaling-stroke;
  }
  .body.heard {
    min-height: 64px;
  }
  .block path.wave {
    fill: #7fa8c9;
  }
  .block .again {
    position: absolute;
    top: var(--strip, 20px);
    bottom: 0;
    background: #ffc53d26;
    border-inline: 1px solid #ffc53d88;
    pointer-events: none;
  }
  .moved {
    position: absolute;
    left: 6px;
    top: calc(var(--strip, 20px) + 1px);
    right: 2px;
    ${ellipsis}
    font-size: 11px;
    pointer-events: none;
  }
  .span {
    position: absolute;
    top: 0;
    bottom: 0;
    background: #86b9ff33;
    border-inline: 1px solid var(--focus);
    pointer-events: none;
  }
  .recording {
    border-color: #ff6a5a;
    background: #6e1c13;
    transform-origin: left;
  }
  .playhead,
  .cursor {
    position: absolute;
    top: 18px;
    bottom: 0;
    left: var(--head);
    z-index: 2;
    width: 2px;
    margin-left: -1px;
    background: var(--air);
    pointer-events: none;
  }
  .cursor {
    width: 1px;
    background: var(--dim);
  }
  .playhead.recording-now {
    width: 4px;
    background: #ff2b14;
  }
  .none {
    position: sticky;
    left: 0;
    width: var(--view);
    padding: 24px;
    color: var(--dim);
    font-size: 15px;
  }
  @media (pointer: coarse) {
    :host {
      --finger: 44px;
      --strip: 30px;
      --head: 318px;
    }
    .lane:not(.chosen) .more {
      display: none;
    }
    .line input[type="range"] {
      width: 60px;
    }
    .line .seconds {
      width: 52px;
    }
    .handle {
      width: 28px;
    }
    .handle.to {
      margin-left: -28px;
    }
    .ruler {
      min-height: 60px;
    }
  }
  @media (max-width: 899px) {
    :host {
      --head: 0px;
    }
    .row {
      grid-template-columns: var(--length);
    }
    .head {
      width: var(--view);
      border-right: 0;
    }
    .lane:not(.chosen) .more {
      display: none;
    }
    .playhead,
    .cursor {
      top: 0;
      z-index: 2;
    }
    .body {
      min-height: 84px;
    }
  }
`;
