import { css, html } from "lit";
import { customElement, property, query } from "lit/decorators.js";
import { type BarView, barView } from "./bar";
import { onAir } from "./desk";
import { PaintedElement, Written } from "./element";
import { onArrows, onDrag, onWheel } from "./gesture";
import type { Axis } from "./keys";
import { UNIT, within } from "./scale";
import { base } from "./theme";
import { remainingLabel } from "./timing";

/** The T-bar of an axis: the hand's handle, the value of the call beside it, and who is at which end. */
@customElement("omote-tbar")
export class TBar extends PaintedElement {
  @property() axis: Axis = "face";
  @query(".track") private track!: HTMLElement;
  @query(".hand") private hand!: HTMLElement;
  @query(".value") private value!: HTMLElement;
  @query(".way") private way!: HTMLElement;
  @query(".column") private column!: HTMLElement;
  @query(".top") private top!: HTMLElement;
  @query(".bottom") private bottom!: HTMLElement;
  @query(".percent") private percent!: HTMLElement;
  @query(".mode") private mode!: HTMLElement;
  @query(".release") private release!: HTMLButtonElement;
  readonly #written = new Written();
  #view: BarView | null = null;
  #from = "";
  #position = 0;
  #era = 0;

  static override styles = [
    base,
    css`
      :host {
        display: grid;
        grid-template-rows: auto auto 1fr auto auto auto;
        gap: 4px;
        padding: 8px 6px;
        min-height: 0;
        text-align: center;
      }
      h2 {
        letter-spacing: 0.08em;
      }
      .end {
        overflow: hidden;
        text-overflow: ellipsis;
        white-space: nowrap;
        font-size: 12px;
        font-weight: 600;
        line-height: 18px;
        min-height: 18px;
        color: var(--faint);
        border-radius: 3px;
      }
      .end.air {
        color: var(--air);
      }
      .end.coming {
        color: var(--coming);
      }
      .track {
        position: relative;
        min-height: 120px;
        margin: 16px 0;
        touch-action: none;
        cursor: grab;
        border-radius: 4px;
      }
      .track:active {
        cursor: grabbing;
      }
      .slot {
        position: absolute;
        left: 50%;
        top: -14px;
        bottom: -14px;
        width: 14px;
        margin-left: -7px;
        border-radius: 7px;
        background: #000;
        border: 1px solid var(--line);
      }
      .ticks {
        position: absolute;
        inset: 0 4px;
        background: repeating-linear-gradient(to top, var(--line) 0 1px, transparent 1px 10%);
        border-top: 1px solid var(--line);
        opacity: 0.9;
      }
      .column {
        position: absolute;
        left: 50%;
        width: 8px;
        margin-left: -4px;
        top: 0;
        bottom: 0;
        border-radius: 4px;
        transform-origin: bottom;
        transform: scaleY(0);
        background: var(--coming);
      }
      .column.flipped {
        transform-origin: top;
      }
      .carrier {
        position: absolute;
        inset: 0;
        pointer-events: none;
        will-change: transform;
      }
      .value::after {
        content: "";
        position: absolute;
        left: 2px;
        right: 2px;
        bottom: -1px;
        height: 2px;
        background: var(--coming);
        opacity: 0;
      }
      .value.shown::after {
        opacity: 1;
      }
      .hand::after {
        content: "";
        position: absolute;
        left: 6px;
        right: 6px;
        bottom: -15px;
        height: 30px;
        border-radius: 5px;
        border: 1px solid #000;
        background: linear-gradient(
          #4a5058 0,
          #33383e 44%,
          var(--hand) 44%,
          var(--hand) 56%,
          #2b3035 56%,
          #22262b 100%
        );
        box-shadow:
          0 2px 6px #000c,
          inset 0 1px 0 #ffffff2b;
      }
      .hand.ghost::after {
        background: linear-gradient(transparent 46%, var(--attention) 46% 54%, transparent 54%);
        border: 1.5px dashed var(--attention);
        box-shadow: none;
      }
      .hand.held::after {
        border-color: var(--hand);
        box-shadow: 0 0 0 1px var(--hand);
      }
      .way::after {
        content: "";
        position: absolute;
        left: 18%;
        bottom: 0;
        height: 100%;
        border-left: 2px dotted var(--attention);
        margin-left: -1px;
        opacity: 0;
      }
      .way.shown::after {
        opacity: 1;
      }
      .percent {
        font-size: 20px;
        font-weight: 600;
        line-height: 22px;
        color: var(--text);
      }
      .mode {
        font-size: 11px;
        line-height: 14px;
        min-height: 28px;
        color: var(--dim);
      }
      .mode.attention {
        color: var(--attention);
      }
      .release {
        width: 100%;
        padding: 0;
      }
      .release.lit {
        color: var(--hand);
        border-color: var(--hand);
      }
    `,
  ];

  override render() {
    const name = this.axis === "face" ? "Face" : "Expression";
    return html`
      <h2>${this.axis === "face" ? "Face" : "Expr."}</h2>
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
      </div>
      <div class="end bottom"></div>
      <div><div class="percent">&nbsp;</div><div class="mode"></div></div>
      <button class="release" title="Take the hand off: a timed call runs on" @click=${() => this.desk.release(this.axis)}>
        Release
      </button>
    `;
  }

  override firstUpdated(): void {
    const knob = () => this.desk.bar(this.axis);
    onDrag(this.track, {
      start: () => {
        this.#era = this.desk.era;
        this.#position = knob().value(performance.now());
        this.#touched = true;
      },
      move: (_dx, dy) => {
        if (this.#era !== this.desk.era) return;
        this.#position = within(this.#position + dy, UNIT);
        knob().grip(this.#position);
      },
      end: () => {
        this.#touched = false;
        knob().leave();
      },
      double: () => this.desk.release(this.axis),
    });
    const step = (by: number) => knob().nudge(within(knob().value(performance.now()) + by, UNIT));
    onWheel(this.track, (steps) => step(steps * 0.04));
    onArrows(
      this.track,
      (dx, dy) => step((dx + dy) * 0.02),
      () => this.desk.release(this.axis),
    );
  }

  #touched = false;

  override focus(): void {
    this.track.focus();
  }

  paint(now: number): void {
    const call = this.desk.callOf(this.axis);
    const position = this.desk.bar(this.axis).value(now);
    const view = barView(call, position, this.#touched, this.#view);
    if (view.target !== this.#view?.target) this.#from = this.#strongest(view.target);
    this.#view = view;
    const write = this.#written;
    const waiting = view.mode === "waiting";
    write.style(this.hand, "transform", `translateY(${-100 * position}%)`);
    write.flag(this.hand, "ghost", waiting);
    write.flag(this.hand, "held", view.mode === "held");
    write.style(this.value, "transform", `translateY(${-100 * view.value}%)`);
    write.flag(this.value, "shown", view.target !== null);
    write.flag(this.way, "shown", waiting && Math.abs(view.gap) > 0.01);
    const low = view.gap < 0 ? position : view.value;
    write.style(this.way, "transform", `translateY(${-100 * low}%) scaleY(${Math.abs(view.gap)})`);
    write.style(this.way, "transform-origin", "bottom");
    write.flag(this.column, "flipped", view.flipped);
    write.style(this.column, "transform", `scaleY(${view.flipped ? 1 - view.value : call === null ? 0 : view.value})`);
    write.attribute(this.track, "aria-valuenow", position.toFixed(2));
    this.#paintWords(view);
  }

  #paintWords(view: BarView): void {
    const write = this.#written;
    const call = this.desk.callOf(this.axis);
    const [start, goal] = view.flipped ? [this.top, this.bottom] : [this.bottom, this.top];
    const label = (name: string) => this.desk.label(this.axis, name);
    write.text(goal, call === null ? "" : label(call.target));
    write.text(start, label(call === null ? this.#strongest(null) : this.#from));
    for (const end of [this.top, this.bottom]) {
      write.flag(end, "air", end === start);
      write.flag(end, "coming", end === goal && call !== null);
    }
    write.text(this.percent, call === null ? "–" : `${Math.round(call.progress * 100)} %`);
    write.text(this.mode, MODES[view.mode](call?.remaining ?? null, view.gap));
    write.flag(this.mode, "attention", view.mode === "waiting");
    write.flag(this.release, "lit", view.mode === "held");
    const spoken = call === null ? "no call" : `${label(call.target)} ${Math.round(call.progress * 100)} per cent`;
    write.attribute(this.track, "aria-valuetext", spoken);
  }

  #strongest(besides: string | null): string {
    const state = this.desk.state;
    const names = onAir((this.axis === "face" ? state?.faces : state?.expressions) ?? {});
    return names.find(([name]) => name !== besides)?.[0] ?? "";
  }
}

const MODES: Record<BarView["mode"], (remaining: number | null, gap: number) => string> = {
  idle: () => "",
  running: (remaining) => (remaining === null ? "" : `${remainingLabel(remaining)} s left`),
  waiting: (_, gap) => `pick up ${gap < 0 ? "▲" : "▼"}`,
  held: () => "by hand",
};
