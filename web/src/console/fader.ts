import { css, html } from "lit";
import { customElement, property, query } from "lit/decorators.js";
import type { Side } from "./channels";
import type { Knob } from "./desk";
import { PaintedElement, Written } from "./element";
import { onArrows, onDrag, onWheel } from "./gesture";
import { CHANNEL, fractionOf, stepped, travelOf, weightAt, within } from "./scale";
import { base } from "./theme";

const STEP = 0.05;
const STOPS = [0, 1];

/** The fader of one channel, -0.5..1.5, with rests at 0 and 1. */
@customElement("omote-fader")
export class Fader extends PaintedElement {
  @property() channel = "";
  @property() side: Side | null = null;
  @query(".slot") private slotElement!: HTMLElement;
  @query(".fill") private fill!: HTMLElement;
  @query(".gaze") private gaze!: HTMLElement;
  @query(".carrier") private carrier!: HTMLElement;
  @query(".number") private number!: HTMLElement;
  readonly #written = new Written();
  #shown: Knob | null = null;
  #travel = 0;
  #era = 0;

  static override styles = [
    base,
    css`
      :host {
        display: grid;
        grid-template-rows: 14px 1fr;
        min-width: 34px;
        min-height: 0;
      }
      .number {
        font-size: 11px;
        line-height: 14px;
        text-align: center;
        color: var(--faint);
      }
      .number.touched {
        color: var(--air);
        font-weight: 700;
      }
      .slot {
        position: relative;
        margin: 8px 0;
        touch-action: none;
        cursor: ns-resize;
        border-radius: 3px;
      }
      .groove {
        position: absolute;
        left: 50%;
        top: -6px;
        bottom: -6px;
        width: 6px;
        margin-left: -3px;
        border-radius: 3px;
        background: #000;
        border: 1px solid var(--line);
      }
      .tick {
        position: absolute;
        left: 50%;
        width: 24px;
        margin-left: -12px;
        height: 1px;
        background: var(--edge);
      }
      .fill,
      .gaze {
        position: absolute;
        left: 50%;
        width: 4px;
        margin-left: -2px;
        bottom: 25%;
        height: 100%;
        transform-origin: bottom;
        transform: scaleY(0);
        background: var(--air);
      }
      .gaze {
        width: 2px;
        margin-left: 5px;
        background: var(--dim);
      }
      .carrier {
        position: absolute;
        inset: 0;
        pointer-events: none;
      }
      .carrier::after {
        content: "";
        position: absolute;
        left: 50%;
        width: 26px;
        margin-left: -13px;
        bottom: -7px;
        height: 14px;
        border-radius: 3px;
        border: 1px solid #000;
        background: linear-gradient(#565c64 0 40%, #c9ced4 40% 60%, #33383e 60%);
        box-shadow: 0 1px 3px #000b;
      }
      .carrier.touched::after {
        background: linear-gradient(#6b4a44 0 40%, #fff 40% 60%, #4a2f2a 60%);
        border-color: var(--air);
      }
    `,
  ];

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
      </div>
    `;
  }

  override firstUpdated(): void {
    const knob = () => this.desk.channel(this.channel);
    const weight = () => knob().value(performance.now());
    onDrag(this.slotElement, {
      start: () => {
        this.#era = this.desk.era;
        this.#travel = travelOf(weight());
      },
      move: (_dx, dy) => {
        if (this.#era !== this.desk.era || dy === 0) return;
        this.#travel = within(this.#travel + dy * (CHANNEL.high - CHANNEL.low), CHANNEL);
        knob().grip(weightAt(this.#travel));
      },
      end: () => knob().leave(),
      double: () => {
        knob().nudge(0);
        this.#travel = 0;
      },
    });
    const step = (by: number) => knob().nudge(stepped(weight(), by * STEP, CHANNEL, STOPS));
    onWheel(this.slotElement, step);
    onArrows(
      this.slotElement,
      (dx, dy) => step(dx + dy),
      () => knob().nudge(0),
    );
  }

  paint(now: number): void {
    const write = this.#written;
    this.#shown ??= this.desk.channel(this.channel, false);
    const weight = this.#shown.value(now);
    const text = weight === 0 ? "" : weight.toFixed(2).replace(/^(-?)0\./, "$1.");
    write.style(this.carrier, "transform", `translateY(${-100 * fractionOf(weight, CHANNEL)}%)`);
    write.style(this.fill, "transform", `scaleY(${weight / (CHANNEL.high - CHANNEL.low)})`);
    const lid = this.desk.state?.lids[this.channel] ?? 0;
    write.style(this.gaze, "transform", `scaleY(${lid / (CHANNEL.high - CHANNEL.low)})`);
    write.text(this.number, text || (this.side === null ? "" : this.side === "left" ? "L" : "R"));
    write.flag(this.number, "touched", weight !== 0);
    write.flag(this.carrier, "touched", weight !== 0);
    write.attribute(this.slotElement, "aria-valuenow", weight.toFixed(2));
  }
}
