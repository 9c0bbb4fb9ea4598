import { css } from "lit";
import { ellipsis, entry, flow } from "../../ui/theme";
import { low } from "../controls/screen_sizes";

/** Two pads, and nothing over the face. Held upright: the face above, pads below it. */
export const soloPageStyle = css`
  :host {
    --finger: 44px;
    display: grid;
    gap: 6px;
    height: calc(100dvh - var(--bar, 0px));
    padding: 6px max(6px, env(safe-area-inset-right)) max(6px, env(safe-area-inset-bottom)) max(6px, env(safe-area-inset-left));
    background: var(--ground);
    overflow: hidden;
    grid-template:
      "bar bar" auto
      "face face" minmax(120px, 1fr)
      "left right" calc(min(50vw, 44dvh) + 32px)
      "looks looks" auto
      "next next" auto
      "lines head" var(--last, max(170px, 17dvh)) / minmax(0, 1fr) minmax(0, 1fr);
  }
  :host(:not([lines], [head])) {
    --last: 0;
  }
  :host(.preview) {
    --air: #a596ff;
    --air-deep: #33257f;
  }
  :host(.lost) {
    box-shadow: inset 0 0 0 4px #d21f10;
  }
  :host(.lost) .live {
    opacity: 0.45;
    filter: grayscale(0.7);
  }
  :host(.view-only) .live:not(.picture) {
    opacity: 0.6;
    pointer-events: none;
  }
  header {
    grid-area: bar;
    display: grid;
    grid-template-columns: minmax(0, 1fr) auto;
    gap: 6px;
    min-width: 0;
  }
  omote-learn-mode {
    grid-column: 1 / -1;
  }
  .bar {
    ${flow}
    flex-wrap: nowrap; /* nothing of the page moves for words */
    gap: 4px 8px;
    min-width: 0;
    padding: 4px 8px;
  }
  .bar > :is(button, h1, omote-liveliness, omote-black-key, .lost-link) {
    flex: none;
  }
  .bar > [aria-label="Characters"] {
    flex: 0 1 auto;
    min-width: 88px;
    white-space: nowrap;
    overflow-x: auto;
    scrollbar-width: none;
  }
  .bar > omote-record-light {
    flex: 0 8 auto;
    margin-block: -4px; /* as high as the bar: its finger's room is the bar's padding too */
  }
  .bar > omote-source-line {
    flex: 0 1 auto;
    min-width: 0;
  }
  h1 {
    margin: 0;
    font-size: 13px;
    letter-spacing: 0.14em;
  }
  .air {
    min-width: 0;
    max-width: 30ch;
    padding: 3px 8px;
    border-radius: 3px;
    font-weight: 700;
    ${ellipsis}
    color: #fff;
    background: #b3261a;
  }
  :host(.preview) .air {
    background: #3b29a3;
  }
  .air.black {
    background: #000;
    outline: 2px solid #b3261a;
  }
  .notice {
    flex: 1 1 200px;
    min-width: 0;
    display: flex;
    align-items: center;
    line-height: 1.3;
  }
  .notice > span {
    flex: 0 1 auto;
    min-width: 60px;
    max-height: 2.6em; /* two lines: nothing of the page moves for words */
    overflow: hidden;
  }
  .notice .offer {
    flex: none;
    padding: 6px 2px;
  }
  .notice .away {
    min-width: 34px;
  }
  .notice.none {
    flex: 1 1 0;
  }
  .rows {
    display: none; /* where there is no room for all parts */
  }
  .notice.attention {
    color: var(--attention);
  }
  .lost-link {
    padding: 4px 10px;
    border-radius: 4px;
    font-weight: 700;
    color: #fff;
    background: #c3170a;
  }
  .bar button {
    color: var(--text);
    min-height: 34px;
  }
  .bar button[aria-pressed="true"] {
    color: var(--ground);
  }
  .panic {
    align-self: start; /* as high as ever, beside a bar of two lines too */
    min-width: 120px;
    min-height: 46px;
    font-size: 17px;
    font-weight: 800;
    letter-spacing: 0.08em;
    color: #fff;
    background: #c3170a;
    border: 0;
    border-radius: 6px;
    touch-action: none;
  }
  .panic.again {
    font-size: 14px;
    color: #000;
    background: var(--attention);
  }
  .panic:active {
    background: #ff4130;
  }
  .chosen {
    position: fixed;
    z-index: 7;
    top: 58px;
    right: 6px;
    display: grid;
    gap: 6px;
    width: min(300px, calc(100vw - 12px));
    padding: 10px 12px;
    background: var(--raised);
    border: 1px solid var(--edge);
    border-radius: 6px;
    box-shadow: 0 6px 24px #000a;
  }
  .chosen label {
    display: flex;
    align-items: center;
    gap: 8px;
    min-height: 32px;
  }
  .chosen input:not([type="checkbox"]) {
    ${entry}
  }
  .chosen span {
    display: grid;
    gap: 6px;
  }
  .chosen a {
    color: var(--focus);
  }
  .face {
    grid-area: face;
    position: relative;
    display: grid;
    min-width: 0;
    min-height: 0;
    overflow: hidden;
  }
  omote-blend-pad select {
    flex: 1 1 0;
    min-width: 0;
    font-weight: 600;
  }
  .left {
    grid-area: left;
  }
  .right {
    grid-area: right;
  }
  .empty {
    display: grid;
    place-content: center;
    padding: 12px;
    text-align: center;
    color: var(--dim);
  }
  .empty select {
    margin-top: 8px;
    min-height: 44px;
  }
  .lines {
    grid-area: lines;
    min-width: 0;
    min-height: 0;
    padding: 6px;
    display: grid;
    overflow: hidden;
  }
  .head {
    grid-area: head;
  }
  :host([head]:not([lines])) .head,
  :host([lines]:not([head])) .lines {
    grid-column: 1 / -1;
  }
  omote-next-cue {
    grid-area: next;
  }
  omote-memories {
    grid-area: looks;
    min-width: 0;
  }
  /* a tablet or a desk: pads where thumbs are, the face between them */
  @media (min-width: 900px) and (min-height: 540px) {
    :host {
      grid-template:
        "bar bar bar" auto
        "corner face next" minmax(96px, 38fr)
        "left face right" minmax(0, 62fr)
        "left below right" var(--below, 0px)
        "looks looks looks" auto / minmax(0, 1fr) minmax(0, 1.15fr) minmax(0, 1fr);
    }
    .bar > omote-record-light {
      min-width: 140px;
    }
    .chosen :is(omote-liveliness, .keys) {
      display: none; /* in the bar */
    }
    :host([head][lines]) {
      --below: minmax(112px, 15fr);
    }
    :host .head,
    :host([lines]:not([head])) .lines {
      grid-area: corner;
    }
    :host([lines][head]) .lines {
      grid-area: below;
    }
    .left,
    .right {
      grid-row-end: below;
    }
    :host(:not([head], [lines])) .left {
      grid-row-start: corner;
    }
    :host(:not([head][lines])) .face {
      grid-row-end: below;
    }
  }
  @media (max-width: 899px) {
    .bar {
      flex-wrap: wrap; /* the face above the pads is as much lower */
      gap: 4px;
      padding: 2px 4px;
    }
    .bar > .air {
      flex: 1 1 70px;
      padding: 3px 5px;
      font-size: 12px;
    }
    .bar button {
      padding: 0 6px;
    }
    h1,
    .bar > .help {
      display: none; /* in what is chosen to show */
    }
    .bar > omote-source-line {
      display: none; /* pads say who covers them */
    }
    .bar > omote-liveliness {
      --way: none; /* what a panic ends has its way back in sight */
    }
    .panic {
      min-width: 84px;
    }
    .notice {
      order: 1;
      flex-basis: 100%;
    }
    .notice.none {
      display: none;
    }
  }
  @media (max-width: 899px) and (orientation: portrait) {
    .chosen {
      inset: auto 6px 6px auto; /* the face stays in sight */
    }
  }
  /* a phone on its side: one part below the face, by its tab */
  @media (${low}) and (orientation: landscape) {
    :host {
      gap: 4px;
      padding-top: 4px;
      grid-template:
        "bar bar bar" auto
        "left face right" minmax(0, 1fr)
        "left next right" auto
        "left looks right" auto / minmax(0, min(33vw, 100dvh - 90px)) minmax(0, 1fr) minmax(0, min(33vw, 100dvh - 90px));
    }
    .bar {
      flex-wrap: nowrap;
    }
    .rows {
      flex: none;
      display: flex;
      gap: 2px;
    }
    omote-memories,
    :host .lines,
    :host .head {
      display: none;
    }
    :host([data-row="looks"]) omote-memories {
      display: block;
    }
    :host([data-row="lines"]) .lines,
    :host([data-row="head"]) .head {
      grid-area: looks;
      display: grid;
      height: 108px;
    }
    :host([data-row="head"]) .head {
      height: 140px;
    }
    .notice {
      order: 0;
      flex: 1 1 160px;
      font-size: 12px;
    }
    .notice.none {
      display: flex; /* what stands right of it stays there */
    }
  }
`;
