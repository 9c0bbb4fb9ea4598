import { css } from "lit";
import { low, narrow, upright } from "./controls/screen_sizes";

/**
 * The areas of the page. Wide: everything at once. A tablet held upright: faders or pads below. A phone: palettes, faders
 * or pads below; on its side, beside the picture. Panic, picture and T-bars are always there, and the page itself never
 * scrolls: what has no room scrolls inside its own panel.
 */
export const style = css`
  :host {
    --finger: 40px;
    height: calc(100dvh - var(--bar, 0px));
    background: var(--ground);
    display: grid;
    gap: 6px;
    padding: 6px;
    grid-template:
      "status status status status status" 50px
      "faces facebar air exprbar expressions" minmax(0, 1fr)
      "faces facebar lights exprbar expressions" auto
      "hands hands bank bank bank" minmax(220px, 31%) /
      minmax(228px, 0.8fr) 88px minmax(300px, 1.1fr) 88px minmax(330px, 1.15fr);
    overflow: hidden;
  }
  /* red is on air, and nothing of this page is */
  :host(.preview) {
    --air: #a596ff;
    --air-deep: #33257f;
  }
  omote-status {
    grid-area: status;
    position: relative; /* its messages may hang over what is below */
    z-index: 6;
  }
  .faces {
    grid-area: faces;
  }
  .facebar {
    grid-area: facebar;
  }
  .air {
    grid-area: air;
    position: relative;
    display: grid;
    grid-template-rows: minmax(0, 1fr) auto auto auto;
    overflow: hidden;
  }
  .air omote-monitor,
  .air omote-head-frames,
  .air omote-characters {
    grid-area: 1 / 1;
  }
  .air omote-characters {
    align-self: start;
    margin-left: 84px; /* beside the tally */
  }
  /* keys for several have lines of their own: they cover no face, and no notice moves them */
  :host(.several) .air omote-characters {
    grid-row: 3;
    grid-column: 1 / -1;
    margin-left: 0;
  }
  @media (pointer: coarse) and (min-width: 900px) and (max-height: 820px) {
    :host(.several) .mixes {
      --lists: none; /* their room is the picture's; the T-bars name both ends */
    }
  }
  /* below the picture, which is as much lower: no face is covered, and nothing that is played on moves */
  omote-show-notices {
    grid-area: 2 / 1;
    margin: 4px 6px;
  }
  .mixes {
    grid-row: 4;
  }
  .looks {
    grid-area: lights;
    display: grid;
    grid-template-columns: minmax(0, 1fr);
    gap: inherit;
  }
  .mixes {
    display: grid;
    grid-template-columns: repeat(2, minmax(0, 1fr));
    border-top: 1px solid var(--line);
  }
  .mixes omote-mix + omote-mix {
    border-left: 1px solid var(--line);
  }
  .exprbar {
    grid-area: exprbar;
  }
  .expressions {
    grid-area: expressions;
  }
  .hands {
    grid-area: hands;
    display: grid;
    grid-template-columns: repeat(2, minmax(0, 1fr));
    gap: 6px;
    min-width: 0;
  }
  omote-bank {
    grid-area: bank;
  }
  omote-scene-panel,
  omote-pad-panel,
  omote-layer-panel {
    grid-area: hands-start / hands-start / bank-end / bank-end;
  }
  :host(:is([data-view="scene"], [data-view="layers"], [data-view="blend_pads"])) :is(.hands, omote-bank) {
    display: none;
  }
  /* what is played by a point wants a way to go */
  @media (min-width: 900px) and (min-height: 721px) {
    :host([data-view="blend_pads"]) {
      grid-template-rows: 50px minmax(0, 1fr) auto minmax(280px, 43%);
    }
  }
  @media (min-width: 900px) {
    /* the picture is low then, and keys over it would lie on the face */
    :host([data-view="blend_pads"]) .air omote-characters {
      grid-row: 3;
      grid-column: 1 / -1;
      margin-left: 0;
    }
  }
  @media (min-width: 900px) and (max-height: 899px) {
    :host([data-view="blend_pads"]) .mixes {
      --lists: none; /* their room is the picture's; the T-bars name both ends */
    }
  }
  .views {
    grid-area: views;
    display: none;
    gap: 6px;
  }
  .views button {
    flex: 1 1 auto;
    min-height: 44px;
    padding: 0 4px;
  }
  :host(.view-only) .live:not(.picture) {
    opacity: 0.6;
    pointer-events: none;
  }
  :host(.view-only) .picture {
    pointer-events: none;
  }
  :host(.lost) {
    box-shadow: inset 0 0 0 4px #d21f10;
  }
  :host(.lost) .live {
    opacity: 0.45;
    filter: grayscale(0.7);
  }
  .faces {
    --tile: 56px; /* the whole built-in cast, and some of the crew's own, without a scroll */
  }
  @media (min-width: 1600px) {
    .faces {
      --tile: 76px;
    }
    .expressions {
      --tile: 96px;
    }
    :host {
      grid-template-columns: minmax(330px, 0.8fr) 104px minmax(480px, 1.2fr) 104px minmax(480px, 1.1fr);
    }
  }
  @media (max-width: 1100px) and (min-width: 900px) {
    :host {
      grid-template-columns: minmax(178px, 0.7fr) 78px minmax(260px, 1fr) 78px minmax(250px, 1fr);
    }
    .faces,
    .expressions {
      --tile: 56px;
    }
  }
  /* a window as low as a small laptop's: everything still has its place, with less air */
  @media (pointer: coarse) and (min-width: 900px) and (max-width: 1100px) and (max-height: 560px) {
    omote-memories {
      display: none; /* the picture keeps its room; Shift 1 to 9 call them */
    }
  }
  @media (min-width: 900px) and (max-height: 720px) {
    :host {
      gap: 4px;
      grid-template-rows: 48px minmax(0, 1fr) auto minmax(176px, 31%);
    }
    .faces,
    .expressions {
      --tile: 56px;
    }
  }
  /* a tablet held upright */
  @media (max-width: 899px) {
    :host {
      grid-template:
        "status status status status" 52px
        "facebar air air exprbar" minmax(0, 32fr)
        "facebar lights lights exprbar" auto
        "faces faces expressions expressions" minmax(0, 37fr)
        "views views views views" 44px
        "below below below below" minmax(0, 25fr) / 88px minmax(0, 1fr) minmax(0, 1fr) 88px;
    }
    .air {
      grid-template: minmax(0, 1fr) auto auto / minmax(0, 1fr) minmax(0, 1.8fr) minmax(0, 1fr);
    }
    .air omote-monitor,
    .air omote-head-frames,
    .air omote-characters {
      grid-area: 1 / 2;
    }
    .air omote-characters {
      align-self: end; /* on the collar: the face stays in sight */
      margin-left: 0;
    }
    omote-show-notices {
      grid-column: 1 / 4;
    }
    .mixes {
      display: contents;
    }
    .mixes omote-mix {
      grid-area: 1 / 1;
    }
    .mixes omote-mix + omote-mix {
      grid-area: 1 / 3;
    }
    .hands,
    omote-bank,
    omote-scene-panel,
    omote-pad-panel,
    omote-layer-panel {
      grid-area: below;
    }
    .views {
      display: flex;
    }
    .faces,
    .expressions {
      --tile: 62px;
    }
    .views [data-view="palettes"],
    :host(:not([data-view="faders"])) omote-bank,
    :host(:not([data-view="pads"])) .hands {
      display: none;
    }
  }
  /* palettes, faders or pads at a time */
  @media ${narrow} or ${low} {
    .air {
      grid-template: minmax(0, 1fr) auto auto auto / repeat(2, minmax(0, 1fr));
    }
    .air omote-monitor,
    .air omote-head-frames,
    .air omote-characters {
      grid-area: 1 / 1 / 2 / 3;
    }
    .air omote-characters {
      align-self: end;
      margin-left: 0;
    }
    omote-show-notices {
      grid-column: 1 / 3;
    }
    .mixes {
      display: contents;
    }
    .mixes omote-mix {
      grid-area: 4 / 1;
    }
    .mixes omote-mix + omote-mix {
      grid-area: 4 / 2;
    }
    .hands,
    omote-bank,
    omote-scene-panel,
    omote-pad-panel,
    omote-layer-panel {
      grid-area: faces / faces-start / expressions / expressions-end;
    }
    .views {
      display: flex;
    }
    .views [data-view="palettes"] {
      display: block;
    }
    :host(:not([data-view="pads"])) omote-memories {
      display: none; /* they stand with the pads */
    }
    :host(:not([data-view="palettes"])) omote-palette,
    :host(:not([data-view="pads"])) .hands,
    :host(:not([data-view="faders"])) omote-bank {
      display: none;
    }
  }
  @media (min-width: 600px) and (max-height: 379px) {
    omote-show-notices {
      display: none; /* the picture is as low as they are: *Log* lights up and counts them */
    }
    :host(.several) .mixes omote-mix {
      display: none; /* the keys of the characters have their room */
    }
  }
  @media ${upright} {
    .air omote-monitor,
    .air omote-head-frames,
    .mixes omote-mix {
      margin-top: var(--said, 0); /* what the bar has no room to say stands there */
    }
  }
  @media ${narrow} {
    .mixes omote-mix {
      margin-top: 0;
    }
    :host(.says) omote-show-notices {
      display: none; /* they stand there again in seconds; *Log* counts them meanwhile */
    }
    :host {
      grid-template:
        "status status status status" 52px
        "facebar air air exprbar" minmax(210px, 42fr)
        "lights lights lights lights" auto
        "views views views views" 44px
        "faces faces expressions expressions" minmax(0, 58fr) / 72px minmax(0, 1fr) minmax(0, 1fr) 72px;
    }
    .faces,
    .expressions {
      --tile: 50px;
    }
  }
  @media ${low} {
    :host {
      gap: 4px;
      padding: 4px;
      grid-template:
        "status status status status status" 48px
        "facebar air faces expressions exprbar" minmax(0, 1fr)
        "facebar lights faces expressions exprbar" auto
        "facebar views faces expressions exprbar" auto / 72px minmax(132px, 0.9fr) minmax(0, 1fr) minmax(0, 1fr) 72px;
    }
    .faces,
    .expressions {
      --tile: 50px;
    }
    .views {
      gap: 4px;
    }
    .views button {
      flex: 1 1 0;
      min-height: 40px;
      padding: 0;
      font-size: 12px;
    }
    .views span,
    .views :is([data-view="scene"], [data-view="layers"]) {
      display: none; /* their keys stand with the characters */
    }
  }
  @media ${low} {
    @media (max-width: 779px) {
      .views [data-view="blend_pads"] {
        display: none; /* no room for four: its key stands with the characters */
      }
    }
  }
  @media (max-width: 389px) {
    .views {
      gap: 3px;
    }
    .views button {
      padding: 0;
      font-size: 12px;
    }
    .views span {
      display: none;
    }
  }
  /* the lowest phones: lights stand with the pads */
  @media ${narrow} and (max-height: 600px) {
    :host {
      gap: 4px;
      padding: 4px;
      grid-template-rows: 46px minmax(186px, 42fr) auto 40px minmax(0, 58fr);
    }
    .views button {
      min-height: 40px;
    }
    :host(:not([data-view="pads"])) .looks,
    :host(.several) omote-show-notices,
    omote-memories {
      display: none;
    }
  }
`;
