/** A photograph with its points; the named ones are dragged, or moved by the arrow keys. */

import { css, html, LitElement, svg } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { ARROWS } from "../../../ui/gestures";
import { base } from "../../../ui/theme";
import { HANDLES, rowOf } from "./photograph_handles";
import type { FoundPhotograph, PhotographPoints } from "./photograph_points";

/** Of the face's size, what is seen around it. */
const AROUND = 0.35;
const MORE = 10;

/** A press that moves less, parts of the photograph, is a click. */
const STILL = 0.002;

/** What a hand does between press and release. */
interface Hand {
  readonly handle: number;
  readonly from: readonly [number, number];
  moved: boolean;
}

const style = css`
  :host {
    display: block;
    min-height: 0;
    overflow: hidden;
    background: #08090a;
  }
  svg {
    width: 100%;
    height: 100%;
    touch-action: none;
  }
  path {
    fill: none;
    stroke-linecap: round;
    vector-effect: non-scaling-stroke;
    pointer-events: none;
  }
  .all {
    stroke: #eafff2;
    stroke-width: 2.5px;
    opacity: 0.7;
  }
  .rim {
    stroke: #06140c;
    stroke-width: 15px;
  }
  .dot {
    stroke: var(--hand);
    stroke-width: 11px;
  }
  .chosen .dot {
    stroke: var(--coming);
  }
  .grasp {
    stroke: transparent;
    stroke-width: 26px;
    pointer-events: stroke;
    cursor: grab;
  }
  g:focus-visible {
    outline: none;
  }
  g:focus-visible .rim {
    stroke: var(--focus);
    stroke-width: 19px;
  }
  @media (pointer: coarse) {
    .grasp {
      stroke-width: 46px;
    }
  }
`;

/** Tells `set` when a point has been moved, `choose` with the handle that was taken. */
@customElement("omote-photograph")
export class PhotographView extends LitElement {
  @property({ attribute: false }) points!: PhotographPoints;
  @property({ attribute: false }) photograph = 0;
  @property({ attribute: false }) chosen = 0;
  /** Raised where points have changed. */
  @property({ attribute: false }) step = 0;
  @state() private hand: Hand | null = null;
  @query("svg") private drawing!: SVGSVGElement;

  static override styles = [base, style];

  get #seen(): FoundPhotograph {
    return this.points.all[this.photograph] as FoundPhotograph;
  }

  override render() {
    const { address, name, width, height } = this.#seen;
    const points = this.points.of(this.photograph);
    const place = (row: number): string =>
      `M${(points[3 * row] as number) * width} ${(points[3 * row + 1] as number) * height}h0`;
    const all = Array.from({ length: points.length / 3 }, (_, row) => place(row)).join("");
    return html`<svg viewBox=${this.#box()} role="group" aria-label="${name} with its points" @pointermove=${this.#move}
      @pointerup=${this.#up} @pointercancel=${this.#up}>
      ${svg`<image href=${address} width=${width} height=${height}></image><path class="all" d=${all}></path>
      ${HANDLES.map(([label], at) => this.#handle(label, at, place(rowOf(at))))}`}</svg>`;
  }

  #handle(label: string, at: number, place: string) {
    return svg`<g tabindex="0" role="button" aria-label=${label} aria-pressed=${at === this.chosen} data-handle=${at}
      class=${at === this.chosen ? "chosen" : ""} @pointerdown=${(event: PointerEvent) => this.#down(event, at)}
      @focus=${() => this.#choose(at)} @keydown=${(event: KeyboardEvent) => this.#key(event, at)}>
      <title>${label}</title><path class="rim" d=${place}></path><path class="dot" d=${place}></path>
      <path class="grasp" d=${place}></path></g>`;
  }

  /** What of the photograph is seen: the face as it was found, and what is around it. */
  #box(): string {
    const { points, width, height } = this.#seen;
    const along = (axis: number, size: number): [number, number] => {
      const places = Array.from({ length: points.length / 3 }, (_, row) => (points[3 * row + axis] as number) * size);
      return [Math.min(...places), Math.max(...places)];
    };
    const [[left, right], [top, bottom]] = [along(0, width), along(1, height)];
    const more = AROUND * Math.max(right - left, bottom - top);
    return [left - more, top - more, right - left + 2 * more, bottom - top + 2 * more].join(" ");
  }

  // --- hands ----------------------------------------------------------------------------------------------------------

  #down(event: PointerEvent, handle: number): void {
    if (event.button > 0 || this.hand !== null) return;
    this.drawing.setPointerCapture(event.pointerId);
    this.hand = { handle, from: this.#place(event), moved: false };
    this.#choose(handle);
  }

  readonly #move = (event: PointerEvent): void => {
    const { hand } = this;
    if (hand === null) return;
    const [x, y] = this.#place(event);
    const by = [x - hand.from[0], y - hand.from[1]] as const;
    if (!hand.moved && Math.hypot(...by) < STILL) return;
    this.#put(hand.handle, by, hand.moved);
    hand.moved = true;
  };

  readonly #up = (): void => {
    this.hand = null;
  };

  #key(event: KeyboardEvent, handle: number): void {
    const arrow = ARROWS[event.key];
    if (arrow === undefined || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    event.stopPropagation();
    const pixels = (event.shiftKey ? MORE : 1) / (this.drawing.getScreenCTM()?.a ?? 1);
    this.#put(handle, [(arrow[0] * pixels) / this.#seen.width, (-arrow[1] * pixels) / this.#seen.height], false);
  }

  /** Where a pointer is, in parts of the photograph. */
  #place({ clientX, clientY }: PointerEvent): [number, number] {
    const { x, y } = new DOMPoint(clientX, clientY).matrixTransform(this.drawing.getScreenCTM()?.inverse());
    return [x / this.#seen.width, y / this.#seen.height];
  }

  #put(handle: number, by: readonly [number, number], same: boolean): void {
    this.points.move(this.photograph, handle, by, same);
    this.requestUpdate();
    this.dispatchEvent(new CustomEvent("set"));
  }

  #choose(handle: number): void {
    if (handle !== this.chosen) this.dispatchEvent(new CustomEvent("choose", { detail: handle }));
  }
}
