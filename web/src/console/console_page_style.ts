import { css } from "lit";

/**
 * The areas of the page. Wide: everything at once. A tablet held upright: faders or pads below. A phone: palettes, faders
 * or pads below. Panic, picture, T-bars and lights are always there, and the page itself never scrolls.
 */
export const style = css`
  :host {
    --finger: 40px;
    height: 100dvh;
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
  omote-status {
    grid-area: status;
  }
  .faces {
    grid-area: faces;
  }
  .facebar {
    grid-area: facebar;
  }
  .air {
    grid-area: air;
    display: grid;
    grid-template-rows: minmax(0, 1fr) auto;
    overflow: hidden;
  }
  omote-lights {
    grid-area: lights;
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
  :host(.lost) {
    box-shadow: inset 0 0 0 4px #d21f10;
  }
  :host(.lost) .live {
    opacity: 0.45;
    filter: grayscale(0.7);
  }
  @media (min-width: 1600px) {
    .faces,
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
      grid-template: minmax(0, 1fr) / minmax(0, 1fr) minmax(0, 1.8fr) minmax(0, 1fr);
    }
    .air omote-monitor {
      grid-area: 1 / 2;
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
    omote-bank {
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
    :host([data-view="pads"]) omote-bank,
    :host(:not([data-view="pads"])) .hands {
      display: none;
    }
  }
  /* a phone */
  @media (max-width: 599px) {
    :host {
      grid-template:
        "status status status status" 52px
        "facebar air air exprbar" minmax(0, 42fr)
        "lights lights lights lights" auto
        "views views views views" 44px
        "faces faces expressions expressions" minmax(0, 58fr) / 72px minmax(0, 1fr) minmax(0, 1fr) 72px;
    }
    .air {
      grid-template: minmax(0, 1fr) auto / repeat(2, minmax(0, 1fr));
    }
    .air omote-monitor {
      grid-area: 1 / 1 / 2 / 3;
    }
    .mixes omote-mix {
      grid-area: 2 / 1;
    }
    .mixes omote-mix + omote-mix {
      grid-area: 2 / 2;
    }
    .hands,
    omote-bank {
      grid-area: faces / 1 / expressions / -1;
    }
    .views [data-view="palettes"] {
      display: block;
    }
    :host(:not([data-view="palettes"])) omote-palette,
    :host(:not([data-view="faders"])) omote-bank {
      display: none;
    }
    .faces,
    .expressions {
      --tile: 50px;
    }
  }
  /* a low window scrolls, for nothing may be smaller than a hand */
  @media (max-height: 640px) and (min-width: 900px) {
    :host {
      grid-template-rows: 50px 420px auto 300px;
    }
  }
  @media (max-height: 640px) and (min-width: 600px) and (max-width: 899px) {
    :host {
      grid-template-rows: 52px 320px auto 320px 44px 300px;
    }
  }
  @media (max-height: 560px) and (max-width: 599px) {
    :host {
      grid-template-rows: 52px 260px auto 44px 380px;
    }
  }
  @media (max-height: 640px) and (min-width: 600px), (max-height: 560px) {
    :host {
      height: auto;
      overflow: visible;
    }
    omote-status {
      position: sticky;
      top: 0;
      z-index: 5;
      background: var(--ground);
    }
  }
`;
