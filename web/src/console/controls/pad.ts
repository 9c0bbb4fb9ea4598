/** The two-dimensional pads for head and gaze. */

import { html, nothing } from "lit";
import { customElement, property, query } from "lit/decorators.js";
import { onArrows, onDrag, onWheel } from "../../ui/gestures";
import { base } from "../../ui/theme";
import {
  fractionOf,
  GAZE_PITCH,
  GAZE_YAW,
  HEAD_PITCH,
  HEAD_ROLL,
  HEAD_YAW,
  type Others,
  Spring,
  valueAt,
  within,
} from "../../ui/travel";
import type { Knob } from "../store/knob";
import type { Topic } from "../store/page_store";
import { AnimatedElement } from "./console_element";
import { otherStyle, paintOther } from "./other_hand";
import { style } from "./pad_style";

/** A pointer this near to the dot (of the pad's width) takes it along; elsewhere the dot comes to the pointer. */
const NEAR = 0.12;
const STEP = 0.05;
/** Milliseconds for which a spring waits for a lost link; later the direction may belong to somebody else. */
const OWED = 3000;

/**
 * A direction of the head or of the gaze. The operator looks at the face, so right on the pad is the character's left
 * (+yaw): the face on screen turns to where the dot goes.
 */
@customElement("omote-pad")
export class Pad extends AnimatedElement {
  @property() what: "head" | "gaze" = "head";
  @query(".field") private field!: HTMLElement;
  @query(".dot") private dot!: HTMLElement;
  @query(".mark") private mark!: HTMLElement;
  @query(".tilt") private tilt!: HTMLElement | null;
  @query(".knob") private tiltKnob!: HTMLElement | null;
  @query(".features") private features!: SVGElement;
  @query(".skull") private skull!: SVGElement;
  @query(".read") private read!: HTMLElement;
  @query(".other") private other!: HTMLElement;
  #at: [number, number] = [0, 0];
  #roll = 0;
  readonly #spring = new Spring();
  #left = 0;

  static override styles = [base, style, otherStyle];

  override render() {
    const name = this.what === "head" ? "Head" : "Gaze";
    return html`
      <header>
        <h2>${name}</h2>
        <button
          aria-pressed=${this.springs}
          title="Back to the centre when the hand lets go"
          @click=${() => this.store.arrange({ springs: { ...this.store.arrangement.springs, [this.what]: !this.springs } })}
        >
          Spring
        </button>
        <button title="To the centre" @click=${() => this.#rest()}>Centre</button>
      </header>
      <div class="well">
        <div
          class="field"
          role="slider"
          tabindex="0"
          aria-label="${name}: as you see the face; right on the pad is the character's left"
          aria-valuenow="0"
          title="As you see the face: right on the pad is the character's left"
        >
          ${this.what === "head" ? HEAD_FIGURE : EYES_FIGURE}
          <span class="side" style="left:2px" title="The character's right">R</span>
          <span class="side" style="right:2px" title="The character's left">L</span>
          <span class="read"></span>
          <span class="other"></span>
          <div class="carrier mark" hidden></div>
          <div class="carrier dot"></div>
        </div>
      </div>
      ${
        this.what === "head"
          ? html`<div class="tilt" role="slider" tabindex="0" aria-label="Head tilt" aria-valuenow="0" title="Tilt: drag; twice to centre">
              <div class="carrier knob"></div>
            </div>`
          : nothing
      }
    `;
  }

  override focus(): void {
    this.field.focus();
  }

  protected override readonly topics: readonly Topic[] = ["arrangement"];

  private get springs(): boolean {
    return this.store.arrangement.springs[this.what];
  }

  get #yaw(): Knob {
    return this.what === "head" ? this.store.head("yaw") : this.store.gaze("yaw");
  }

  get #pitch(): Knob {
    return this.what === "head" ? this.store.head("pitch") : this.store.gaze("pitch");
  }

  get #ranges() {
    return this.what === "head" ? ([HEAD_YAW, HEAD_PITCH] as const) : ([GAZE_YAW, GAZE_PITCH] as const);
  }

  /** The dot's place, 0..1 from the left and from the bottom. */
  #place(now: number): [number, number] {
    const [yaw, pitch] = this.#ranges;
    return [fractionOf(this.#yaw.value(now), yaw), fractionOf(this.#pitch.value(now), pitch)];
  }

  #grip(): void {
    const [yaw, pitch] = this.#ranges;
    this.#at = [within(this.#at[0], SQUARE), within(this.#at[1], SQUARE)];
    this.#yaw.grip(valueAt(this.#at[0], yaw));
    this.#pitch.grip(valueAt(this.#at[1], pitch));
  }

  override firstUpdated(): void {
    this.#wireField();
    if (this.tilt) this.#wireTilt(this.tilt);
  }

  #wireField(): void {
    onDrag(this.field, {
      start: (x, y) => {
        this.#spring.grip(this.store.era);
        this.#at = this.#place(performance.now());
        if (Math.hypot(x - this.#at[0], y - this.#at[1]) > NEAR) this.#at = [x, y];
        this.#grip();
      },
      move: (dx, dy) => {
        if (!this.#spring.held(this.store.era)) return;
        if (!this.#yaw.gripped()) this.#at = this.#place(performance.now()); // nothing is pretended
        this.#at = [this.#at[0] + dx, this.#at[1] + dy];
        this.#grip();
      },
      end: () => this.#let(this.#yaw, this.#pitch),
      double: () => this.#rest(),
    });
    onWheel(this.field, (steps) => this.#step(0, steps));
    onArrows(
      this.field,
      (dx, dy) => this.#step(dx, dy),
      () => this.#rest(),
    );
  }

  #wireTilt(tilt: HTMLElement): void {
    const knob = () => this.store.head("roll");
    onDrag(tilt, {
      start: () => {
        this.#spring.grip(this.store.era);
        this.#roll = knob().value(performance.now());
      },
      move: (dx) => {
        if (!this.#spring.held(this.store.era)) return;
        if (!knob().gripped()) this.#roll = knob().value(performance.now());
        this.#roll = within(this.#roll + dx * (HEAD_ROLL.high - HEAD_ROLL.low), HEAD_ROLL);
        knob().grip(this.#roll);
      },
      end: () => this.#let(knob()),
      double: () => knob().nudge(0),
    });
    const step = (by: number) => knob().nudge(within(knob().stepFrom(performance.now()) + by * STEP, HEAD_ROLL));
    onWheel(tilt, step);
    onArrows(
      tilt,
      (dx, dy) => step(dx + dy),
      () => knob().nudge(0),
    );
  }

  #step(dx: number, dy: number): void {
    const now = performance.now();
    const [yaw, pitch] = this.#ranges;
    this.#spring.stop();
    if (dx !== 0) this.#yaw.nudge(within(this.#yaw.stepFrom(now) + dx * STEP, yaw));
    if (dy !== 0) this.#pitch.nudge(within(this.#pitch.stepFrom(now) + dy * STEP, pitch));
  }

  #rest(): void {
    this.#spring.stop();
    this.#at = [0.5, 0.5];
    this.#yaw.nudge(0);
    this.#pitch.nudge(0);
    if (this.what === "head") this.store.head("roll").nudge(0);
  }

  #let(...knobs: Knob[]): void {
    this.#left = performance.now();
    for (const knob of knobs) knob.leave();
    if (this.springs) this.#spring.release(knobs, this.#left, this.#others);
  }

  get #others(): Others {
    return { era: this.store.era, theirs: this.store.otherOn(this.#yaw) !== null };
  }

  paint(now: number): void {
    if (this.store.online) this.#spring.move(now, this.#others);
    else {
      this.#spring.wait(now);
      if (now - this.#left > OWED) this.#spring.stop();
    }
    this.#paintPlace(now);
  }

  /** Where head or gaze are on air, where sources play beside the hand. */
  #paintMark(): void {
    const { air } = this.store;
    const shown = air !== null && (air.held ?? null) !== null;
    this.mark.hidden = !shown;
    if (!shown) return;
    const [x, y] = this.#ranges.map((range, at) => within(fractionOf(air[this.what][at] ?? 0, range), SQUARE));
    const place = `translate(${(100 * ((x ?? 0) - 0.5)).toFixed(2)}%, ${(100 * (0.5 - (y ?? 0))).toFixed(2)}%)`;
    this.write.style(this.mark, "transform", place);
  }

  #paintPlace(now: number): void {
    const { write } = this;
    const [x, y] = this.#place(now);
    const [yaw, pitch] = [this.#yaw.value(now), this.#pitch.value(now)];
    const roll = this.what === "head" ? this.store.head("roll").value(now) : 0;
    write.style(this.dot, "transform", `translate(${100 * (x - 0.5)}%, ${100 * (0.5 - y)}%)`);
    write.flag(this.dot, "air", yaw !== 0 || pitch !== 0);
    this.#paintMark();
    const reach = this.what === "head" ? 22 : 9;
    write.style(this.features, "transform", `translate(${reach * 2 * (x - 0.5)}px, ${reach * 2 * (0.5 - y)}px)`);
    write.style(this.skull, "transform", `rotate(${(roll * 180) / Math.PI}deg)`);
    if (this.tiltKnob)
      write.style(this.tiltKnob, "transform", `translateX(${100 * (fractionOf(roll, HEAD_ROLL) - 0.5)}%)`);
    if (this.tilt) write.attribute(this.tilt, "aria-valuenow", roll.toFixed(2));
    paintOther(write, this.other, this.store, this.#yaw, now);
    const degrees = [yaw, pitch].map((angle) => Math.round((angle * 180) / Math.PI));
    write.text(this.read, yaw === 0 && pitch === 0 ? "" : `${degrees[0]}° ${degrees[1]}°`);
    write.attribute(this.field, "aria-valuetext", `${degrees[0]} degrees to the character's left, ${degrees[1]} up`);
    write.attribute(this.field, "aria-valuenow", yaw.toFixed(2));
  }
}

const SQUARE = { low: 0, high: 1 };

const HEAD_FIGURE = html`<svg viewBox="0 0 100 100" aria-hidden="true">
  <g class="skull" style="transform-origin: 50px 62px">
    <path d="M50 22C33 22 28 36 29 50C30 66 40 78 50 78C60 78 70 66 71 50C72 36 67 22 50 22Z" />
    <g class="features"><path d="M38 46H45M55 46H62M50 46L48 57H52M43 66Q50 69 57 66" /></g>
  </g>
</svg>`;

const EYES_FIGURE = html`<svg viewBox="0 0 100 100" aria-hidden="true">
  <g class="skull">
    <path d="M12 50Q28 34 44 50Q28 64 12 50ZM56 50Q72 34 88 50Q72 64 56 50Z" />
    <g class="features"><circle cx="28" cy="50" r="5" /><circle cx="72" cy="50" r="5" /></g>
  </g>
</svg>`;
