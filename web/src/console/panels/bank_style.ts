import { css } from "lit";
import { flow } from "../../ui/theme";
import { narrow, short } from "../controls/screen_sizes";

export const style = css`
  :host {
    display: grid;
    grid-template: auto minmax(0, 1fr) / minmax(0, 1fr);
    min-height: 0;
    min-width: 0;
  }
  header {
    ${flow}
    gap: 4px;
    padding: 6px 8px;
    border-bottom: 1px solid var(--line);
  }
  nav {
    display: flex;
    flex-wrap: wrap;
    gap: 2px;
    flex: 1;
  }
  nav button {
    border-color: transparent;
    background: none;
    font-size: 12px;
    padding: 0 7px;
    text-transform: capitalize;
  }
  nav button[aria-selected="true"] {
    background: var(--raised);
    color: var(--text);
    border-color: var(--edge);
  }
  .count {
    display: inline-block; /* as wide without a number: tabs stay under the hand when others get one */
    min-width: 2.5ch;
    color: var(--air);
    font-weight: 700;
    text-align: right;
  }
  .strips {
    display: flex;
    align-items: stretch;
    gap: 2px;
    padding: 4px 8px 2px;
    overflow: auto hidden;
    min-height: 0;
    scrollbar-width: thin;
    scrollbar-color: var(--edge) transparent;
    overscroll-behavior: contain;
  }
  .strips.more {
    mask-image: linear-gradient(90deg, #000 calc(100% - 40px), #0003);
  }
  .kind {
    writing-mode: vertical-rl;
    transform: rotate(180deg);
    text-align: center;
    font-size: 10px;
    letter-spacing: 0.1em;
    text-transform: uppercase;
    color: var(--faint);
    padding: 0 3px;
    border-right: 1px solid var(--line);
  }
  .strip {
    display: grid;
    grid-template-rows: 1fr 56px;
    flex: 1 0 72px;
    min-width: 72px;
    max-width: 92px;
  }
  .strip.pair {
    max-width: 116px;
  }
  .pair {
    border-radius: 4px;
    background: #ffffff07;
  }
  .faders {
    display: flex;
    justify-content: center;
    min-height: 0;
  }
  omote-fader,
  omote-macro-fader {
    flex: 1 0 34px;
  }
  .label {
    font-size: 10.5px;
    line-height: 12px;
    text-align: center;
    color: var(--dim);
    overflow: hidden;
    overflow-wrap: anywhere;
  }
  .label small {
    display: block;
    font-size: 9px;
    line-height: 10px;
    color: var(--faint);
    overflow-wrap: anywhere;
  }
  .empty {
    margin: auto;
    color: var(--faint);
  }
  @media (max-width: 1100px) {
    nav button {
      padding: 0 5px;
      font-size: 11.5px;
    }
  }
  @media (pointer: coarse) {
    nav {
      flex-wrap: nowrap;
      min-width: 0;
      overflow: auto hidden;
      scrollbar-width: none;
    }
    nav {
      gap: 0;
    }
    nav button {
      flex: none;
      padding: 0 4px;
    }
    header {
      flex-wrap: nowrap;
    }
    header > button {
      flex: none;
      padding: 0 6px;
    }
    .strip {
      min-width: 52px;
    }
    .strip.pair {
      flex-basis: 88px;
      min-width: 88px;
    }
    omote-fader {
      flex-basis: 42px;
    }
  }
  @media (max-width: 599px) {
    header {
      flex-wrap: wrap;
    }
    nav {
      flex: 1 0 100%;
    }
    header > button {
      flex: 1;
    }
  }
  @media ${short} {
    header {
      padding: 3px 6px;
    }
    .strips {
      padding-top: 0;
    }
    .strip {
      grid-template-rows: 1fr 36px;
    }
    nav button {
      padding: 0 4px;
      font-size: 11.5px;
    }
    header > button {
      padding: 0 6px;
    }
  }
  @media ${narrow} and (max-height: 600px) {
    header {
      flex-wrap: nowrap;
    }
    nav {
      flex: 1 1 0;
    }
    header > button {
      flex: none;
    }
    header > [data-clear="region"] {
      display: none; /* twice on a fader puts it to rest, the other button all */
    }
  }
`;
