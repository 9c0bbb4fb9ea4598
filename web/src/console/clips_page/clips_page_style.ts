/** How the page of clips is laid out: on a desk the list stands left of the time line, on a phone above it. */

import { css } from "lit";
import { flow } from "../../ui/theme";

export const clipsPageStyle = css`
  :host {
    display: grid;
    grid-template: "head head" auto "list settings" auto "list line" minmax(0, 1fr) "transport transport" auto / 230px minmax(0, 1fr);
    gap: 6px;
    height: calc(100dvh - var(--bar, 0px));
    min-height: 0;
    overflow: hidden;
  }
  header {
    grid-area: head;
    display: grid;
    grid-template-columns: minmax(0, 1fr) auto;
    align-items: start;
    gap: 8px;
    padding: 0 4px;
  }
  .bar {
    ${flow}
    gap: 4px 8px;
    min-height: 46px;
  }
  nav {
    display: flex;
    gap: 12px;
  }
  .bar > button {
    min-height: var(--finger, 36px);
  }
  .bar > button:not([aria-pressed="true"]) {
    color: var(--text);
  }
  .lost {
    flex: none;
  }
  .notice {
    flex: 1 1 160px;
    min-width: 0;
    max-height: 40px;
    overflow: auto;
    color: var(--attention);
    overflow-wrap: anywhere;
  }
  .notice.done {
    color: var(--text);
  }
  omote-clip-list {
    grid-area: list;
  }
  omote-clip-settings {
    grid-area: settings;
  }
  .line {
    grid-area: line;
    position: relative;
    display: grid;
    min-height: 0;
    min-width: 0;
    overflow: hidden;
  }
  omote-clip-transport {
    grid-area: transport;
  }
  .count {
    position: absolute;
    inset: 0;
    z-index: 6;
    display: grid;
    place-content: center;
    justify-items: center;
    color: #fff;
    background: #c3170acc;
    font-size: min(42vh, 300px);
    font-weight: 800;
    line-height: 1;
    pointer-events: none;
  }
  .count small {
    font-size: 22px;
    font-weight: 600;
  }
  .panic {
    min-width: 110px;
    min-height: 44px;
    font-size: 16px;
    font-weight: 800;
    letter-spacing: 0.14em;
    color: var(--attention);
    background: #241a02;
    border: 2px solid var(--attention);
    border-radius: 6px;
    touch-action: none;
  }
  @media (pointer: coarse) {
    :host {
      --finger: 44px;
    }
    nav a {
      display: grid;
      place-content: center;
      min-width: 44px;
      min-height: 44px;
    }
  }
  @media (max-width: 1100px) {
    :host {
      grid-template-columns: 190px minmax(0, 1fr);
    }
  }
  @media (max-width: 899px) {
    :host {
      grid-template: "head" auto "list" auto "settings" auto "line" minmax(0, 1fr) "transport" auto / minmax(0, 1fr);
      gap: 4px;
      padding: 4px;
    }
    /* it has its room while it is empty too: nothing moves under a finger when a pass begins or ends */
    .notice {
      order: 1;
      flex: 1 0 100%;
      height: 34px;
    }
  }
  @media (min-width: 600px) and (max-width: 899px) {
    omote-record-light {
      flex: 1 1 0;
      min-width: 120px;
    }
  }
  @media (max-width: 599px) {
    h1,
    .help {
      display: none;
    }
    .panic {
      min-width: 92px;
    }
  }
`;
