/** The fader of one channel. */

import { html } from "lit";
import { customElement, property, query } from "lit/decorators.js";
import { type DraggedFader, faderDrag, onArrows, onDrag, onWheel } from "../../ui/gestures";
import { base } from "../../ui/theme";
import { CHANNEL, fractionOf, type Range, stepped, travelOf, UNIT, weightAt } from "../../ui/travel";
import type { Side } from "../store/channels";
import type { Knob } from "../store/knob";
import { AnimatedElement } from "./console_element";
import { channelFaderStyle, faderStyle } from "./fader_style";
import { otherStyle, paintOther } from "./other_hand";

const STEP = 0.05;
/** What reads .00 is not written. */
const LEAST_SHOWN = 0.005;

/** An upright fader under hand, wheel and arrows. */
export abstract class FaderElement extends AnimatedElement {
  protected readonly range: Range = UNIT;
  /** Values on which a step rests that would cross them. */
  protected readonly stops: readonly number[] = [];
  @query(".slot") protected slotElement!: HTMLElement;
  @query(".carrier") protected carrier!: HTMLElement;
  @query(".number") protected number!: HTMLElement;
  @query(".other") protected other!: HTMLElement;

  /** What a hand on it moves. */
  protected abstract readonly knob: Knob;

  /** Puts it to its rest. */
  protected abstract rest(): void;

  /** How the travel of a hand is made a value, and back. */
  protected get travel(): Partial<DraggedFader> {
    return {};
  }

  override firstUpdated(): void {
    const [knob, era, rest] = [() => this.knob, () => this.store.era, () => this.rest()];
    onDrag(this.slotElement, faderDrag({ knob, era, range: this.range, rest, ...this.travel }));
    onWheel(this.slotElement, (steps) => this.#step(steps));
    onArrows(this.slotElement, (dx, dy) => this.#step(dx + dy), rest);
  }

  #step(steps: number): void {
    this.knob.nudge(stepped(this.knob.stepFrom(performance.now()), steps * STEP, this.range, this.stops));
  }
}

/** The fader of one channel, -0.5..1.5, with rests at 0 and 1: the handle is the hand's, the red column is on air. */
@customElement("omote-fader")
export class Fader extends FaderElement {
  protected override readonly range = CHANNEL;
  protected override readonly stops = [0, 1];
  @property() channel = "";
  @property() side: Side | null = null;
  @query(".fill") private fill!: HTMLElement;
  @query(".gaze") private gaze!: HTMLElement;
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

  protected override get knob(): Knob {
    return this.store.channel(this.channel);
  }

  protected override rest(): void {
    this.knob.nudge(0);
  }

  protected override get travel(): Partial<DraggedFader> {
    return { travelOf, valueAt: weightAt };
  }

  /** What the channel has on air: what sources and hands make together where a source plays, else the hand's. */
  #onAir(weight: number): number {
    const { air } = this.store;
    return air === null || (air.held ?? null) === null ? weight : (air.channels[this.channel] ?? 0);
  }

  paint(now: number): void {
    const { write } = this;
    this.#shown ??= this.store.channel(this.channel, false);
    const weight = this.#shown.value(now);
    const air = this.#onAir(weight);
    const displayed = weight === 0 ? air : weight;
    const text = Math.abs(displayed) < LEAST_SHOWN ? "" : displayed.toFixed(2).replace(/^(-?)0\./, "$1.");
    write.style(this.carrier, "transform", `translateY(${-100 * fractionOf(weight, CHANNEL)}%)`);
    write.style(this.fill, "transform", `scaleY(${(air / (CHANNEL.high - CHANNEL.low)).toFixed(4)})`);
    const lid = Math.max(this.store.air?.added[this.channel] ?? 0, 0);
    write.style(this.gaze, "transform", `scaleY(${lid / (CHANNEL.high - CHANNEL.low)})`);
    write.text(this.number, text || (this.side === null ? "" : this.side === "left" ? "L" : "R"));
    write.flag(this.number, "touched", weight !== 0);
    write.flag(this.number, "driven", weight === 0 && text !== "");
    write.flag(this.carrier, "touched", weight !== 0);
    write.attribute(this.slotElement, "aria-valuenow", weight.toFixed(2));
    paintOther(write, this.other, this.store, this.#shown, now);
  }
}
