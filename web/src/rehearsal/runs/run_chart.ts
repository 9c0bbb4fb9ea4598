/** One quantity of two runs over time, drawn by uPlot: wheel, drag, fingers and keys zoom and move, a press looks. */

import { css, html, LitElement, unsafeCSS } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import uPlot from "uplot";
import plotStyle from "uplot/dist/uPlot.min.css?inline";
import { base } from "../../ui/theme";
import { axisTime, pinch, type View, zoomAt } from "./view";

/** What a chart draws: values on the grid of the page; `words`: a name to each, where they have one. */
export interface Drawn {
  values: (number | null)[];
  words?: (string | null)[];
}

/** A moment that is drawn as a line: a cue of A (`a`) or of B, a note. */
export interface Mark {
  at: number;
  label: string;
  of: "a" | "b" | "note";
}

export const COLOUR = { a: "#f4f6f8", b: "#69a7ff", note: "#ffc53d", here: "#ff5a45" };
const HEIGHT = 150;
/** Pixels: a press that moves further is a drag. */
const STILL = 5;
const WHEEL = 1.25;

const style = css`
  ${unsafeCSS(plotStyle)}
  :host {
    position: relative;
  }
  .head {
    display: flex;
    flex-wrap: wrap;
    gap: 2px 14px;
    align-items: baseline;
    padding: 2px 4px 0;
  }
  h3 {
    margin: 0;
    font-size: 13px;
    color: var(--text);
  }
  .head span {
    white-space: nowrap;
  }
  .plot {
    height: ${HEIGHT}px;
    overflow: hidden;
  }
  .uplot {
    font-family: inherit;
  }
  .u-over {
    cursor: crosshair;
    touch-action: pan-y;
  }
  .u-select {
    background: #86b9ff33;
  }
`;

/** Tells `look` (a time) and `view` (a `View`). */
@customElement("omote-run-chart")
export class RunChart extends LitElement {
  static override styles = [base, style];
  @property() heading = "";
  @property() unit = "";
  /** Seconds. */
  @property({ attribute: false }) times: number[] = [];
  @property({ attribute: false }) a: Drawn | undefined;
  @property({ attribute: false }) b: Drawn | undefined;
  @property({ attribute: false }) marks: readonly Mark[] = [];
  @property({ attribute: false }) view: View = { min: 0, max: 1 };
  @property({ attribute: false }) whole: View = { min: 0, max: 1 };
  @property({ type: Number }) here: number | undefined;
  @state() private under: number | null = null;
  @query(".plot") private box!: HTMLElement;
  plot: uPlot | undefined;
  readonly #fingers = new Map<number, number>();
  #pressed = 0;
  readonly #resized = new ResizeObserver(() => this.plot?.setSize({ width: this.box.clientWidth, height: HEIGHT }));

  override render() {
    return html`<div class="head"><h3>${this.heading}</h3>
        <span style="color: ${COLOUR.a}">${this.#value("A", this.a)}</span>
        <span style="color: ${COLOUR.b}">${this.#value("B", this.b)}</span></div>
      <div class="plot" role="img" aria-label="${this.heading} of two runs over time"></div>`;
  }

  override firstUpdated(): void {
    this.#resized.observe(this.box);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#resized.disconnect();
    this.plot?.destroy();
    this.plot = undefined;
  }

  override updated(changed: Map<string, unknown>): void {
    if (this.plot === undefined) this.#draw();
    else if (changed.has("times") || changed.has("a") || changed.has("b")) this.plot.setData(this.#data(), false);
    else if (changed.has("marks") || changed.has("here")) this.plot.redraw(false);
    if (this.times.length > 0) this.plot?.setScale("x", this.view);
  }

  #value(name: string, drawn: Drawn | undefined): string {
    const place = this.under;
    const value = place === null ? null : drawn?.values[place];
    if (value === undefined || value === null || place === null) return `${name} –`;
    const word = drawn?.words?.[place];
    return `${name} ${word ? `${word} ` : ""}${value.toFixed(this.unit === "" ? 2 : 1)}${this.unit}`;
  }

  #data(): uPlot.AlignedData {
    const none = this.times.map(() => null);
    return [this.times, this.b?.values ?? none, this.a?.values ?? none];
  }

  #draw(): void {
    const axis = { stroke: "#929aa4", grid: { stroke: "#1d2126", width: 1 }, ticks: { stroke: "#262a30", width: 1 } };
    const { unit } = this;
    this.plot = new uPlot(
      {
        width: this.box.clientWidth || 300,
        height: HEIGHT,
        legend: { show: false },
        scales: { x: { time: false }, y: { range: (_, low, high) => rangeOf(low, high, unit) } },
        axes: [
          { ...axis, size: 26, values: (_, splits) => splits.map(axisTime) },
          { ...axis, size: 42, space: 24, values: (_, splits) => splits.map((split) => `${+split.toFixed(2)}${unit}`) },
        ],
        series: [
          {},
          { stroke: COLOUR.b, width: 1.5, points: { show: false } },
          { stroke: COLOUR.a, width: 1.5, points: { show: false } },
        ],
        cursor: { sync: { key: "runs" }, y: false, drag: { x: true, y: false, setScale: false, dist: STILL } },
        hooks: {
          setCursor: [(plot) => this.#point(plot)],
          setSelect: [(plot) => this.#select(plot)],
          draw: [(plot) => this.#drawMarks(plot)],
          ready: [(plot) => this.#hear(plot.over)],
        },
      },
      this.#data(),
      this.box,
    );
  }

  #point({ cursor }: uPlot): void {
    this.under = cursor.idx ?? null;
  }

  /** What was dragged over fills the chart. */
  #select(plot: uPlot): void {
    const { left, width } = plot.select;
    if (width < STILL) return;
    this.#tell("view", { min: plot.posToVal(left, "x"), max: plot.posToVal(left + width, "x") });
    plot.setSelect({ left: 0, top: 0, width: 0, height: 0 }, false);
  }

  #drawMarks(plot: uPlot): void {
    const { ctx, bbox } = plot;
    const line = (at: number, colour: string, label: string, low: boolean): void => {
      if (at < this.view.min || at > this.view.max) return;
      const x = Math.round(plot.valToPos(at, "x", true)) + 0.5;
      ctx.strokeStyle = colour;
      ctx.fillStyle = colour;
      ctx.beginPath();
      ctx.moveTo(x, bbox.top);
      ctx.lineTo(x, bbox.top + bbox.height);
      ctx.stroke();
      ctx.fillText(label, x + 3 * devicePixelRatio, bbox.top + (low ? 22 : 10) * devicePixelRatio);
    };
    ctx.save();
    ctx.lineWidth = devicePixelRatio;
    ctx.font = `${10 * devicePixelRatio}px system-ui, sans-serif`;
    ctx.globalAlpha = 0.6;
    for (const { at, label, of } of this.marks) line(at, COLOUR[of], label, of === "b");
    ctx.globalAlpha = 1;
    ctx.lineWidth = 2 * devicePixelRatio;
    if (this.here !== undefined) line(this.here, COLOUR.here, "", false);
    ctx.restore();
  }

  #hear(over: HTMLElement): void {
    over.addEventListener("wheel", this.#wheel, { passive: false });
    over.addEventListener("mousedown", (event) => {
      this.#pressed = event.clientX;
    });
    over.addEventListener("click", this.#click);
    over.addEventListener("pointerdown", (event) => this.#touch(event));
    over.addEventListener("pointermove", (event) => this.#drag(event));
    for (const ends of ["pointerup", "pointercancel"] as const)
      over.addEventListener(ends, ({ pointerId }) => this.#fingers.delete(pointerId));
  }

  readonly #wheel = (event: WheelEvent): void => {
    if (event.shiftKey || this.plot === undefined) return; // that scrolls
    event.preventDefault();
    const at = this.plot.posToVal(event.offsetX, "x");
    this.#tell("view", zoomAt(this.view, event.deltaY > 0 ? WHEEL : 1 / WHEEL, at, this.whole));
  };

  readonly #click = (event: MouseEvent): void => {
    if (this.plot === undefined || Math.abs(event.clientX - this.#pressed) >= STILL) return;
    this.#tell("look", this.plot.posToVal(event.offsetX, "x"));
  };

  #place(event: PointerEvent): number {
    const { left, width } = (event.currentTarget as HTMLElement).getBoundingClientRect();
    return (event.clientX - left) / (width || 1);
  }

  #touch(event: PointerEvent): void {
    if (event.pointerType === "touch") this.#fingers.set(event.pointerId, this.#place(event));
  }

  #drag(event: PointerEvent): void {
    if (!this.#fingers.has(event.pointerId)) return;
    const before = [...this.#fingers.values()];
    this.#fingers.set(event.pointerId, this.#place(event));
    this.#tell("view", pinch(this.view, before, [...this.#fingers.values()], this.whole));
  }

  #tell(what: string, detail: unknown): void {
    this.dispatchEvent(new CustomEvent(what, { detail }));
  }
}

/** Weights from 0 to 1, more where they are; angles about 0. */
function rangeOf(low: number | null, high: number | null, unit: string): [number, number] {
  if (unit === "") return [0, Math.max(1.05, high ?? 0)];
  const most = Math.max(Math.abs(low ?? 0), Math.abs(high ?? 0), unit === "°" ? 10 : 0.5) * 1.1;
  return [-most, most];
}
