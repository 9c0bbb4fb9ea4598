/** The T-bar: a call moved by hand. */

import { html } from "lit";
import { customElement, property, query } from "lit/decorators.js";
import { type Drag, faderDrag, onArrows, onDrag, onWheel } from "../../ui/gestures";
import { base } from "../../ui/theme";
import { UNIT } from "../../ui/travel";
import { type LookKind, mixLabel, mixOf } from "../store/axis";
import { remainingLabel } from "../store/timing";
import { BarKeys } from "./bar_keys";
import { AnimatedElement } from "./console_element";
import { otherStyle, paintOther } from "./other_hand";
import { style } from "./t_bar_style";
import { type BarView, barView } from "./t_bar_view";

/** The T-bar of an axis: the hand's handle, the value of the call beside it, and who is at which end. */
@customElement("omote-tbar")
export class TBar extends AnimatedElement {
  @property() axis: LookKind = "face";
  @query(".track") private track!: HTMLElement;
  @query(".hand") private hand!: HTMLElement;
  @query(".value") private value!: HTMLElement;
  @query(".way") private way!: HTMLElement;
  @query(".column") private column!: HTMLElement;
  @query(".top") private top!: HTMLElement;
  @query(".bottom") private bottom!: HTMLElement;
  @query(".percent") private percent!: HTMLElement;
  @query(".mode") private mode!: HTMLElement;
  @query(".other") private other!: HTMLElement;
  @query(".release") private release!: HTMLButtonElement;
  #view: BarView | null = null;
  #touched = false;
  readonly #keys = new BarKeys();

  static override styles = [base, style, otherStyle];

  override render() {
    const [name, short] = NAMES[this.axis];
    return html`
      <h2>${short}</h2>
      <div class="end top"></div>
      <div
        class="track"
        role="slider"
        tabindex="0"
        aria-orientation="vertical"
        aria-valuemin="0"
        aria-valuemax="1"
        aria-label="${name} T-bar"
      >
        <div class="ticks"></div>
        <div class="slot"></div>
        <div class="column"></div>
        <div class="carrier value"></div>
        <div class="carrier way"></div>
        <div class="carrier hand"></div>
        <span class="other"></span>
      </div>
      <div class="end bottom"></div>
      <div><div class="percent">&nbsp;</div><div class="mode"></div></div>
      <button class="release" title="Take the hand off: a timed call that it picked up runs on" @click=${() => this.store.release(this.axis)}>
        Release
      </button>
    `;
  }

  override firstUpdated(): void {
    onDrag(this.track, this.#drag());
    onWheel(this.track, (steps) => this.#step(steps * 0.04));
    onArrows(
      this.track,
      (dx, dy) => this.#step((dx + dy) * 0.02),
      () => this.#release(),
    );
  }

  #release(): void {
    if (this.store.releasable(this.axis)) this.store.release(this.axis);
  }

  #drag(): Drag {
    const [knob, era, rest] = [() => this.store.bar(this.axis), () => this.store.era, () => this.#release()];
    const drag = faderDrag({ knob, era, range: UNIT, rest });
    const touch = (touched: boolean): void => {
      this.#touched = touched;
    };
    return {
      ...drag,
      start: (x, y) => {
        touch(true);
        drag.start(x, y);
      },
      end: () => {
        touch(false);
        drag.end();
      },
    };
  }

  #step(by: number): void {
    const knob = this.store.bar(this.axis);
    knob.nudge(this.#keys.step(this.#view ?? IDLE, knob.stepFrom(performance.now()), by));
  }

  override focus(): void {
    this.track.focus();
  }

  paint(now: number): void {
    const position = this.store.bar(this.axis).value(now);
    const view = barView(this.store.callOf(this.axis), position, this.#touched, this.#view);
    this.#view = view;
    this.#paintTrack(view, position);
    this.#paintWords(view);
  }

  #paintTrack(view: BarView, position: number): void {
    const { write } = this;
    const [running, waiting] = [view.target !== null, view.mode === "waiting"];
    write.style(this.hand, "transform", `translateY(${-100 * position}%)`);
    write.flag(this.hand, "ghost", waiting);
    write.flag(this.hand, "held", view.mode === "held");
    write.style(this.value, "transform", `translateY(${-100 * view.value}%)`);
    write.flag(this.value, "shown", running);
    write.flag(this.way, "shown", waiting && Math.abs(view.gap) > 0.01);
    const low = Math.min(position, view.value);
    write.style(this.way, "transform", `translateY(${-100 * low}%) scaleY(${Math.abs(view.gap)})`);
    write.flag(this.column, "flipped", view.flipped);
    write.style(this.column, "transform", `scaleY(${running ? (view.flipped ? 1 - view.value : view.value) : 0})`);
    write.attribute(this.track, "aria-valuenow", position.toFixed(2));
    paintOther(write, this.other, this.store, this.store.bar(this.axis), performance.now());
  }

  #paintWords(view: BarView): void {
    const { write } = this;
    const call = this.store.callOf(this.axis);
    const [start, goal] = view.flipped ? [this.top, this.bottom] : [this.bottom, this.top];
    const label = (name: string) => this.store.label(this.axis, name);
    write.text(goal, call === null ? "" : label(call.target));
    write.text(start, mixLabel(call?.start ?? this.#mix, label));
    for (const end of [this.top, this.bottom]) {
      write.flag(end, "air", end === start);
      write.flag(end, "coming", end === goal && call !== null);
    }
    write.text(this.percent, call === null ? "–" : `${Math.round(call.progress * 100)} %`);
    write.text(this.mode, MODES[view.mode](call?.remaining ?? null, view.gap));
    write.flag(this.mode, "attention", view.mode === "waiting");
    const releasable = this.store.releasable(this.axis);
    write.flag(this.release, "lit", releasable);
    this.release.disabled = !releasable;
    const from = call === null ? "" : mixLabel(call.start, label).replaceAll("\n", ", ");
    const spoken =
      call === null ? "no call" : `from ${from} to ${label(call.target)}, ${Math.round(call.progress * 100)} per cent`;
    write.attribute(this.track, "aria-valuetext", spoken);
  }

  get #mix(): Readonly<Record<string, number>> {
    const { air: state } = this.store;
    return state === null ? {} : mixOf(state, this.axis);
  }
}

/** What a bar is called, and in short. */
const NAMES: Readonly<Record<LookKind, readonly [string, string]>> = {
  face: ["Face", "Face"],
  expression: ["Expression", "Expr."],
  pose: ["Pose", "Pose"],
};

/** Before the first picture of it. */
const IDLE = { target: null, flipped: false };

const MODES: Record<BarView["mode"], (remaining: number | null, gap: number) => string> = {
  idle: () => "",
  running: (remaining) => (remaining === null ? "" : `${remainingLabel(remaining)} s left`),
  waiting: (_, gap) => `pick up ${gap < 0 ? "▲" : "▼"}`,
  held: () => "by hand",
};
