/** What stands under the picture while somebody is guided: a drawing, what to do, how long. */

import { css } from "lit";
import { flow } from "../ui/theme";

export const guideStyle = css`
  section {
    display: grid;
    grid-template-columns: auto minmax(0, 1fr) auto;
    gap: 4px 14px;
    align-items: center;
    padding: 10px 14px;
    background: var(--panel);
    border: 1px solid var(--line);
    border-top: 2px solid var(--coming);
    border-radius: 6px;
  }
  .ready {
    border-top-color: var(--attention);
  }
  svg {
    color: var(--hand);
  }
  p {
    font-size: clamp(16px, 2.2vw, 22px);
    line-height: 1.2;
  }
  small {
    color: var(--dim);
    font-size: 13px;
  }
  progress {
    width: 100%;
    height: 8px;
    accent-color: var(--coming);
  }
  .count {
    min-width: 2ch;
    font-size: clamp(28px, 5vw, 46px);
    font-weight: 700;
    text-align: right;
  }
  .buttons {
    grid-column: 1 / -1;
    ${flow}
    gap: 6px;
  }
`;
