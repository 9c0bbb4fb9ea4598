import { css } from "lit";
import { ellipsis, entry } from "../../ui/theme";
import { low, narrow } from "../controls/screen_sizes";

/** Beside each other where there is room: characters and shots, the map, the place of one; else one below the other. */
export const style = css`
  :host {
    display: grid;
    grid-template-columns: minmax(300px, 1.25fr) minmax(200px, 1fr) minmax(250px, 0.9fr);
    grid-template-rows: minmax(0, 1fr);
    gap: 10px;
    padding: 8px 10px;
    min-height: 0;
    min-width: 0;
    overflow: hidden;
  }
  .who,
  omote-place-controls {
    min-height: 0;
    overflow: auto;
    scrollbar-width: thin;
  }
  .who {
    display: flex;
    flex-direction: column;
    gap: 5px;
  }
  header,
  .row,
  .shots {
    display: flex;
    align-items: center;
    gap: 6px;
    flex: none;
  }
  header label {
    margin-left: auto;
    white-space: nowrap;
  }
  .shots {
    flex-wrap: wrap;
    gap: 4px 6px;
  }
  input[type="text"],
  input[type="number"] {
    ${entry}
    min-height: 28px;
  }
  input[type="number"] {
    width: 58px;
    padding: 0 4px;
    text-align: right;
  }
  input[type="text"] {
    flex: 1 1 60px;
  }
  .row.off input[type="text"] {
    color: var(--dim);
    border-style: dashed;
  }
  input {
    accent-color: var(--hand);
  }
  input[type="checkbox"] {
    width: 22px;
    height: 22px;
    margin: 0;
    flex: none;
  }
  .move {
    width: 58px;
    flex: none;
  }
  .shot {
    position: relative;
    overflow: hidden;
    max-width: 160px;
    min-height: 28px;
  }
  .shot[data-size] span {
    text-transform: capitalize;
  }
  .shot span {
    display: block;
    ${ellipsis}
  }
  .shot i {
    position: absolute;
    inset: auto 0 0;
    height: 4px;
    background: var(--air);
    transform: scaleX(0);
    transform-origin: left;
  }
  @media (pointer: coarse) {
    .shot,
    input[type="text"],
    input[type="number"] {
      min-height: var(--finger);
    }
    input[type="checkbox"] {
      width: var(--finger);
      height: var(--finger);
    }
  }
  @media (max-width: 899px) {
    :host {
      grid-template-columns: minmax(250px, 1.2fr) minmax(130px, 0.8fr) minmax(220px, 1fr);
    }
  }
  @media ${narrow} or ${low} {
    :host {
      display: flex;
      flex-direction: column;
      overflow: auto;
      gap: 8px;
      padding: 6px 8px;
    }
    .who,
    omote-place-controls {
      overflow: visible;
      flex: none;
    }
    omote-place-map {
      flex: none;
      height: 170px;
    }
  }
`;
