import { css } from "lit";

export const style = css`
  :host {
    height: 100dvh;
    background: var(--ground);
    display: grid;
    gap: 6px;
    padding: 6px;
    grid-template:
      "heading heading heading" 50px
      "library main panels" minmax(0, 1fr) /
      minmax(220px, 250px) minmax(420px, 1fr) minmax(270px, 310px);
    overflow: hidden;
  }
  omote-heading {
    grid-area: heading;
  }
  omote-library {
    grid-area: library;
  }
  main {
    grid-area: main;
    display: grid;
    grid-template-rows: auto minmax(0, 1fr) auto;
    min-width: 0;
    min-height: 0;
  }
  omote-panels {
    grid-area: panels;
  }
  .work {
    position: relative;
    min-height: 0;
    overflow: hidden;
    background: #000;
  }
  .work canvas {
    position: absolute;
    inset: 0;
    width: 100%;
    height: 100%;
    display: block;
    touch-action: none;
  }
  .work canvas:focus-visible {
    outline-offset: -2px;
  }
  .hint {
    max-width: none;
    padding: 7px 12px;
    font-size: 12.5px;
    min-height: 30px;
    color: var(--dim);
  }
  .welcome {
    position: absolute;
    left: 16px;
    bottom: 16px;
    max-width: 340px;
    padding: 14px 18px;
    background: #0f1113e6;
  }
  .welcome ol {
    margin: 0;
    padding: 0 0 0 18px;
    display: grid;
    gap: 10px;
    color: var(--dim);
    font-size: 14px;
  }
  .welcome b {
    color: var(--text);
  }
  .welcome .row {
    margin-top: 6px;
  }
  .looking {
    position: absolute;
    left: 50%;
    top: 10px;
    transform: translateX(-50%);
    display: flex;
    align-items: center;
    gap: 10px;
    padding: 6px 6px 6px 14px;
    border-radius: 6px;
    color: var(--attention);
    background: #2a2108;
    border: 1px solid var(--attention);
    white-space: nowrap;
  }
  omote-notices {
    position: absolute;
    left: 10px;
    right: 10px;
    bottom: 10px;
    z-index: 4;
  }
  :host(.lost) {
    box-shadow: inset 0 0 0 4px #d21f10;
  }
  @media (max-width: 940px) {
    :host {
      height: auto;
      min-height: 100dvh;
      overflow: visible;
      grid-template:
        "heading" auto
        "main" minmax(480px, 72dvh)
        "panels" auto
        "library" auto / minmax(0, 1fr);
    }
    omote-library {
      max-height: 520px;
    }
  }
`;
