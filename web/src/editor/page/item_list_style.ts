import { css } from "lit";
import { caption, ellipsis, portrait } from "../../ui/theme";

export const style = css`
  :host {
    display: grid;
    grid-template: auto auto auto minmax(0, 1fr) / minmax(0, 1fr);
    align-content: start;
    gap: 8px;
    padding: 8px;
    min-height: 0;
  }
  .tabs {
    display: grid;
    grid-template-columns: repeat(3, auto);
    gap: 2px;
  }
  .tabs button[aria-selected="true"] {
    background: var(--raised);
    color: var(--text);
    border-color: var(--edge);
  }
  .list {
    grid-row: 4;
    display: grid;
    grid-template-columns: minmax(0, 1fr);
    align-content: start;
    gap: 8px;
    min-height: 0;
    overflow: hidden auto;
    scrollbar-width: thin;
    scrollbar-color: var(--edge) transparent;
  }
  header {
    display: flex;
    align-items: center;
    min-height: 22px;
  }
  ul {
    display: grid;
    gap: 4px;
  }
  .item {
    position: relative;
    border: 1px solid var(--line);
    border-radius: 5px;
    background: var(--raised);
  }
  .item.open {
    border-color: var(--hand);
  }
  .picture {
    display: grid;
    grid-template-columns: 65px 1fr;
    align-items: center;
    gap: 8px;
    width: 100%;
    padding: 3px;
    text-align: left;
    border: 0;
    background: none;
  }
  .picture canvas {
    width: 65px;
    height: 60px;
    border-radius: 3px;
    ${portrait}
  }
  .text {
    display: grid;
    gap: 2px;
    min-width: 0;
    padding-bottom: 18px;
  }
  .text b {
    color: var(--text);
    font-weight: 600;
    ${ellipsis}
  }
  .text small {
    color: var(--faint);
    font-size: 11px;
    ${ellipsis}
  }
  .text .unsaved {
    color: var(--attention);
  }
  .naming {
    position: absolute;
    left: 74px;
    right: 4px;
    top: 4px;
  }
  .acts {
    position: absolute;
    right: 2px;
    bottom: 1px;
    display: flex;
    opacity: 0;
  }
  .acts .icon {
    min-height: 24px;
    min-width: 26px;
  }
  .item:hover .acts,
  .item:focus-within .acts,
  .item.open .acts {
    opacity: 1;
  }
  @media (max-width: 1180px) {
    .acts .icon {
      min-width: 22px;
    }
  }
  @media (pointer: coarse) {
    .acts {
      position: static;
      opacity: 1;
    }
    .acts .icon {
      min-height: 40px;
      min-width: 40px;
    }
    .text {
      padding-bottom: 0;
    }
  }
  .tiles {
    display: grid;
    grid-template-columns: repeat(auto-fill, minmax(72px, 1fr));
    gap: 5px;
  }
  .tile {
    padding: 0;
    overflow: hidden;
    background: #000;
  }
  .tile canvas {
    display: block;
    width: 100%;
    aspect-ratio: 13 / 12;
    ${portrait}
  }
  .tile span {
    ${caption}
  }
  @media (max-width: 1180px) and (min-width: 941px) {
    .tiles {
      grid-template-columns: repeat(3, minmax(0, 1fr));
    }
  }
  @media (max-width: 1180px) {
    .tile span {
      font-size: 10.5px;
      letter-spacing: -0.03em; /* "Contempt" is one word */
    }
  }
`;
