import { css } from "lit";
import { caption, entry, flow, portrait, thinBar } from "../../ui/theme";
import { short } from "../controls/screen_sizes";

export const style = css`
  :host {
    container-type: inline-size;
    display: grid;
    grid-template: "head" auto "tiles" minmax(0, 1fr) "regions" auto "timing" auto / minmax(0, 1fr);
    gap: 8px;
    padding: 8px;
    min-height: 0;
    min-width: 0;
  }
  header {
    grid-area: head;
    ${flow}
    gap: 4px 6px;
    min-height: 26px;
  }
  h2 {
    flex: 1;
  }
  .tabs {
    display: flex;
    gap: 2px;
  }
  .tabs button {
    padding: 0 7px;
    font-size: 12px;
  }
  .tabs button[aria-selected="true"] {
    background: var(--raised);
    color: var(--text);
    border-color: var(--edge);
  }
  input {
    ${entry}
    font-size: 12px;
    width: 78px;
    flex: 1 1 60px;
    min-height: 26px;
  }
  input::placeholder {
    color: var(--faint);
  }
  .kinds {
    display: none;
    flex: 1 1 100px;
    min-width: 0;
  }
  @container (max-width: 260px) {
    h2 {
      display: none;
    }
    .kinds {
      display: block;
      flex: 1.2 1 56px;
    }
    .kinds + .tabs {
      display: none;
    }
    input {
      flex: 1 1 44px;
      padding: 0 6px;
    }
  }
  @media (pointer: coarse) {
    :host(.expressions) {
      grid-template:
        "head regions" auto "tiles tiles" minmax(0, 1fr) "timing timing" auto /
        minmax(0, 1fr) minmax(42px, 28%);
      column-gap: 6px;
    }
    omote-regions {
      align-self: start;
      height: 40px;
    }
    @container (max-width: 200px) {
      :host(.expressions) :is(.kinds, input) {
        flex: 1 1 40px; /* with the regions three in a row */
        padding: 0 2px;
      }
      /* no arrows: the names of the kinds are read in full */
      :host(.expressions) .kinds {
        appearance: none;
        font-size: 11px;
        letter-spacing: -0.03em;
      }
      :host(.expressions) input {
        flex: 0 0 40px;
      }
    }
    @container (max-width: 520px) {
      .kinds {
        display: block;
      }
      .kinds + .tabs {
        display: none;
      }
    }
    .tile {
      min-height: 40px;
    }
  }
  omote-regions {
    grid-area: regions;
  }
  omote-timing {
    grid-area: timing;
  }
  .tiles {
    grid-area: tiles;
    display: grid;
    grid-template-columns: repeat(auto-fill, minmax(var(--tile, 72px), 1fr));
    grid-auto-rows: max-content;
    align-content: start;
    align-items: start;
    gap: 5px;
    overflow: hidden auto;
    min-height: 0;
    padding: 2px;
    margin: -2px;
    scrollbar-width: thin;
    scrollbar-color: var(--edge) transparent;
    overscroll-behavior: contain;
  }
  .tiles[hidden] {
    display: none;
  }
  omote-clip-tiles,
  omote-pose-tiles {
    grid-area: tiles;
  }
  .tiles.more {
    mask-image: linear-gradient(#000 calc(100% - 34px), #0004);
  }
  .place {
    position: relative;
    min-width: 0;
  }
  .region {
    grid-column: 1 / -1;
    font-size: 10px;
    letter-spacing: 0.12em;
    text-transform: uppercase;
    color: var(--faint);
    padding-top: 2px;
  }
  .tile {
    position: relative;
    display: block;
    width: 100%;
    padding: 0;
    overflow: hidden;
    border: 2px solid var(--line);
    border-radius: 5px;
    background: #000;
    color: var(--text);
    -webkit-touch-callout: none;
  }
  .tile canvas {
    display: block;
    width: 100%;
    aspect-ratio: 13 / 12;
    pointer-events: none;
    ${portrait}
  }
  .tile .name {
    ${caption}
  }
  .menu {
    position: absolute;
    right: 0;
    top: 0;
    display: grid;
    place-content: center;
    width: 28px;
    height: 28px;
    min-width: 0;
    min-height: 0;
    padding: 0;
    border: 0;
    background: none;
    color: var(--text);
  }
  .menu span {
    width: 20px;
    line-height: 20px;
    text-align: center;
    border-radius: 50%;
    background: #000a;
  }
  .menu:not(:focus-visible) {
    opacity: 0;
  }
  @media (hover: hover) {
    .place:hover .menu {
      opacity: 1;
    }
    .menu:hover span {
      color: #000;
      background: var(--hand);
    }
  }
  @media (pointer: coarse) {
    .menu {
      pointer-events: none; /* a finger holds the tile */
    }
  }
  .tile .key {
    position: absolute;
    left: 3px;
    top: 3px;
    min-width: 15px;
    font-size: 10px;
    line-height: 14px;
    text-align: center;
    border-radius: 3px;
    background: #000c;
    color: var(--text);
  }
  .tile .where {
    position: absolute;
    right: 3px;
    top: 3px;
    padding: 0 3px;
    font-size: 10px;
    line-height: 14px;
    border-radius: 3px;
    background: var(--air-deep);
    color: #fff;
  }
  .tile .where:empty {
    display: none;
  }
  .tile .weight {
    ${thinBar}
    background: var(--air);
  }
  @media (pointer: coarse) and (max-width: 599px) {
    .tile .key {
      display: none; /* no keyboard */
    }
  }
  /* the smallest phones: one line of controls, as narrow as a finger */
  @media (pointer: coarse) and (max-width: 339px) {
    header {
      flex-wrap: nowrap;
      gap: 4px;
    }
    .kinds,
    input {
      flex: 1 1 var(--finger);
      min-width: var(--finger);
      padding: 0 3px;
    }
    :host(.expressions) {
      grid-template-columns: minmax(0, 1fr) 44px;
    }
  }
  .tile:active {
    border-color: var(--hand);
  }
  .tile.air {
    border-color: var(--air);
  }
  .tile.air .name {
    color: #fff;
    background: var(--air-deep);
  }
  .tile.coming {
    border-color: var(--coming);
  }
  .tile.coming .name {
    color: #fff;
    background: var(--coming-deep);
  }
  .tile.coming .weight {
    background: var(--coming);
  }
  .none {
    grid-column: 1 / -1;
    color: var(--faint);
    padding: 12px 4px;
  }
  .none a {
    color: var(--text);
  }
  @media ${short} {
    :host {
      gap: 4px;
      padding: 6px;
    }
    .tile .name {
      padding: 1px 0 3px;
      font-size: 10.5px;
      letter-spacing: -0.02em;
    }
  }
`;
