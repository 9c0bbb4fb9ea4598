/** A pad as it is played: a point among looks, under finger, mouse, pen, wheel and keys. */

import { html, nothing } from "lit";
import { customElement, property, query } from "lit/decorators.js";
import { onArrows, onDrag, onWheel } from "../../ui/gestures";
import { base } from "../../ui/theme";
import { stepped, within } from "../../ui/travel";
import { otherStyle, paintOther } from "../controls/other_hand";
import type { Knob, PadAxis } from "../store/knob";
import { isPlaying } from "./pad_commands";
import { coverOf } from "./pad_cover";
import { across, PadFieldElement, placeAt, wayOf } from "./pad_field";
import { neutralPlace } from "./pad_layout";
import { padStyle } from "./pad_style";

const WAY = { low: -1, high: 1 };
/** A pointer this near to the dot (of the pad's width) takes it along; elsewhere the dot comes to the pointer. */
const NEAR = 0.12;
const STEP = 0.05;

/**
 * Looks at places, and a point among them whose mixture the characters show that this console plays. A hand takes the
 * point where it is and leaves it where it lets go; twice on the same place puts it back to the look at rest.
 */
@customElement("omote-blend-pad")
export class BlendPad extends PadFieldElement {
  /** What stands in its head says which pad it is. */
  @property({ type: Boolean }) bare = false;
  @query(".dot") private dot!: HTMLElement;
  @query(".depth") private slider!: HTMLElement | null;
  @query(".knob") private depthKnob!: HTMLElement | null;
  @query(".read") private read!: HTMLElement;
  @query(".other") private other!: HTMLElement;
  #at: number[] = [0, 0, 0];
  /** The panics there had been when the hand came: after another one it is off. */
  #begun = 0;
  /** The depth slider that is wired: it comes and goes with the dimensions. */
  #wired: HTMLElement | null = null;

  static override styles = [base, padStyle, otherStyle];

  override render() {
    const { name, looks } = this.pad;
    return html`<header>${this.bare ? nothing : this.heading()}<slot></slot><button title="The point to the look at rest (twice on the pad, Home)" @click=${() => this.#rest()}>Rest</button></header>
      <div class="well"><div class="square"><div class="field" role="slider" tabindex="0" aria-label="Pad ${name}" aria-valuemin="-1" aria-valuemax="1" aria-valuenow="0">
          ${this.ground}${looks.map((look, at) => this.picture(look, at))}
          <div class="carrier dot"></div><span class="read"></span><span class="other"></span>
        </div>${this.depthSlider}</div></div>`;
  }

  override focus(): void {
    this.field.focus();
  }

  #knob(axis: PadAxis): Knob {
    return this.store.pad(this.pad.name, axis);
  }

  get #knobs(): Knob[] {
    return this.axes.map((axis) => this.#knob(axis));
  }

  #place(now: number): number[] {
    return this.#knobs.map((knob) => knob.value(now));
  }

  protected override depth(now: number): number {
    return this.#knob("z").value(now);
  }

  override firstUpdated(): void {
    onDrag(this.field, {
      start: (x, y) => this.#take(x, y),
      move: (dx, dy) => this.#move([dx, dy]),
      end: () => this.#leave(this.#flat),
      double: () => this.#rest(),
    });
    onWheel(this.field, (steps) => this.#step(steps, this.axes.length - 1));
    onArrows(
      this.field,
      (dx, dy) => this.#arrow(dx, dy),
      () => this.#rest(),
    );
  }

  override updated(): void {
    super.updated();
    if (this.slider !== null && this.slider !== this.#wired) this.#wireDepth(this.slider);
    this.#wired = this.slider;
  }

  #wireDepth(slider: HTMLElement): void {
    onDrag(slider, {
      start: () => {
        this.#begun = this.store.era;
        this.#at[2] = this.depth(performance.now());
      },
      move: (_, dy) => {
        if (this.#begun !== this.store.era || dy === 0) return;
        const knob = this.#knob("z");
        if (!knob.gripped()) this.#at[2] = knob.value(performance.now());
        this.#at[2] = within((this.#at[2] as number) + 2 * dy, WAY);
        knob.grip(this.#at[2]);
      },
      end: () => this.#knob("z").leave(),
      double: () => this.#knob("z").nudge(neutralPlace(this.pad)[2] ?? 0),
    });
    onWheel(slider, (steps) => this.#step(steps, 2));
    onArrows(
      slider,
      (dx, dy) => this.#step(dx + dy, 2),
      () => this.#knob("z").nudge(0),
    );
  }

  /** The dimensions under the pointer. */
  get #flat(): Knob[] {
    return this.#knobs.slice(0, 2);
  }

  #take(x: number, y: number): void {
    this.#begun = this.store.era;
    const place = this.#place(performance.now());
    const pointer = [x, y].slice(0, this.#flat.length);
    const way = Math.hypot(...pointer.map((part, axis) => part - across(place[axis] as number)));
    this.#at = way > NEAR ? [...pointer.map(placeAt), ...place.slice(2)] : place;
    this.#grip();
  }

  #move(by: readonly number[]): void {
    if (this.#begun !== this.store.era) return;
    const knobs = this.#flat;
    if (!knobs[0]?.gripped()) this.#at = this.#place(performance.now()); // a lost link, another's hand: from what is on air
    for (const axis of knobs.keys()) this.#at[axis] = (this.#at[axis] as number) + wayOf(by[axis] as number);
    this.#grip();
  }

  #grip(): void {
    for (const [axis, knob] of this.#flat.entries()) {
      this.#at[axis] = within(this.#at[axis] as number, WAY);
      knob.grip(this.#at[axis]);
    }
  }

  #leave(knobs: readonly Knob[]): void {
    for (const knob of knobs) knob.leave();
  }

  #arrow(dx: number, dy: number): void {
    if (dx !== 0) this.#step(dx, 0);
    if (dy !== 0) this.#step(dy, Math.min(1, this.axes.length - 1));
  }

  /** One notch or key along a dimension. */
  #step(steps: number, axis: number): void {
    const knob = this.#knobs[axis];
    knob?.nudge(stepped(knob.stepFrom(performance.now()), steps * STEP, WAY, [0]));
  }

  #rest(): void {
    const rest = neutralPlace(this.pad);
    this.#at = [...rest];
    for (const [axis, knob] of this.#knobs.entries()) knob.nudge(rest[axis] ?? 0);
  }

  protected override paintHands(now: number): void {
    const { write } = this;
    const place = this.#place(now);
    const plays = isPlaying(this.store, this.pad.name) || this.#knobs.some((knob) => knob.counts(now));
    const { air, sources } = this.store;
    const cover = plays && air !== null ? coverOf(this.pad.part, air, sources) : { whole: false, words: "" };
    const shows = plays && !cover.whole;
    const [x, y = 0] = place as [number, number?];
    write.style(
      this.dot,
      "transform",
      `translate(${(100 * (across(x) - 0.5)).toFixed(3)}%, ${(100 * (0.5 - across(y))).toFixed(3)}%)`,
    );
    write.flag(this.dot, "air", shows);
    write.flag(this.field, "idle", !shows);
    if (this.depthKnob !== null)
      write.style(this.depthKnob, "transform", `translateY(${(-46 * (place[2] ?? 0)).toFixed(2)}%)`);
    if (this.slider !== null) write.attribute(this.slider, "aria-valuenow", (place[2] ?? 0).toFixed(2));
    const words = this.wordsAt(place);
    const played = plays ? [cover.words, cover.whole ? "" : words].filter(Boolean).join(" · ") : "not playing";
    write.text(this.read, played);
    write.attribute(this.field, "aria-valuenow", x.toFixed(2));
    write.attribute(this.field, "aria-valuetext", shows ? played : `${words}; ${played}`);
    paintOther(write, this.other, this.store, this.#knob("x"), now);
  }
}
