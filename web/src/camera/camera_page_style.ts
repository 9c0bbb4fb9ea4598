/** The look of the camera page. */

import { css } from "lit";

/** The button that is to be pressed next, while it can be. */
export const mainButton = css`
  .main:enabled {
    color: var(--ground);
    background: var(--coming);
    border-color: var(--coming);
    font-weight: 700;
  }
`;

export const cameraPageStyle = css`
  :host {
    --finger: 40px;
    padding: 6px 10px 16px;
    font-size: 14px;
  }
  header {
    padding: 4px 0;
  }
  label {
    display: flex;
    align-items: center;
    gap: 6px;
    min-width: 0;
    color: var(--dim);
  }
  select {
    max-width: 240px;
    min-width: 0;
  }
  .online {
    color: var(--coming);
  }
  .waiting {
    color: var(--attention);
  }
  .notice {
    flex: 1 1 220px;
    min-width: 0;
    color: var(--attention);
    overflow-wrap: anywhere;
  }
  main {
    display: grid;
    grid-template-columns: minmax(0, 1fr) minmax(280px, 360px);
    gap: 10px;
    align-items: start;
  }
  .left,
  .right {
    display: grid;
    gap: 8px;
  }
  figure {
    position: relative;
    overflow: hidden;
    display: grid;
    border: 1px solid var(--line);
    border-radius: 6px;
    background: #000;
    aspect-ratio: 4 / 3;
    max-height: calc(100dvh - 130px);
  }
  figure > * {
    grid-area: 1 / 1;
    min-width: 0;
    min-height: 0;
  }
  video,
  canvas {
    width: 100%;
    height: 100%;
    object-fit: contain;
    transform: scaleX(-1);
  }
  /* The face stays seen while the guide says below what it is to do. */
  figure.guided {
    max-height: calc(100dvh - 320px);
  }
  .cover {
    z-index: 2;
    display: grid;
    gap: 12px;
    place-content: center;
    justify-items: center;
    padding: 24px;
    text-align: center;
    background: #08090ae0;
  }
  .cover h2 {
    font-size: 20px;
    letter-spacing: 0;
    text-transform: none;
    color: var(--attention);
  }
  .cover p {
    max-width: 46ch;
    font-size: 16px;
    line-height: 1.4;
  }
  .health {
    display: flex;
    flex-wrap: wrap;
    gap: 4px 14px;
  }
  .good {
    color: var(--coming);
  }
  .bad {
    color: var(--attention);
  }
  .where {
    margin-left: auto;
    color: var(--faint);
  }
  details {
    padding: 10px 12px;
  }
  summary {
    cursor: pointer;
    color: var(--dim);
  }
  .bars {
    display: grid;
    grid-template-columns: auto minmax(60px, 1fr);
    gap: 1px 8px;
    align-items: center;
    margin-top: 8px;
    font-size: 11.5px;
  }
  meter {
    width: 100%;
    height: 9px;
  }
  @media (max-width: 820px) {
    main {
      grid-template-columns: minmax(0, 1fr);
    }
    figure,
    figure.guided {
      max-height: 62dvh;
    }
  }
`;
