import { css } from "lit";
import { ellipsis, portrait } from "../../ui/theme";

/** A pad as it is played and as it is edited. */
export const padStyle = css`
  :host {
    display: flex;
    flex-direction: column;
    gap: 4px;
    padding: 6px;
    min-width: 0;
    min-height: 0;
  }
  header {
    display: flex;
    align-items: center;
    gap: 4px;
    min-width: 0;
  }
  h2 {
    flex: 0 1 auto;
    min-width: 0;
    ${ellipsis}
    color: var(--text);
  }
  .part {
    flex: 1 1 0;
    min-width: 0;
    ${ellipsis}
    font-size: 11px;
    color: var(--faint);
  }
  header button,
  ::slotted(button) {
    flex: none;
    padding: 0 6px;
    font-size: 11px;
  }
  .well {
    flex: 1;
    min-height: 0;
    display: grid;
    place-items: center;
    container-type: size;
  }
  .square {
    display: grid;
    grid-template-columns: minmax(0, 1fr) auto;
    gap: 6px;
    width: min(100cqw, 100cqh);
    height: min(100cqw, 100cqh);
  }
  :host(.line) .square {
    width: 100cqw;
    height: min(100cqh, max(96px, 34cqw));
  }
  .field {
    position: relative;
    min-width: 0;
    container-type: size;
    border-radius: 6px;
    border: 1px solid var(--line);
    background: #000;
    touch-action: none;
    cursor: crosshair;
    overflow: hidden;
  }
  .fields {
    position: absolute;
    inset: 0;
    width: 100%;
    height: 100%;
    pointer-events: none;
  }
  .look {
    --near: 1;
    position: absolute;
    display: grid;
    justify-items: center;
    gap: 1px;
    width: clamp(30px, 17cqmin, 74px);
    translate: -50% -50%;
    opacity: var(--near);
    pointer-events: none;
  }
  :host(.line) .look {
    width: clamp(30px, min(50cqh, 14cqw), 74px);
  }
  .look canvas {
    width: 74%;
    aspect-ratio: 1;
    border-radius: 50%;
    border: 2px solid #000a;
    object-fit: cover;
    ${portrait}
  }
  .look span {
    max-width: max(56px, 24cqmin);
    padding: 0 3px;
    ${ellipsis}
    font-size: clamp(9px, 4cqmin, 12px);
    line-height: 1.25;
    border-radius: 3px;
    color: #fff;
    background: #0009;
  }
  .look.lost span {
    color: #000;
    background: var(--attention);
  }
  .carrier {
    position: absolute;
    inset: 0;
    pointer-events: none;
  }
  .dot::after {
    content: "";
    position: absolute;
    left: 50%;
    top: 50%;
    width: 26px;
    height: 26px;
    margin: -13px;
    border-radius: 50%;
    border: 3px solid var(--hand);
    background: #ffffff26;
    box-shadow:
      0 0 0 2px #000,
      inset 0 0 0 1px #000;
  }
  /* what shows is not what the pad has there: another played it since */
  .field.idle .fields {
    opacity: 0.35;
  }
  .field.idle .dot::after {
    border-style: dashed;
    background: none;
  }
  .dot.air::after {
    border-color: var(--air);
    background: #ff5a4540;
  }
  .depth {
    position: relative;
    width: 34px;
    border-radius: 6px;
    border: 1px solid var(--line);
    background: linear-gradient(var(--line), var(--line)) 0 50% / 100% 1px no-repeat, #000;
    touch-action: none;
    cursor: ns-resize;
    overflow: hidden;
  }
  .depth .knob::after {
    content: "";
    position: absolute;
    left: 3px;
    right: 3px;
    top: calc(50% - 7px);
    height: 14px;
    border-radius: 4px;
    border: 1px solid #000;
    background: linear-gradient(#565c64 0 40%, #c9ced4 40% 60%, #33383e 60%);
  }
  .read {
    position: absolute;
    left: 4px;
    right: 4px;
    bottom: 0;
    ${ellipsis}
    font-size: clamp(9px, 4cqmin, 11px); /* below the names of the lowest looks, on a small pad too */
    line-height: 1.2;
    color: #fff;
    text-shadow:
      0 0 3px #000,
      0 0 3px #000;
    pointer-events: none;
  }
`;
