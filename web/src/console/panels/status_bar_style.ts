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
  .notice {
    flex: 1;
    min-width: 0;
    color: var(--attention);
    font-size: 12.5px;
    overflow: hidden;
    text-overflow: ellipsis;
    white-space: nowrap;
  }
  .notice.done {
    color: var(--text);
  }
  .notice a {
    display: inline-block;
    color: var(--focus);
    margin-left: 6px;
    padding: 6px 4px;
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
  @media (max-width: 900px) {
    .mark,
    .item.consoles {
      display: none;
    }
    .panic {
      width: 150px;
    }
  }
  @media (max-width: 620px) {
    :host {
      flex-wrap: wrap;
      gap: 6px 10px;
      padding: 6px;
    }
    .notice {
      order: 9;
      flex-basis: 100%;
    }
    .panic {
      flex: 1;
    }
  }
`;
