/** The curve of one half of a target: drawn, its knots under a hand, and where the hand of its macro is now. */

import { css, html, svg } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import type { HalfBelow, MacroTarget } from "../../link/messages";
import { ARROWS, onDrag } from "../../ui/gestures";
import { base } from "../../ui/theme";
import { FINE, fractionOf } from "../../ui/travel";
import {
  drawnRange,
  type Half,
  halfOf,
  movedKnot,
  reading,
  targetAt,
  withKnotAt,
  withKnots,
  withoutKnot,
} from "./macro_targets";
import { MappingsElement } from "./mappings_element";
import { curveAt, type Knot, type Knots, pathOf } from "./monotone_curve";

/** What a hand made of a curve: `over` once it has let go. */
export type CurveChanged = CustomEvent<{ readonly target: MacroTarget; readonly over: boolean }>;

/** A pointer this near to a knot takes it, in pixels. */
const NEAR = 26;
const STEP = 0.02;

const style = css`
  :host {
    display: grid;
    grid-template-rows: minmax(0, 1fr) 14px;
    min-width: 0;
    overflow: clip; /* the line of the value now is moved by its own width: a page that is as narrow would grow */
    overflow-clip-margin: 12px; /* as far as knots stick out */
  }
  .plot {
    position: relative;
    height: 128px;
    margin: 7px 8px 3px;
    border: 1px solid var(--line);
    background: #000;
    cursor: crosshair;
    touch-action: none;
  }
  svg {
    position: absolute;
    inset: 0;
    width: 100%;
    height: 100%;
    overflow: visible;
  }
  path,
  line {
    fill: none;
    vector-effect: non-scaling-stroke;
  }
  .curve {
    stroke: var(--hand);
    stroke-width: 1.75;
  }
  .zero {
    stroke: var(--edge);
    stroke-dasharray: 3 3;
  }
  .knot {
    position: absolute;
    width: 15px;
    height: 15px;
    margin: 0 0 -7.5px -7.5px;
    border: 2px solid var(--hand);
    border-radius: 50%;
    background: var(--ground);
    pointer-events: none;
  }
  .knot.fixed {
    border-radius: 2px;
    border-color: var(--dim);
  }
  .knot.chosen {
    background: var(--hand);
  }
  .now {
    position: absolute;
    inset: 0;
    z-index: 1;
    pointer-events: none;
  }
  .now[hidden] {
    display: none;
  }
  .now::before {
    content: "";
    position: absolute;
    inset: 0 auto 0 0;
    width: 1px;
    background: var(--air-deep);
  }
  .at {
    position: absolute;
    inset: 0;
  }
  .at::after {
    content: "";
    position: absolute;
    left: -5px;
    bottom: -5px;
    width: 10px;
    height: 10px;
    border-radius: 50%;
    background: var(--air);
  }
  .ends {
    display: flex;
    justify-content: space-between;
    margin: 0 8px;
    font-size: 11px;
    line-height: 14px;
    color: var(--dim);
  }
`;

/** Tells `curve`: a knot is dragged, moved by keys, added or taken away. */
@customElement("omote-target-curve")
export class TargetCurve extends MappingsElement {
  @property({ attribute: false }) target!: MacroTarget;
  @property() half: Half = "above";
  /** The macro whose hand is shown. */
  @property() macro = "";
  @property() label = "";
  @state() private chosen = -1;
  @query(".plot") private plot!: HTMLElement;
  @query(".now") private now!: HTMLElement;
  @query(".at") private at!: HTMLElement;
  #held = false;

  static override styles = [base, style];

  get #shape(): HalfBelow {
    return halfOf(this.target, this.half) ?? { high: this.target.low, curve: [] };
  }

  /** 0..1 from the left and from the bottom of the picture, of a knot. */
  #place([at, gives]: Knot): readonly [number, number] {
    const { target } = this;
    const value = target.low + (this.#shape.high - target.low) * gives;
    return [this.half === "above" ? at : 1 - at, fractionOf(value, drawnRange(target))];
  }

  override render() {
    const { curve } = this.#shape;
    const drawn = drawnRange(this.target);
    const zero = fractionOf(0, drawn);
    const path = pathOf(curve, (at, gives) => {
      const [x, y] = this.#place([at, gives]);
      return [100 * x, 100 * (1 - y)];
    });
    return html`<div class="plot" data-half=${this.half} title="Drag a knot; press twice to add one, or on one to take it away">
        <svg viewBox="0 0 100 100" preserveAspectRatio="none" aria-hidden="true">
          ${zero > 0 && zero < 1 ? svg`<line class="zero" x1="0" x2="100" y1=${100 * (1 - zero)} y2=${100 * (1 - zero)} />` : ""}
          <path class="curve" d=${path} /></svg>
        <div class="now" hidden><div class="at"></div></div>
        ${curve.map((knot, place) => this.#knot(knot, place))}
      </div>
      <div class="ends"><span>${this.half === "above" ? "0" : "−100"}</span><span>${this.half === "above" ? "100" : "0"}</span></div>`;
  }

  #knot(knot: Knot, place: number) {
    const [x, y] = this.#place(knot);
    const { to, low } = this.target;
    const value = reading(to, low + (this.#shape.high - low) * knot[1]);
    const at = Math.round(100 * knot[0]) * (this.half === "above" ? 1 : -1);
    return html`<div class="knot ${place === 0 ? "fixed" : ""} ${place === this.chosen ? "chosen" : ""}" tabindex="0" role="slider" data-knot=${place}
      aria-label="Knot ${place + 1} of ${this.label}${this.half === "above" ? "" : " below zero"}" aria-valuenow=${(100 * knot[1]).toFixed(0)}
      aria-valuetext="${value} where the macro is at ${at}" style="left:${(100 * x).toFixed(2)}%;bottom:${(100 * y).toFixed(2)}%"
      @focus=${() => (this.chosen = place)} @keydown=${(event: KeyboardEvent) => this.#key(event, place)} @keyup=${this.#let}></div>`;
  }

  override firstUpdated(): void {
    let [place, at, gives] = [-1, 0, 0];
    onDrag(this.plot, {
      start: (x, y) => {
        place = this.#nearest(x, y);
        [at, gives] = this.#shape.curve[place] ?? [0, 0];
        if (place >= 0) this.#focus(place);
      },
      move: (dx, dy) => {
        if (place < 0) return;
        at += this.half === "above" ? dx : -dx;
        gives += this.#rising(dy);
        this.#move(place, [at, gives]);
      },
      end: () => this.#let(),
      double: () => {
        if (place > 0) this.removeKnot(place);
        else if (place < 0) this.addKnot(this.#touched);
        place = -1;
      },
    });
  }

  /** Where a pointer came down last, 0..1 of the macro's way. */
  #touched = 0.5;

  #nearest(x: number, y: number): number {
    const { width, height } = this.plot.getBoundingClientRect();
    this.#touched = this.half === "above" ? x : 1 - x;
    const away = this.#shape.curve.map((knot) => {
      const [left, bottom] = this.#place(knot);
      return Math.hypot((left - x) * width, (bottom - y) * height);
    });
    const least = Math.min(...away);
    return least <= NEAR ? away.indexOf(least) : -1;
  }

  /** How much of the way from `low` a part of the picture's height is. */
  #rising(dy: number): number {
    const { low, high } = drawnRange(this.target);
    const way = this.#shape.high - this.target.low;
    return way === 0 ? 0 : (dy * (high - low)) / way;
  }

  #key(event: KeyboardEvent, place: number): void {
    const arrow = ARROWS[event.key];
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    if (arrow !== undefined) {
      const step = STEP * (event.shiftKey ? FINE : 1);
      const [at, gives] = this.#shape.curve[place] as Knot;
      const across = this.half === "above" ? arrow[0] : -arrow[0];
      this.#move(place, [at + across * step, gives + this.#rising(arrow[1] * step)]);
    } else if (event.key === "Delete" || event.key === "Backspace") this.removeKnot(place);
    else if (event.key === "Insert" || event.key === "+") this.addKnot();
    else return;
    event.preventDefault();
    event.stopPropagation();
  }

  /** Adds a knot on the curve: at a place of the macro's way, or in the widest gap. */
  addKnot(at?: number): void {
    const { curve } = this.#shape;
    const knots = withKnotAt(curve, at);
    this.#focus(knots.findIndex((knot, place) => knot[0] !== curve[place]?.[0]));
    this.#tell(knots, true);
  }

  /** Takes a knot away: the one that is chosen, or the last but one. */
  removeKnot(place = this.chosen > 0 ? this.chosen : this.#shape.curve.length - 2): void {
    this.#tell(withoutKnot(this.#shape.curve, place), true);
    this.chosen = -1;
  }

  #focus(place: number): void {
    this.chosen = place;
    void this.updateComplete.then(() => this.renderRoot.querySelector<HTMLElement>(`[data-knot="${place}"]`)?.focus());
  }

  #move(place: number, to: Knot): void {
    this.#held = true;
    this.#tell(movedKnot(this.#shape.curve, place, to), false);
  }

  readonly #let = (): void => {
    if (this.#held) this.#tell(this.#shape.curve, true);
    this.#held = false;
  };

  #tell(knots: Knots, over: boolean): void {
    const target = withKnots(this.target, this.half, knots);
    this.dispatchEvent(new CustomEvent("curve", { detail: { target, over } }));
  }

  override paint(now: number): void {
    const value = this.store.macro(this.macro).value(now);
    const here = this.half === "above" ? value >= 0 : value <= 0;
    if (this.now.hidden === here) this.now.hidden = !here;
    if (!here) return;
    const [x, y] = this.#place([Math.abs(value), curveAt(this.#shape.curve, Math.abs(value))]);
    this.write.style(this.now, "transform", `translateX(${(100 * x).toFixed(2)}%)`);
    this.write.style(this.at, "transform", `translateY(${(-100 * y).toFixed(2)}%)`);
    this.dataset.gives = targetAt(this.target, value).toFixed(3);
  }
}
