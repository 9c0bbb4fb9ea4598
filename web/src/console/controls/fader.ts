/** The fader of one channel. */

import { html } from "lit";
import { customElement, property, query } from "lit/decorators.js";
import { faderDrag, onArrows, onDrag, onWheel } from "../../ui/gestures";
import { base } from "../../ui/theme";
import { CHANNEL, fractionOf, stepped, travelOf, weightAt } from "../../ui/travel";
import type { Side } from "../store/channels";
import type { Knob } from "../store/knob";
import { AnimatedElement, StyleWriter } from "./console_element";
import { channelFaderStyle, faderStyle } from "./fader_style";
import { otherStyle, paintOther } from "./other_hand";

const STEP = 0.05;
const STOPS = [0, 1];
/** What reads .00 is not written. */
const LEAST_TOLD = 0.005;

/** The fader of one channel, -0.5..1.5, with rests at 0 and 1: the handle is the hand's, the red column is on air. */
@customElement("omote-fader")
export class Fader extends AnimatedElement {
  @property() channel = "";
  @property() side: Side | null = null;
  @query(".slot") private slotElement!: HTMLElement;
  @query(".fill") private fill!: HTMLElement;
  @query(".gaze") private gaze!: HTMLElement;
  @query(".carrier") private carrier!: HTMLElement;
  @query(".number") private number!: HTMLElement;
  @query(".other") private other!: HTMLElement;
  readonly #written = new StyleWriter();
  #shown: Knob | null = null;

  static override styles = [base, faderStyle, channelFaderStyle, otherStyle];

  override render() {
    return html`
      <div class="number"></div>
      <div
        class="slot"
        role="slider"
        tabindex="0"
        aria-orientation="vertical"
        aria-valuemin=${CHANNEL.low}
        aria-valuemax=${CHANNEL.high}
        aria-label=${this.channel}
        data-channel=${this.channel}
      >
        <div class="tick" style="bottom:25%"></div>
        <div class="tick" style="bottom:75%"></div>
        <div class="groove"></div>
        <div class="fill"></div>
        <div class="gaze"></div>
        <div class="carrier"></div>
        <span class="other"></span>
      </div>
    `;
  }

  override firstUpdated(): void {
    const knob = () => this.store.channel(this.channel);
    const [era, rest] = [() => this.store.era, () => knob().nudge(0)];
    onDrag(this.slotElement, faderDrag({ knob, era, range: CHANNEL, travelOf, valueAt: weightAt, rest }));
    onWheel(this.slotElement, (steps) => this.#step(steps));
    onArrows(this.slotElement, (dx, dy) => this.#step(dx + dy), rest);
  }

  #step(steps: number): void {
    const knob = this.store.channel(this.channel);
    knob.nudge(stepped(knob.value(performance.now()), steps * STEP, CHANNEL, STOPS));
  }

  /** What the channel has on air: what sources and hands make together where a source plays, else the hand's. */
  #onAir(weight: number): number {
    const { air } = this.store;
    return air === null || (air.held ?? null) === null ? weight : (air.channels[this.channel] ?? 0);
  }

  paint(now: number): void {
    const write = this.#written;
    this.#shown ??= this.store.channel(this.channel, false);
    const weight = this.#shown.value(now);
    const air = this.#onAir(weight);
    const told = weight === 0 ? air : weight;
    const text = Math.abs(told) < LEAST_TOLD ? "" : told.toFixed(2).replace(/^(-?)0\./, "$1.");
    write.style(this.carrier, "transform", `translateY(${-100 * fractionOf(weight, CHANNEL)}%)`);
    write.style(this.fill, "transform", `scaleY(${(air / (CHANNEL.high - CHANNEL.low)).toFixed(4)})`);
    const lid = this.store.air?.lids[this.channel] ?? 0;
    write.style(this.gaze, "transform", `scaleY(${lid / (CHANNEL.high - CHANNEL.low)})`);
    write.text(this.number, text || (this.side === null ? "" : this.side === "left" ? "L" : "R"));
    write.flag(this.number, "touched", weight !== 0);
    write.flag(this.number, "driven", weight === 0 && text !== "");
    write.flag(this.carrier, "touched", weight !== 0);
    write.attribute(this.slotElement, "aria-valuenow", weight.toFixed(2));
    paintOther(write, this.other, this.store, this.#shown, now);
  }
}
