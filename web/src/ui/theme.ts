/**
 * The look of an instrument for a dark room. Colours carry meaning, as on a video mixer: red is on air, green is
 * coming, white is the operator's hand, yellow wants attention; all else is grey.
 */

import { css } from "lit";

export const palette = css`
  :host {
    --ground: #08090a;
    --panel: #0f1113;
    --raised: #181b1f;
    --line: #262a30;
    --edge: #3a4048;
    --text: #d9dce0;
    --dim: #929aa4;
    --faint: #7f8791;
    --air: #ff5a45;
    --air-deep: #6e1c13;
    --coming: #3fd480;
    --coming-deep: #124a2c;
    --hand: #f4f6f8;
    --attention: #ffc53d;
    --focus: #86b9ff;
    --unit: 34px;
  }
`;

/** The declarations of what says that a page is not on air: no colour of the instrument, in stripes. */
export const previewColours = css`
  color: #fff;
  background: repeating-linear-gradient(135deg, #4a35c4 0 14px, #3b29a3 14px 28px);
  font: 600 14px/1.2 system-ui, sans-serif;
`;

/** The declarations of words that can be marked and copied. */
export const selectable = css`
  user-select: text;
  -webkit-user-select: text;
`;

/** The declarations of things beside each other, in as many lines as they need. */
export const flow = css`
  display: flex;
  flex-wrap: wrap;
  align-items: center;
`;

/** The declarations of a bar over all of what it measures, from the left: empty. */
export const emptyBar = css`
  position: absolute;
  inset: 0;
  transform-origin: left;
  transform: scaleX(0);
`;

/** The declarations of a field for text. */
export const entry = css`
  font: inherit;
  min-width: 0;
  padding: 0 8px;
  color: var(--text);
  background: #000;
  border: 1px solid var(--line);
  border-radius: 4px;
  ${selectable}
`;

/** The declarations of the box of a notice: words, and beside them what dismisses it. */
export const notice = css`
  display: grid;
  grid-template-columns: minmax(0, 1fr) auto;
  gap: 6px;
  border-radius: 6px;
  color: var(--text);
  box-shadow: 0 6px 24px #000a;
  overflow-wrap: anywhere;
  ${selectable}
`;

/** The declarations of the box of a notice that wants attention. */
export const wanted = css`
  background: #2a2108;
  border: 1px solid var(--attention);
`;

/** The declarations of a picture of a face that has not come yet: the ground of one, and a head that is not there. */
export const portrait = css`
  background:
    radial-gradient(ellipse 17% 30% at 50% 42%, #23272c 97%, transparent),
    radial-gradient(ellipse 34% 26% at 50% 104%, #23272c 97%, transparent),
    #0c0d0f;
`;

/** The declarations of the name under a tile's picture. */
export const caption = css`
  display: grid;
  place-content: safe center center;
  min-height: 19px;
  max-height: 37px; /* three lines to its very edge: a name of one long word would cover the tiles below */
  padding: 1px 2px 3px;
  overflow: hidden;
  font-size: 11.5px;
  line-height: 12px;
  text-align: center;
  overflow-wrap: anywhere;
  color: var(--text);
  background: var(--raised);
`;

/** Controls beside each other, in as many lines as they need. */
export const row = css`
  .row {
    ${flow}
    gap: 6px;
  }
`;

/** The declarations of words that end in dots where there is no room. */
export const ellipsis = css`
  overflow: hidden;
  text-overflow: ellipsis;
  white-space: nowrap;
`;

/** A page of a tool: a head with its name over what it is for. */
export const toolPage = css`
  :host {
    min-height: 100dvh;
    padding: 6px;
    background: var(--ground);
  }
  header {
    ${flow}
    gap: 4px 14px;
    min-height: 50px;
    padding: 4px 10px;
  }
  h1 {
    margin: 0;
    font-size: 15px;
    letter-spacing: 0.14em;
  }
  a {
    color: var(--focus);
  }
  .lost {
    padding: 4px 10px;
    border-radius: 4px;
    font-weight: 700;
    color: #fff;
    background: #c3170a;
  }
`;

/** The declarations of the thin bar at the lower edge of what it measures. */
export const thinBar = css`
  ${emptyBar}
  inset: auto 0 0;
  height: 3px;
`;

export const base = css`
  :host {
    box-sizing: border-box;
    display: block;
    color: var(--text);
    font:
      13px / 1.25 "Inter",
      "Segoe UI",
      "Roboto",
      "Helvetica Neue",
      "DejaVu Sans Condensed",
      "DejaVu Sans",
      sans-serif;
    font-stretch: condensed;
    font-variant-numeric: tabular-nums;
    -webkit-user-select: none;
    user-select: none;
    -webkit-tap-highlight-color: transparent;
  }
  :host([hidden]) {
    display: none;
  }
  *,
  *::before,
  *::after {
    box-sizing: border-box;
  }
  :focus {
    outline: none;
  }
  :focus-visible {
    outline: 2px solid var(--focus);
    outline-offset: 1px;
  }
  :is(h2, p, ul, ol, dd, figure, blockquote) {
    margin: 0;
  }
  ul,
  ol {
    padding: 0;
    list-style: none;
  }
  input[type="range"] {
    min-width: 0;
    margin: 0;
    accent-color: var(--hand);
  }
  h2 {
    font-size: 11px;
    font-weight: 600;
    letter-spacing: 0.12em;
    text-transform: uppercase;
    color: var(--dim);
  }
  button {
    font: inherit;
    color: var(--dim);
    background: var(--raised);
    border: 1px solid var(--line);
    border-radius: 4px;
    padding: 0 8px;
    min-height: 26px;
    cursor: pointer;
    touch-action: manipulation;
  }
  @media (hover: hover) {
    button:hover {
      color: var(--text);
      border-color: var(--edge);
    }
  }
  button:active {
    background: #22262b;
  }
  button[aria-pressed="true"],
  button[aria-checked="true"],
  button[aria-selected="true"] {
    color: var(--ground);
    background: var(--text);
    border-color: var(--text);
  }
  button:disabled {
    opacity: 0.35;
    cursor: default;
  }
  select {
    font: inherit;
    color: var(--text);
    background: #000;
    border: 1px solid var(--line);
    border-radius: 4px;
    padding: 0 4px;
    min-height: 26px;
  }
  @media (pointer: coarse) {
    button,
    select,
    input:not([type="checkbox"], [type="radio"], [type="range"]) {
      min-height: var(--finger, 34px);
      min-width: var(--finger, 0);
    }
  }
  .panel {
    background: var(--panel);
    border: 1px solid var(--line);
    border-radius: 6px;
  }
`;
