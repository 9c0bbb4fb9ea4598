import { css } from "lit";
import { ellipsis } from "../../ui/theme";
import { upright } from "../controls/screen_sizes";

export const style = css`
  :host {
    display: flex;
    align-items: center;
    gap: 14px;
    padding: 0 10px;
    min-width: 0;
  }
  .mark {
    font-size: 15px;
    font-weight: 700;
    letter-spacing: 0.22em;
    color: var(--text);
  }
  .item {
    display: flex;
    align-items: baseline;
    gap: 5px;
    white-space: nowrap;
    color: var(--dim);
    font-size: 12px;
  }
  :is(.item.stages, .item.link) {
    min-width: 0;
    overflow: hidden; /* nine slow screens give way, buttons and panic do not */
  }
  :is(.log, .bus, .moments, .learn, .setup, .help, .step) {
    flex: none;
  }
  .item b {
    color: var(--text);
    font-weight: 600;
  }
  :is(.slow b, .item b.slow) {
    color: var(--attention);
  }
  .lamp {
    align-self: center;
    width: 9px;
    height: 9px;
    border-radius: 50%;
    background: var(--text);
  }
  .lost {
    color: #fff;
    font-weight: 700;
    font-size: 14px;
    letter-spacing: 0.04em;
    background: #c3170a;
    border-radius: 4px;
    padding: 6px 12px;
  }
  /* in the bar, never below it: nothing that is played on is covered */
  .messages {
    flex: 1;
    min-width: 0;
    display: flex;
    align-items: center;
    gap: 8px;
    max-height: 100%;
    container-type: inline-size;
  }
  @container (max-width: 48px) {
    omote-note {
      display: none; /* no room for a finger */
    }
  }
  .notice {
    display: flex;
    align-items: center;
    gap: 6px;
    min-width: 0;
    color: var(--attention);
    font-size: 12.5px;
    line-height: 1.3;
    overflow-wrap: anywhere;
  }
  .notice > span:first-child {
    display: -webkit-box;
    overflow: hidden;
    -webkit-box-orient: vertical;
    -webkit-line-clamp: 3;
  }
  .offers {
    flex: none;
    white-space: nowrap;
  }
  omote-import-progress {
    flex: 0 1 auto;
  }
  :host([asks]) .mark,
  :host([asks]) .item {
    display: none;
  }
  :host([asks]) slot[name="seat"] {
    --words: none;
  }
  /* the light has the room of what is to be watched, and gives its own to what is to be answered */
  :host([records]) .item.stages .word,
  :host([records]) .item.consoles {
    display: none;
  }
  :host([asks]) omote-record-light {
    --light-words: none;
    flex: none;
  }
  @media (max-width: 1599px) {
    :host([records]) :is(.mark, omote-show-clock, .bus, .moments) {
      display: none; /* they stand in the set-up too, and the light has a clock */
    }
  }
  @media (max-width: 1100px) {
    :host([records]) :is(omote-show-clock, .item) {
      display: none;
    }
  }
  @media (max-width: 599px) {
    :host([records]) .step {
      display: none; /* it stands in the log too; panic keeps its corner */
    }
    :host([records]) .log {
      margin-left: auto;
    }
  }
  .notice.none {
    display: none;
  }
  .notice.done {
    color: var(--text);
  }
  .log.unread {
    color: #000;
    background: var(--attention);
    border-color: var(--attention);
  }
  .step {
    padding: 0;
    width: 30px;
    font-size: 17px;
  }
  /* in the corner, as wide with one character as with eight: what is beside it gives way */
  .panic {
    flex: none;
    width: 230px;
    height: 46px;
    font-size: 17px;
    font-weight: 800;
    letter-spacing: 0.2em;
    color: var(--attention);
    background: #241a02;
    border: 2px solid var(--attention);
    border-radius: 6px;
    touch-action: none;
  }
  .panic.all {
    flex: 0 0 46px;
    width: 46px;
    min-width: 0;
    padding: 0;
    font-size: 12px;
    letter-spacing: 0;
  }
  .panic small {
    display: block;
    font-size: 10px;
    font-weight: 500;
    letter-spacing: 0.06em;
    line-height: 10px;
  }
  .panic:active,
  .panic.done {
    color: #000;
    background: var(--attention);
  }
  @media (hover: hover) {
    .panic:hover {
      color: #fff0c4;
      border-color: #fff0c4;
    }
  }
  .panic.again {
    color: #000;
    background: #b88a1d;
    letter-spacing: 0.08em;
  }
  .panic.unheard {
    color: #fff;
    background: #a11d12;
    border-color: #fff;
  }
  .panic i {
    font-style: normal;
  }
  @media (pointer: coarse) and (max-width: 899px) {
    .panic i {
      display: none; /* no keyboard */
    }
  }
  .panic small {
    ${ellipsis}
  }
  @media (max-width: 1100px) {
    .mark,
    .item.consoles {
      display: none; /* there are messages to read */
    }
    :host {
      gap: 8px;
    }
    .panic {
      width: 220px;
    }
    omote-name-field[open] ~ .offers {
      display: none; /* the keys for it are there */
    }
  }
  @media (max-width: 1100px) and (pointer: coarse) {
    .step.redo {
      display: none; /* it stands in the log too */
    }
  }
  @media (max-width: 767px) {
    omote-show-clock {
      display: none;
    }
  }
  @media (max-width: 1250px) {
    .bus {
      display: none; /* it stands in the set-up too */
    }
  }
  @media (max-width: 1559px) {
    .moments {
      display: none; /* it stands in the set-up too, and on keys: panic keeps its corner in the fullest bar */
    }
  }
  @media (max-width: 940px) {
    .learn {
      display: none; /* it stands in the set-up too */
    }
  }
  @media (max-width: 899px) {
    :host {
      gap: 8px;
      padding: 0 2px;
    }
    :host([asks]) omote-show-clock {
      display: none;
    }
    .mark,
    .item.consoles,
    .item .level {
      display: none;
    }
    .step.redo,
    a.offer {
      display: none; /* they stand in the log too, in the set-up and in the menu of the tile */
    }
    .step {
      width: 40px;
    }
    .panic {
      width: 190px;
    }
  }
  @media ${upright} {
    omote-note {
      display: none; /* messages stand above the picture there: words of the crew do not */
    }
    .messages {
      position: fixed;
      inset: 64px 104px auto; /* above the picture, which makes room, between the T-bars */
      display: grid;
      gap: 4px;
      max-height: none;
      pointer-events: none;
    }
    .notice {
      flex-wrap: wrap;
      padding: 6px 10px;
      border-radius: 4px;
      background: #1d1a10;
      pointer-events: auto;
    }
    .notice.done {
      background: var(--raised);
    }
    .offers {
      flex: 0 1 auto;
      white-space: normal; /* never beyond the picture, over a T-bar */
    }
    omote-import-progress {
      pointer-events: auto;
    }
    .step {
      margin-left: auto; /* panic stands in the corner, where a hand finds it */
    }
  }
  @media (max-width: 599px) {
    :host {
      gap: 6px;
    }
    .messages {
      inset: 64px 86px auto;
    }
    .help,
    .item.link b,
    .item.stages .word,
    .trip {
      display: none; /* no keyboard, no room */
    }
    .panic {
      width: 122px;
      letter-spacing: 0.12em;
    }
    .panic.again {
      font-size: 14px;
      letter-spacing: 0;
    }
    .setup {
      flex: none;
      padding: 0 6px;
    }
    .lost {
      font-size: 12px;
      padding: 4px 6px;
    }
  }
  @media (max-width: 599px) and (max-height: 600px) {
    .messages {
      inset-block-start: 54px;
    }
  }
  @media (max-width: 429px) {
    .panic {
      width: 110px;
    }
  }
  @media (max-width: 379px) {
    .step {
      display: none; /* it stands in the log */
    }
    .log {
      margin-left: auto;
    }
    :host {
      gap: 6px;
    }
    .item.link,
    .item.stages {
      font-size: 11px;
      gap: 3px;
    }
    .panic {
      width: 84px;
      font-size: 15px;
      letter-spacing: 0.04em;
    }
    .panic.all {
      flex-basis: 40px;
      width: 40px;
    }
  }
`;
