import { css } from "lit";
import { ellipsis } from "../../ui/theme";

export const style = css`
  :host {
    display: flex;
    align-items: center;
    gap: 8px;
    padding: 0 10px;
    min-width: 0;
    height: 100%;
  }
  .mark {
    font-size: 15px;
    font-weight: 700;
    letter-spacing: 0.22em;
    color: var(--text);
    white-space: nowrap;
  }
  .mark small {
    font-size: 11px;
    font-weight: 500;
    color: var(--dim);
  }
  .lost {
    color: #fff;
    font-weight: 700;
    background: #c3170a;
    border-radius: 4px;
    padding: 6px 12px;
    white-space: nowrap;
  }
  .dot {
    flex: none;
    width: 10px;
    height: 10px;
    border-radius: 50%;
    border: 2px solid var(--faint);
  }
  .dot.dirty {
    background: var(--attention);
    border-color: var(--attention);
  }
  input {
    text-overflow: ellipsis;
  }
  .label {
    font-size: 15px;
    font-weight: 600;
    flex: 0 1 190px;
  }
  .tags {
    flex: 0 1 110px;
  }
  .steps {
    display: flex;
    gap: 2px;
    flex: none;
  }
  .steps button {
    display: flex;
    align-items: center;
    gap: 5px;
    min-width: 0;
  }
  .steps span {
    max-width: 150px;
    ${ellipsis}
  }
  .remark {
    flex: 0 1 120px;
  }
  .others {
    color: var(--attention);
    white-space: nowrap;
  }
  .save {
    min-width: 76px;
    height: 36px;
  }
  .you {
    display: flex;
    align-items: center;
    gap: 5px;
    font-size: 12px;
    color: var(--faint);
  }
  .you input {
    width: 92px;
    border-color: transparent;
    background: none;
    color: var(--dim);
  }
  .console {
    color: var(--dim);
    text-decoration: none;
    padding: 6px 4px;
  }
  @media (max-width: 1400px) {
    .remark {
      flex-basis: 90px;
    }
    .you {
      font-size: 0;
    }
  }
  @media (max-width: 1240px) {
    .steps span {
      display: none;
    }
  }
  @media (max-width: 1000px) {
    .you,
    .tags,
    .mark small {
      display: none;
    }
  }
  /* Two rows: what is open, its steps and Save; below them what is rarely needed. */
  @media (max-width: 700px) {
    :host {
      flex-wrap: wrap;
      height: auto;
      gap: 6px;
      padding: 6px 8px;
    }
    .beside,
    .beside ~ .grow {
      display: none;
    }
    .lost {
      flex: 1 0 100%;
      order: -1;
      white-space: normal;
    }
    .label {
      flex: 1 1 100px;
    }
    .others,
    .remark,
    .console,
    .console ~ .icon {
      order: 1;
    }
    .others {
      flex: 1 1 100%;
      white-space: normal;
    }
    .remark {
      flex: 1 1 100px;
    }
  }
`;
