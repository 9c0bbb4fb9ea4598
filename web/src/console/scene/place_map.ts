/** The stage from above: who stands where, and a hand on each to drag it; the audience is below. */

import { css, html, svg } from "lit";
import { customElement, property, query } from "lit/decorators.js";
import type { CharacterState, Place } from "../../link/messages";
import { ARROWS } from "../../ui/gestures";
import { base } from "../../ui/theme";
import { AnimatedElement } from "../controls/console_element";
import type { Topic } from "../store/page_store";
import { type Extent, extentOf, type Placing } from "./placing";

/** Half the width of a head of size 1 on the map, metres. */
const RADIUS = 0.11;
/** Metres that an arrow key moves; a tenth of it with Shift. */
const STEP = 0.05;
const FARTHEST = { x: 10, depth: 20 };

const style = css`
  :host {
    min-height: 0;
    min-width: 0;
    position: relative;
  }
  svg {
    position: absolute;
    inset: 0;
    width: 100%;
    height: 100%;
    border-radius: 4px;
    background: #000;
    touch-action: none;
  }
  g[data-character] {
    cursor: grab;
  }
  .reach {
    fill: transparent;
  }
  .head {
    fill: var(--raised);
    stroke: var(--dim);
    stroke-width: 0.02;
  }
  .nose {
    fill: var(--dim);
  }
  g.played .head {
    stroke: var(--hand);
    stroke-width: 0.04;
  }
  g.played .nose {
    fill: var(--hand);
  }
  g.off {
    opacity: 0.45;
  }
  g.off .head {
    stroke-dasharray: 0.05 0.04;
  }
  text {
    font-size: 0.12px;
    fill: var(--text);
    text-anchor: middle;
    pointer-events: none;
  }
  .line {
    stroke: var(--line);
    stroke-width: 0.008;
  }
  .front {
    stroke: var(--edge);
    stroke-width: 0.015;
  }
  g[data-character]:focus {
    outline: none; /* its width would be in metres */
  }
  g[data-character]:focus-visible .head {
    stroke: var(--focus);
  }
`;

/** A map of the stage; `placing` puts who is dragged. */
@customElement("omote-place-map")
export class PlaceMap extends AnimatedElement {
  @property({ attribute: false }) placing!: Placing;
  @query("svg") private picture!: SVGSVGElement;
  /** The pointer that drags, whom, and from where to the middle of it, metres. */
  #drag: { readonly pointer: number; readonly name: string; readonly offset: readonly [number, number] } | null = null;
  #extent: Extent = extentOf([]);

  static override styles = [base, style];

  protected override readonly topics: readonly Topic[] = ["characters"];

  override render() {
    const characters = Object.entries(this.store.state?.characters ?? {});
    return html`<svg role="group" aria-label="The stage from above" preserveAspectRatio="xMidYMid meet"
      @pointerdown=${this.#down} @pointermove=${this.#move} @pointerup=${this.#up} @pointercancel=${this.#up}>
      <g class="grid">${grid()}</g>
      ${characters.map(([name, character]) => this.#mark(name, character))}
    </svg>`;
  }

  #mark(name: string, { label, presence, leaves }: CharacterState) {
    const { played } = this.store;
    const of = [played.names.includes(name) ? "played" : "", presence > 0 && !leaves ? "" : "off"].join(" ");
    return svg`<g data-character=${name} class=${of} tabindex="0" role="button" aria-label="Place of ${label}; arrows move it"
      @keydown=${(event: KeyboardEvent) => this.#key(event, name)} @keyup=${this.#keyUp}>
      <circle class="reach" r="0.2"></circle>
      <g class="body"><circle class="head" r=${RADIUS}></circle><path class="nose" d="M -0.04 0.1 L 0.04 0.1 L 0 0.17 Z"></path></g>
      <text y="-0.15">${label}</text>
    </g>`;
  }

  paint(): void {
    const characters = this.store.state?.characters ?? {};
    if (this.picture === null || this.offsetParent === null) return;
    const placeOf = (name: string): Place | undefined =>
      this.placing.held?.character === name ? this.placing.held.now : characters[name]?.place;
    if (this.#drag === null) this.#extent = extentOf(Object.values(characters).map(({ place }) => place));
    this.write.attribute(this.picture, "viewBox", this.#extent.map((value) => value.toFixed(3)).join(" "));
    for (const mark of this.renderRoot.querySelectorAll<SVGGElement>("g[data-character]")) {
      const place = placeOf(mark.dataset.character ?? "");
      if (place !== undefined) this.#stand(mark, place);
    }
  }

  #stand(mark: SVGGElement, { x, depth, size, turn }: Place): void {
    this.write.attribute(mark, "transform", `translate(${x.toFixed(3)} ${(-depth).toFixed(3)})`);
    const degrees = ((-turn * 180) / Math.PI).toFixed(1);
    const body = mark.querySelector(".body") as Element;
    this.write.attribute(body, "transform", `rotate(${degrees}) scale(${Math.sqrt(size).toFixed(3)})`);
  }

  readonly #down = (event: PointerEvent): void => {
    const mark = (event.target as Element).closest<SVGGElement>("g[data-character]");
    const name = mark?.dataset.character;
    const place = name === undefined ? undefined : this.store.state?.characters[name]?.place;
    if (mark === null || name === undefined || place === undefined || event.button !== 0 || this.#drag !== null) return;
    event.preventDefault();
    mark.focus();
    this.picture.setPointerCapture(event.pointerId);
    if (event.shiftKey || !this.store.played.names.includes(name))
      this.store.play(this.store.played.pressed(name, event.shiftKey));
    const [x, depth] = this.#metres(event);
    this.#drag = { pointer: event.pointerId, name, offset: [place.x - x, place.depth - depth] };
  };

  readonly #move = (event: PointerEvent): void => {
    if (event.pointerId !== this.#drag?.pointer) return;
    const [x, depth] = this.#metres(event);
    this.#put(this.#drag.name, x + this.#drag.offset[0], depth + this.#drag.offset[1]);
  };

  readonly #up = (event: PointerEvent): void => {
    if (event.pointerId !== this.#drag?.pointer) return;
    this.#drag = null;
    this.placing.release();
  };

  #key(event: KeyboardEvent, name: string): void {
    const way = ARROWS[event.key];
    const place = this.store.state?.characters[name]?.place;
    if (event.key === "Enter" || event.key === " ") this.store.play(this.store.played.pressed(name, event.shiftKey));
    else if (way === undefined || place === undefined) return;
    else {
      const [{ x, depth }, step] = [this.#held(name) ?? place, event.shiftKey ? STEP / 10 : STEP];
      this.#put(name, x + way[0] * step, depth + way[1] * step);
    }
    event.preventDefault();
    event.stopPropagation();
  }

  readonly #keyUp = (): void => {
    if (this.#drag === null) this.placing.release();
  };

  #held = (name: string): Place | null => (this.placing.held?.character === name ? this.placing.held.now : null);

  #put(name: string, x: number, depth: number): void {
    const within = (value: number, low: number, high: number): number => Math.min(high, Math.max(low, value));
    this.placing.drag(name, {
      x: within(x, -FARTHEST.x, FARTHEST.x),
      depth: within(depth, 0, FARTHEST.depth),
    });
  }

  /** Where a pointer is on the stage: metres to the right, metres back. */
  #metres({ clientX, clientY }: PointerEvent): readonly [number, number] {
    const { x, y } = new DOMPoint(clientX, clientY).matrixTransform(this.picture.getScreenCTM()?.inverse());
    return [x, -y];
  }
}

/** Lines a half metre apart; the front line is stronger. */
function grid() {
  const steps = Array.from({ length: 41 }, (_, at) => (at - 20) / 2);
  return svg`${steps.map((at) => svg`<line class="line" x1=${at} x2=${at} y1="-20" y2="1"></line>`)}
    ${steps.filter((at) => at >= 0).map((at) => svg`<line class=${at === 0 ? "front" : "line"} x1="-10" x2="10" y1=${-at} y2=${-at}></line>`)}
    <text y="0.3">audience</text>`;
}
