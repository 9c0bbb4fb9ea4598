import { css } from "lit";

/** What lies over everything else: dark, with something in its middle. */
export const curtain = css`
  :host {
    position: fixed;
    inset: 0;
    z-index: 9;
    display: grid;
    place-items: center;
    background: #000c;
    padding: 12px;
  }
`;

/** A curtain over all but the bar above, and thin, for a console: panic stays in sight, and what is on air. */
export const curtainBelowBar = css`
  ${curtain}
  :host {
    inset: 62px 0 0;
    background: #0006;
  }
`;

/** Closes a dialog where the curtain beside it is pressed. */
export function closeOutside(host: HTMLElement, close: () => void): void {
  host.addEventListener("click", (event) => {
    if (event.composedPath()[0] === host) close();
  });
}

/** A page of keys and what they do. */
export const keysPage = css`
  section {
    max-width: 720px;
    max-height: 100%;
    overflow: auto;
    padding: 18px 22px;
  }
  dl {
    display: grid;
    grid-template-columns: auto 1fr;
    gap: 5px 16px;
    margin: 12px 0;
  }
  dt {
    white-space: nowrap;
    font-weight: 700;
    color: var(--hand);
  }
  dd {
    color: var(--dim);
  }
`;
