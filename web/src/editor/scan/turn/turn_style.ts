import { css } from "lit";
import { flow } from "../../../ui/theme";

export const style = css`
  :host {
    display: grid;
    grid-template-rows: minmax(0, 1fr) auto auto;
    gap: 10px;
    min-height: 0;
    --finger: 40px;
  }
  figure {
    position: relative;
    display: grid;
    min-height: 0;
    overflow: hidden;
    border: 1px solid var(--line);
    border-radius: 5px;
    background: #000;
  }
  figure > * {
    grid-area: 1 / 1;
    min-width: 0;
    min-height: 0;
  }
  video,
  figure > canvas {
    width: 100%;
    height: 100%;
    object-fit: contain;
    transform: scaleX(-1);
  }
  figure > canvas {
    opacity: 0.75;
  }
  .cover {
    z-index: 1;
    display: grid;
    gap: 10px;
    place-content: center;
    justify-items: center;
    padding: 20px;
    text-align: center;
    background: #08090ae0;
  }
  .cover.loading {
    align-content: end;
    background: linear-gradient(#08090a00 60%, #08090ae0);
  }
  .cover h2 {
    font-size: 16px;
    letter-spacing: 0;
    text-transform: none;
    color: var(--attention);
  }
  .cover p {
    max-width: 46ch;
    font-size: 14px;
    line-height: 1.4;
    color: var(--text);
  }
  .cover progress {
    width: min(320px, 60vw);
    height: 8px;
  }
  .guide {
    display: grid;
    grid-template-columns: auto minmax(0, 1fr);
    align-items: center;
    gap: 8px 18px;
  }
  ol {
    display: flex;
    gap: 10px;
  }
  li {
    display: grid;
    justify-items: center;
    gap: 3px;
    width: 66px;
    font-size: 11.5px;
    color: var(--dim);
    white-space: nowrap;
  }
  .ring {
    display: grid;
    width: 62px;
    height: 62px;
    padding: 4px;
    border-radius: 50%;
    background: conic-gradient(var(--coming) calc(var(--share) * 1turn), var(--edge) 0);
  }
  .here .ring {
    outline: 2px solid var(--hand);
    outline-offset: 1px;
  }
  .here,
  .done {
    color: var(--text);
  }
  .ring > * {
    grid-area: 1 / 1;
    width: 100%;
    height: 100%;
    border-radius: 50%;
  }
  .ring svg {
    background: var(--panel);
    fill: none;
    stroke: var(--dim);
    stroke-width: 1.4;
  }
  .sentence {
    font-size: clamp(16px, 2vw, 22px);
    line-height: 1.2;
    min-height: 2.4em;
    display: grid;
    align-content: center;
    color: var(--text);
  }
  .sentence.faulty {
    color: var(--attention);
  }
  .acts {
    ${flow}
    gap: 6px;
  }
  .acts .note {
    flex: 1;
    min-width: 300px;
    max-width: 110ch;
    margin-left: 12px;
  }
  .acts label {
    display: flex;
    align-items: center;
    gap: 6px;
    min-width: 0;
  }
  select {
    max-width: 220px;
    min-width: 0;
  }
  @media (max-width: 940px) {
    .guide {
      grid-template-columns: minmax(0, 1fr);
      justify-items: center;
      text-align: center;
    }
    ol {
      gap: 4px;
    }
    li {
      width: 64px;
    }
    video,
    figure > canvas {
      object-fit: cover; /* a tall window shows the middle of a wide picture */
    }
    .acts .note {
      order: -1;
      flex: 1 0 100%;
      margin: 0;
      min-width: 0;
    }
    .acts button {
      flex: 1;
    }
    .acts label {
      flex: 1 0 100%;
    }
  }
`;
