/** How a seat's colour stands beside its name. */

import { css } from "lit";

export const seatStyle = css`
  .colour {
    flex: none;
    width: 14px;
    height: 14px;
    border-radius: 3px;
    border: 1px solid #000;
  }
`;
