import { css } from "lit";

export const style = css`
  :host {
    position: relative;
    min-width: 0;
    min-height: 0;
    overflow: hidden;
  }
  canvas {
    position: absolute;
    inset: 0;
    width: 100%;
    height: 100%;
    touch-action: none;
    cursor: crosshair;
  }
  canvas:focus-visible {
    outline-offset: -2px;
  }
  svg,
  .names {
    position: absolute;
    inset: 0;
    width: 100%;
    height: 100%;
    pointer-events: none;
  }
  span {
    position: absolute;
    padding: 2px 6px;
    font-size: 11.5px;
    color: var(--dim);
  }
  .active {
    color: var(--hand);
  }
  circle {
    fill: #0008;
    stroke: var(--hand);
    stroke-width: 2;
  }
  .found circle {
    stroke-dasharray: 3 3;
    stroke: var(--attention);
  }
  .chosen circle {
    fill: var(--coming);
  }
  .hidden {
    opacity: 0.3;
  }
  text {
    font-size: 11px;
    font-weight: 700;
    fill: var(--hand);
    text-anchor: middle;
    paint-order: stroke;
    stroke: #000c;
    stroke-width: 3px;
  }
  .found text {
    fill: var(--attention);
  }
`;
