/** The look of a group of settings in the mixer. */

import { css } from "lit";

/** Rows below each other. */
export const groupStyle = css`
  :host {
    display: grid;
    gap: 6px;
    flex: none;
    align-content: start;
    font-size: 12px;
  }
`;
