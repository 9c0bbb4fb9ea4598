/** How the list of cues looks: on screens as rows, on paper as a running order. */

import { css } from "lit";
import { ellipsis, entry, flow, portrait } from "../../ui/theme";

export const cueListStyle = css`
  :host {
    display: grid;
    grid-template-rows: auto minmax(0, 1fr);
    min-height: 0;
  }
  .head {
    ${flow}
    gap: 6px;
    padding: 6px 8px;
    border-bottom: 1px solid var(--line);
  }
  .head input {
    ${entry}
    flex: 1 1 120px;
    min-height: var(--finger, 32px);
    font-size: 14px;
  }
  ol {
    overflow: auto;
    overscroll-behavior: contain;
    scroll-padding: 120px 0;
    min-height: 0;
  }
  li {
    position: relative;
    display: grid;
    grid-template-columns: 6px 30px minmax(48px, auto) 57px minmax(0, 1fr) auto auto;
    align-items: center;
    gap: 8px;
    min-height: 56px;
    padding-right: 8px;
    border-bottom: 1px solid var(--line);
    cursor: pointer;
    content-visibility: auto;
    contain-intrinsic-height: auto 56px;
  }
  li.current {
    background: linear-gradient(90deg, var(--air-deep), transparent 70%);
  }
  li.standby {
    background: linear-gradient(90deg, var(--coming-deep), transparent 70%);
  }
  li.edited {
    box-shadow: inset 0 0 0 2px var(--hand);
  }
  li.skip :is(.number, .words) {
    opacity: 0.45;
    text-decoration: line-through;
  }
  li.above::before,
  li.below::after {
    content: "";
    position: absolute;
    inset: 0 0 auto;
    height: 3px;
    background: var(--hand);
  }
  li.below::after {
    inset: auto 0 0;
  }
  .colour {
    align-self: stretch;
  }
  .mark {
    font-size: 18px;
    text-align: center;
  }
  .current .mark {
    color: var(--air);
  }
  .standby .mark {
    color: var(--coming);
  }
  .number {
    font-size: 20px;
    font-weight: 700;
    color: var(--hand);
  }
  canvas {
    ${portrait}
    width: 57px;
    height: 53px;
    border-radius: 3px;
  }
  .words {
    min-width: 0;
  }
  .label {
    ${ellipsis}
    display: block;
    font-size: 16px;
    font-weight: 600;
    color: var(--text);
  }
  .note {
    ${ellipsis}
    display: block;
    color: var(--dim);
  }
  .missing {
    display: block;
    color: var(--attention);
    overflow-wrap: anywhere;
  }
  .times {
    display: grid;
    gap: 2px;
    font-size: 12px;
    text-align: right;
    color: var(--dim);
  }
  .times b {
    font-weight: 600;
    color: var(--coming);
  }
  .tools {
    display: flex;
    gap: 4px;
  }
  .tools button {
    min-width: 34px;
    min-height: 34px;
    padding: 0;
    font-size: 15px;
    color: var(--text);
  }
  .handle {
    cursor: grab;
    touch-action: none;
  }
  .moves {
    display: none;
  }
  li.empty {
    display: block;
    padding: 20px;
    cursor: default;
    font-size: 15px;
    color: var(--dim);
  }
  @media (pointer: coarse) {
    :host {
      --finger: 44px;
    }
    .tools button {
      min-width: 44px;
      min-height: 44px;
    }
    .head input {
      font-size: 16px;
    }
  }
  @media (max-width: 900px) {
    .times {
      max-width: 90px;
    }
    .label {
      display: -webkit-box;
      -webkit-box-orient: vertical;
      -webkit-line-clamp: 2;
      white-space: normal;
      overflow-wrap: anywhere;
    }
    :host([editing]) :is(.times, .up, .down) {
      display: none; /* they are in the editor too */
    }
  }
  @media (max-width: 640px) {
    li {
      grid-template-columns: 6px 22px auto minmax(0, 1fr) auto auto;
      gap: 6px;
    }
    canvas {
      display: none;
    }
    .number {
      font-size: 17px;
    }
    .label {
      font-size: 15px;
    }
    .times {
      font-size: 11px;
    }
  }
  @media print {
    :host {
      display: block;
    }
    .head,
    .tools,
    .mark,
    canvas {
      display: none;
    }
    ol {
      overflow: visible;
    }
    li {
      content-visibility: visible;
      grid-template-columns: 6px 16mm minmax(0, 1fr) auto;
      min-height: 0;
      padding: 1.5mm 0;
      break-inside: avoid;
      border-color: #999;
      background: none !important;
      box-shadow: none !important;
      print-color-adjust: exact;
    }
    .number,
    .label,
    .note,
    .times,
    .times b {
      color: #000;
      white-space: normal;
    }
    .moves {
      display: block;
      font-size: 9pt;
      color: #333;
    }
  }
`;
