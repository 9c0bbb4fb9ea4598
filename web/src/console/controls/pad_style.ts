import { type CSSResult, css } from "lit";
import { low, narrow, short } from "./screen_sizes";

/** Keys right of the field of these pads, where there is no height for them above it. */
const beside = (pads: CSSResult): CSSResult => css`
  ${pads} {
    display: grid;
    grid-template: minmax(0, 1fr) auto / minmax(0, 1fr) 52px;
  }
  ${pads} header {
    grid-area: 1 / 2;
    flex-direction: column;
    justify-content: center;
  }
  ${pads} header button {
    width: 100%;
    padding: 0;
  }
  ${pads} h2 {
    display: none; /* the figure says it */
  }
  ${pads} .well {
    grid-area: 1 / 1;
  }
  ${pads} .tilt {
    grid-area: 2 / 1 / 3 / 3;
  }
`;

export const style = css`
  :host {
    display: flex;
    flex-direction: column;
    gap: 6px;
    padding: 8px;
    min-height: 0;
  }
  header {
    display: flex;
    align-items: center;
    gap: 4px;
  }
  h2 {
    flex: 1;
  }
  header button {
    padding: 0 6px;
    font-size: 11px;
  }
  @media (pointer: fine) {
    header button {
      min-height: 22px;
    }
  }
  .well {
    flex: 1;
    min-height: 0;
    display: grid;
    place-items: center;
    container-type: size;
  }
  .field {
    position: relative;
    width: min(100cqw, 100cqh);
    height: min(100cqw, 100cqh);
    border-radius: 6px;
    border: 1px solid var(--line);
    background:
      linear-gradient(var(--line), var(--line)) 50% 0 / 1px 100% no-repeat,
      linear-gradient(var(--line), var(--line)) 0 50% / 100% 1px no-repeat, #000;
    touch-action: none;
    cursor: crosshair;
    overflow: hidden;
  }
  svg {
    position: absolute;
    inset: 0;
    width: 100%;
    height: 100%;
    fill: none;
    stroke: #4a5059;
    stroke-width: 1.6;
    pointer-events: none;
  }
  .carrier {
    position: absolute;
    inset: 0;
    pointer-events: none;
  }
  .dot::after {
    content: "";
    position: absolute;
    left: 50%;
    top: 50%;
    width: 20px;
    height: 20px;
    margin: -10px;
    border-radius: 50%;
    border: 2px solid var(--hand);
    background: #ffffff26;
    box-shadow: 0 0 0 2px #000;
  }
  .mark::after {
    content: "";
    position: absolute;
    left: 50%;
    top: 50%;
    width: 10px;
    height: 10px;
    margin: -5px;
    border-radius: 50%;
    background: var(--air);
    box-shadow: 0 0 0 2px #000;
  }
  .dot.air::after {
    border-color: var(--air);
    background: #ff5a4540;
  }
  .side {
    position: absolute;
    top: 50%;
    margin-top: -7px;
    font-size: 10px;
    line-height: 14px;
    color: var(--faint);
    background: #000;
    padding: 0 3px;
    pointer-events: none;
  }
  .tilt {
    position: relative;
    height: 22px;
    margin: 0 12px;
    touch-action: none;
    cursor: ew-resize;
  }
  .tilt::before {
    content: "";
    position: absolute;
    left: -12px;
    right: -12px;
    top: 8px;
    height: 6px;
    border-radius: 3px;
    background: linear-gradient(var(--edge), var(--edge)) 50% 0 / 1px 100% no-repeat, #000;
    border: 1px solid var(--line);
  }
  .knob::after {
    content: "";
    position: absolute;
    left: 50%;
    top: 3px;
    width: 16px;
    height: 16px;
    margin-left: -8px;
    border-radius: 4px;
    border: 1px solid #000;
    background: linear-gradient(90deg, #565c64 0 40%, #c9ced4 40% 60%, #33383e 60%);
  }
  .read {
    position: absolute;
    left: 5px;
    bottom: 3px;
    font-size: 11px;
    color: var(--dim);
    pointer-events: none;
  }
  @media (pointer: coarse) {
    .tilt {
      height: 40px;
    }
    .tilt::before {
      top: 17px;
    }
    .knob::after {
      top: 12px;
    }
  }
  @media (max-width: 1100px) {
    header {
      gap: 2px;
    }
    header button {
      padding: 0 4px;
    }
    h2 {
      letter-spacing: 0.04em;
    }
  }
  @media ${short} {
    :host {
      gap: 4px;
      padding: 6px;
    }
  }
  @media ${narrow} and (max-height: 600px) {
    ${beside(css`:host`)}
  }
  @media (${low}) and (orientation: landscape) {
    ${beside(css`:host([low])`)}
  }
`;
