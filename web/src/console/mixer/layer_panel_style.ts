import { css } from "lit";
import { ellipsis, emptyBar } from "../../ui/theme";
import { tight } from "../controls/screen_sizes";

/** Strips beside each other, which scroll sideways where there is no room; beside them heads of groups, and one group. */
export const style = css`
  :host {
    display: grid;
    grid-template-columns: minmax(0, 1fr) 138px minmax(300px, 352px);
    grid-template-rows: minmax(0, 1fr);
    gap: 10px;
    padding: 8px 10px;
    min-height: 0;
    min-width: 0;
    overflow: hidden;
  }
  .strips {
    display: flex;
    gap: 6px;
    min-height: 0;
    overflow: auto;
    scrollbar-width: thin;
  }
  .strip {
    flex: 1 1 96px;
    min-width: 96px;
    display: grid;
    grid-template-columns: minmax(0, 1fr);
    grid-template-rows: auto 30px minmax(72px, 1fr) auto;
    gap: 4px;
    min-height: 0;
    padding: 4px;
    border: 1px solid var(--line);
    border-radius: 6px;
  }
  /* as wide as when a source plays: faders beside it stay where the hand is */
  .strip.idle .name {
    font-weight: 400;
  }
  .strip.idle .bars {
    visibility: hidden;
  }
  .strip.idle .name:not([aria-pressed="true"]),
  .strip.idle .feed {
    color: var(--faint);
  }
  .strip.off .play {
    opacity: 0.4;
  }
  .name {
    font-weight: 600;
    color: var(--text);
    min-width: 0;
    padding: 0;
  }
  .feed {
    display: -webkit-box;
    -webkit-box-orient: vertical;
    -webkit-line-clamp: 2;
    overflow: hidden;
    font-size: 12px;
    line-height: 15px;
    text-align: center;
    overflow-wrap: anywhere;
    color: var(--dim);
  }
  .feed.wanted {
    color: var(--attention);
  }
  .play {
    display: grid;
    grid-template-columns: auto minmax(0, 1fr);
    gap: 4px;
    min-height: 0;
  }
  .bars {
    display: grid;
    align-content: center;
    gap: 3px;
  }
  .bar {
    position: relative;
    height: 18px;
    padding: 0 3px;
    ${ellipsis}
    font-size: 10.5px;
    line-height: 18px;
    border-radius: 2px;
    background: #000;
  }
  .bar i {
    ${emptyBar}
    background: var(--air-deep);
  }
  .bar.below i {
    transform-origin: right;
    background: var(--edge);
  }
  .bar span {
    position: relative;
  }
  .on[aria-pressed="true"] {
    color: var(--text);
    background: var(--edge);
    border-color: var(--edge);
  }
  .on[aria-pressed="false"] {
    color: var(--attention);
    border-color: var(--attention);
  }
  .detail {
    display: flex;
    flex-direction: column;
    gap: 6px;
    min-height: 0;
    overflow: auto;
    scrollbar-width: thin;
  }
  header {
    display: flex;
    align-items: center;
    gap: 6px;
    flex: none;
  }
  .of {
    flex: 1 1 0;
    min-width: 0;
    ${ellipsis}
    color: var(--dim);
  }
  .parts {
    display: grid;
    grid-template-columns: repeat(6, minmax(0, 1fr));
    flex: 1 0 118px;
    max-height: 190px;
    text-align: center;
    font-size: 11px;
    color: var(--dim);
  }
  .parts div {
    display: grid;
    grid-template-rows: minmax(0, 1fr) auto;
    min-height: 0;
  }
  omote-source-settings {
    flex: none;
  }
  .none {
    color: var(--dim);
  }
  .detail omote-motion-settings {
    max-width: 460px;
  }
  @media (max-height: 720px) {
    .strip {
      grid-template-rows: auto 15px minmax(72px, 1fr) auto;
      gap: 2px;
    }
    .feed {
      -webkit-line-clamp: 1;
    }
  }
  @media (max-width: 1300px) {
    :host {
      grid-template-columns: minmax(0, 1fr) 96px minmax(290px, 300px);
      gap: 6px;
    }
  }
  @media (min-width: 900px) and (max-width: 1300px) {
    .close {
      display: none; /* its key stands on the picture */
    }
    .strips {
      gap: 4px;
    }
    /* eight of them beside each other, what a layer does below its fader */
    .strip {
      flex: 1 1 0;
      min-width: 0;
    }
    .play {
      grid-template-columns: minmax(0, 1fr);
      grid-template-rows: minmax(0, 1fr) auto;
    }
    .bar + .bar {
      display: none;
    }
  }
  /* a fader that a finger can hold comes before what a layer does, which its own bar shows too */
  @media (min-width: 900px) and (max-width: 1300px) and (max-height: 900px) {
    .bars {
      display: none;
    }
    .strip {
      grid-template-rows: auto 15px minmax(84px, 1fr) auto;
    }
    .feed {
      -webkit-line-clamp: 1;
    }
  }
  @media (min-width: 1100px) and (max-width: 1300px) and (min-height: 721px) {
    :host {
      grid-template-columns: minmax(0, 1fr) 118px 336px;
    }
    .strip {
      grid-template-rows: auto 30px minmax(84px, 1fr) auto;
    }
    .feed {
      -webkit-line-clamp: 2;
    }
  }
  @media (min-width: 900px) and (max-width: 1300px) and (max-height: 600px) {
    .strip {
      grid-template-rows: auto minmax(84px, 1fr) auto;
    }
    .feed {
      display: none;
    }
  }
  @media ${tight} {
    .bars {
      display: none;
    }
    :host {
      display: flex;
      flex-direction: column;
      overflow: auto;
      gap: 8px;
      padding: 6px 8px;
    }
    .strips {
      flex: 1 0 132px;
    }
    .strip {
      flex: 1 0 68px;
      min-width: 68px;
    }
    :host([data-group="strips"]) .detail,
    :host(:not([data-group="strips"])) .strips {
      display: none;
    }
    .play {
      grid-template-columns: minmax(0, 1fr);
      grid-template-rows: minmax(0, 1fr);
    }
    omote-group-heads {
      order: -1;
      flex: none;
    }
    .detail {
      overflow: visible;
      flex: none;
    }
    .close {
      display: none; /* its tab stands above */
    }
  }
`;
