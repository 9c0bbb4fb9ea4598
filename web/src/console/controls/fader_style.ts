import { css } from "lit";

/** A handle in its groove below a number: what every upright fader of the console looks like. */
export const faderStyle = css`
  :host {
    display: grid;
    grid-template-rows: 14px minmax(0, 1fr);
    min-width: 34px;
    min-height: 0;
  }
  @media (pointer: coarse) {
    :host {
      min-width: 42px;
    }
  }
  .number {
    font-size: 11px;
    line-height: 14px;
    text-align: center;
    color: var(--faint);
  }
  .slot {
    position: relative;
    margin: 8px 0;
    touch-action: none;
    cursor: ns-resize;
    border-radius: 3px;
  }
  .groove {
    position: absolute;
    left: 50%;
    top: -6px;
    bottom: -6px;
    width: 6px;
    margin-left: -3px;
    border-radius: 3px;
    background: #000;
    border: 1px solid var(--line);
  }
  .carrier {
    position: absolute;
    inset: 0;
    pointer-events: none;
  }
  .carrier::after {
    content: "";
    position: absolute;
    left: 50%;
    width: 26px;
    margin-left: -13px;
    bottom: -7px;
    height: 14px;
    border-radius: 3px;
    border: 1px solid #000;
    background: linear-gradient(#565c64 0 40%, #c9ced4 40% 60%, #33383e 60%);
    box-shadow: 0 1px 3px #000b;
  }
`;

/** What a channel's fader shows besides: ticks, what is on air, what the gaze adds. */
export const channelFaderStyle = css`
  .number.touched {
    color: var(--air);
    font-weight: 700;
  }
  .number.driven {
    color: var(--air);
  }
  .tick {
    position: absolute;
    left: 50%;
    width: 24px;
    margin-left: -12px;
    height: 1px;
    background: var(--edge);
  }
  .fill,
  .gaze {
    position: absolute;
    left: 50%;
    width: 4px;
    margin-left: -2px;
    bottom: 25%;
    height: 100%;
    transform-origin: bottom;
    transform: scaleY(0);
    background: var(--air);
  }
  .gaze {
    width: 2px;
    margin-left: 5px;
    background: var(--dim);
  }
  .carrier.touched::after {
    background: linear-gradient(#6b4a44 0 40%, #fff 40% 60%, #4a2f2a 60%);
    border-color: var(--air);
  }
`;
