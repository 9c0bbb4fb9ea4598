import { css } from "lit";
import { narrow, short } from "./screen_sizes";

export const style = css`
  :host {
    display: grid;
    grid-template-rows: auto auto 1fr auto auto auto;
    gap: 4px;
    padding: 8px 6px;
    min-height: 0;
    text-align: center;
  }
  h2 {
    letter-spacing: 0.08em;
  }
  .end {
    white-space: pre-line;
    overflow-wrap: anywhere;
    font-size: 12px;
    font-weight: 600;
    line-height: 15px;
    min-height: 18px;
    color: var(--faint);
    border-radius: 3px;
  }
  .end.air {
    color: var(--air);
  }
  .end.coming {
    color: var(--coming);
  }
  .track {
    position: relative;
    min-height: 80px;
    margin: 16px 0;
    touch-action: none;
    cursor: grab;
    border-radius: 4px;
  }
  .track:active {
    cursor: grabbing;
  }
  .slot {
    position: absolute;
    left: 50%;
    top: -14px;
    bottom: -14px;
    width: 14px;
    margin-left: -7px;
    border-radius: 7px;
    background: #000;
    border: 1px solid var(--line);
  }
  .ticks {
    position: absolute;
    inset: 0 4px;
    background: repeating-linear-gradient(to top, var(--line) 0 1px, transparent 1px 10%);
    border-top: 1px solid var(--line);
    opacity: 0.9;
  }
  .column {
    position: absolute;
    left: 50%;
    width: 8px;
    margin-left: -4px;
    top: 0;
    bottom: 0;
    border-radius: 4px;
    transform-origin: bottom;
    transform: scaleY(0);
    background: var(--coming);
  }
  .column.flipped {
    transform-origin: top;
  }
  .carrier {
    position: absolute;
    inset: 0;
    pointer-events: none;
    will-change: transform;
  }
  .value::after {
    content: "";
    position: absolute;
    left: 2px;
    right: 2px;
    bottom: -1px;
    height: 2px;
    background: var(--coming);
    opacity: 0;
  }
  .value.shown::after {
    opacity: 1;
  }
  .hand::after {
    content: "";
    position: absolute;
    left: 6px;
    right: 6px;
    bottom: -15px;
    height: 30px;
    border-radius: 5px;
    border: 1px solid #000;
    background: linear-gradient(
      #4a5058 0,
      #33383e 44%,
      var(--hand) 44%,
      var(--hand) 56%,
      #2b3035 56%,
      #22262b 100%
    );
    box-shadow:
      0 2px 6px #000c,
      inset 0 1px 0 #ffffff2b;
  }
  .hand.ghost::after {
    background: linear-gradient(transparent 46%, var(--attention) 46% 54%, transparent 54%);
    border: 1.5px dashed var(--attention);
    box-shadow: none;
  }
  .hand.held::after {
    border-color: var(--hand);
    box-shadow: 0 0 0 1px var(--hand);
  }
  .way {
    transform-origin: bottom;
  }
  .way::after {
    content: "";
    position: absolute;
    left: 18%;
    bottom: 0;
    height: 100%;
    border-left: 2px dotted var(--attention);
    margin-left: -1px;
    opacity: 0;
  }
  .way.shown::after {
    opacity: 1;
  }
  .percent {
    font-size: 20px;
    font-weight: 600;
    line-height: 22px;
    color: var(--text);
  }
  .mode {
    font-size: 11px;
    line-height: 14px;
    min-height: 28px;
    color: var(--dim);
  }
  .mode.attention {
    color: var(--attention);
  }
  .release {
    width: 100%;
    padding: 0;
  }
  .release.lit {
    color: var(--hand);
    border-color: var(--hand);
  }
  @media ${short} {
    :host {
      gap: 2px;
      padding: 4px;
    }
    .track {
      margin: 15px 0;
      min-height: 40px;
    }
    .mode {
      min-height: 14px;
    }
    .percent {
      font-size: 16px;
      line-height: 18px;
    }
    .end {
      max-height: 30px;
      overflow: hidden;
    }
  }
  @media ${narrow} {
    .mode {
      min-height: 0;
    }
    .mode:not(.attention) {
      display: none; /* the call beside the picture says it */
    }
  }
  @media (max-height: 600px) or (${narrow} and (max-height: 700px)) {
    :host {
      grid-template-rows: auto 1fr auto auto auto;
    }
    h2 {
      display: none; /* faces are called on the left */
    }
    .end {
      max-height: 15px;
      min-height: 15px;
    }
  }
`;
