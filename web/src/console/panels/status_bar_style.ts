import { css } from "lit";

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
  .item b {
    color: var(--text);
    font-weight: 600;
  }
  .slow b,
  .item b.slow {
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
  .messages {
    flex: 1;
    min-width: 0;
    align-self: flex-start;
    display: grid;
    gap: 2px;
    padding-top: 2px;
  }
  .notice {
    min-width: 0;
    max-width: 100%;
    justify-self: start;
    padding: 3px 8px;
    border-radius: 4px;
    background: var(--ground);
    color: var(--attention);
    font-size: 12.5px;
    overflow-wrap: anywhere;
  }
  .notice.none {
    display: none;
  }
  .notice.done {
    color: var(--text);
  }
  .panic {
    width: 230px;
    min-width: 130px;
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
  .panic i {
    font-style: normal;
  }
  @media (pointer: coarse) and (max-width: 899px) {
    .panic i {
      display: none; /* no keyboard */
    }
  }
  .panic small {
    overflow: hidden;
    text-overflow: ellipsis;
    white-space: nowrap;
  }
  @media (max-width: 1100px) {
    .mark,
    .item.consoles {
      display: none; /* there are messages to read */
    }
  }
  @media (max-width: 899px) {
    :host {
      gap: 8px;
      padding: 0 2px;
    }
    .mark,
    .item.consoles,
    .item .level {
      display: none;
    }
    .setup {
      margin-left: auto; /* panic stands in the corner, where a hand finds it */
    }
    .panic {
      width: 190px;
      flex: 0 1 auto;
    }
  }
  @media (max-width: 699px) {
    .messages {
      position: fixed;
      inset: 56px 8px auto;
      max-width: 440px;
      margin: 0 auto;
      padding: 0;
      pointer-events: none;
    }
    .notice {
      justify-self: stretch;
      padding: 6px 10px;
      background: #1d1a10;
      pointer-events: auto;
    }
  }
  @media (max-width: 599px) {
    .help,
    .item.link b {
      display: none; /* no keyboard */
    }
    .panic {
      flex: 1 1 170px;
      min-width: 120px;
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
  @media (max-width: 379px) {
    :host {
      gap: 6px;
    }
    .item.link,
    .item.stages {
      font-size: 11px;
      gap: 3px;
    }
    .trip {
      display: none;
    }
    .panic {
      letter-spacing: 0.1em;
    }
  }
`;
