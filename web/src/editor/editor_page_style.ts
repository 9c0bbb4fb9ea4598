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
  omote-item-list {
    grid-area: library;
  }
  main {
    grid-area: main;
    display: grid;
    grid-template-rows: auto minmax(0, 1fr) auto;
    min-width: 0;
    min-height: 0;
  }
  .side {
    grid-area: panels;
    display: flex;
    flex-direction: column;
    min-height: 0;
  }
  omote-panels {
    flex: 1;
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
  /* Under the panels, which make room: nothing is hidden, and the faces keep their size. */
  .told {
    flex: none;
    max-height: 45dvh;
    overflow: hidden auto;
    scrollbar-width: thin;
    scrollbar-color: var(--edge) transparent;
  }
  .told > * {
    margin-top: 6px;
  }
  :host(.lost) {
    box-shadow: inset 0 0 0 4px #d21f10;
  }
  @media (max-width: 1180px) {
    :host {
      grid-template-columns: 196px minmax(420px, 1fr) 262px;
    }
    .hint {
      min-height: 46px; /* two lines, so that no tool makes the faces jump */
    }
  }
  @media (max-width: 940px) {
    .side {
      display: contents;
    }
    omote-panels {
      grid-area: panels;
    }
    .told {
      position: fixed;
      left: 6px;
      right: 6px;
      bottom: 6px;
      z-index: 4;
    }
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
    omote-item-list {
      max-height: 520px;
    }
  }
`;
