import { css } from "lit";

export const style = css`
  :host {
    height: 100dvh;
    background: var(--ground);
    display: grid;
    gap: 6px;
    padding: 6px;
    grid-template:
      "status status status status status" 50px
      "faces facebar air exprbar expressions" minmax(0, 1fr)
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
    grid-template-rows: minmax(0, 1fr) auto auto;
    overflow: hidden;
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
  @media (max-width: 1100px) and (min-width: 800px) {
    :host {
      grid-template-columns: minmax(178px, 0.7fr) 78px minmax(260px, 1fr) 78px minmax(250px, 1fr);
    }
    .faces,
    .expressions {
      --tile: 56px;
    }
  }
  @media (max-width: 799px) {
    :host {
      height: auto;
      min-height: 100dvh;
      overflow: visible;
      grid-template:
        "status status" auto
        "air air" 420px
        "facebar exprbar" 340px
        "faces faces" auto
        "expressions expressions" auto
        "hands hands" 270px
        "bank bank" auto / minmax(0, 1fr) minmax(0, 1fr);
    }
    omote-status {
      position: sticky;
      top: 0;
      z-index: 5;
      background: var(--ground);
    }
    .faces,
    .expressions {
      max-height: 420px;
    }
  }
  @media (max-height: 640px) and (min-width: 800px) {
    :host {
      height: auto;
      overflow: visible;
      grid-template-rows: 50px 420px 230px;
    }
    omote-status {
      position: sticky;
      top: 0;
      z-index: 5;
      background: var(--ground);
    }
  }
`;
