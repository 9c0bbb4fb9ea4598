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
    min-height: 100dvh;
    padding: 6px 10px 16px;
    background: var(--ground);
    font-size: 14px;
  }
  header {
    display: flex;
    flex-wrap: wrap;
    align-items: center;
    gap: 6px 14px;
    min-height: 48px;
  }
  h1 {
    margin: 0;
    font-size: 15px;
    letter-spacing: 0.14em;
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
  .lost {
    padding: 4px 10px;
    border-radius: 4px;
    font-weight: 700;
    color: #fff;
    background: #c3170a;
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
  .left {
    display: grid;
    gap: 8px;
  }
  .right {
    display: grid;
    gap: 8px;
  }
  figure {
    position: relative;
    margin: 0;
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
    margin: 0;
    font-size: 16px;
    line-height: 1.4;
  }
  .health {
    display: flex;
    flex-wrap: wrap;
    gap: 4px 14px;
    margin: 0;
    padding: 0;
    list-style: none;
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
