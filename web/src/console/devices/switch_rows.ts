/** The look of rows that are switched on and off. */

import { css } from "lit";
import { flow, selectable } from "../../ui/theme";

export const switchRows = css`
  ul {
    margin: 0 0 8px;
  }
  li {
    ${flow}
    gap: 2px 8px;
    padding: 4px 0;
    border-bottom: 1px solid var(--line);
  }
  .name {
    flex: 1 1 120px;
    min-width: 0;
    overflow-wrap: anywhere;
  }
  .where,
  small {
    font-size: 12px;
    color: var(--dim);
  }
  small {
    flex-basis: 100%;
    ${selectable}
  }
  .found {
    margin: 0 0 8px;
  }
  small.attention {
    color: var(--attention);
  }
`;
