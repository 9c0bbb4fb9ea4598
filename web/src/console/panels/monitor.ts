/** The monitor: the face on air, drawn only when it changes. */

import { css, html } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { FaceView } from "../../face/face_view";
import { poseKey } from "../../face/pose/pose";
import type { Library } from "../../link/assets";
import { base } from "../../ui/theme";
import { AnimatedElement } from "../controls/console_element";

/** Milliseconds between two pictures: the monitor shows what is on air, the stage is what must be smooth. */
const PACE = 30;

/** What is on air, live. It draws only when something has changed. */
@customElement("omote-monitor")
export class Monitor extends AnimatedElement {
  @state() private wrong: string | null = null;
  @query("canvas") private canvas!: HTMLCanvasElement;
  #view: FaceView | null = null;
  #drawn = "";
  #last = 0;
  #resized = true;
  readonly #sizes = new ResizeObserver(() => {
    this.#resized = true;
  });

  static override styles = [
    base,
    css`
      :host {
        position: relative;
        min-height: 0;
        min-width: 0;
        overflow: hidden;
        background: #000;
      }
      canvas {
        position: absolute;
        inset: 0;
        width: 100%;
        height: 100%;
      }
      .tally {
        position: absolute;
        left: 10px;
        top: 10px;
        font-size: 11px;
        font-weight: 700;
        letter-spacing: 0.14em;
        padding: 3px 8px;
        border-radius: 3px;
        color: #fff;
        background: #b3261a;
      }
      .wrong {
        position: absolute;
        inset: auto 10px 10px;
        color: var(--attention);
      }
    `,
  ];

  override render() {
    return html`
      <canvas aria-label="What is on air"></canvas>
      <div class="tally">ON AIR</div>
      ${this.wrong === null ? "" : html`<div class="wrong">${this.wrong}</div>`}
    `;
  }

  /** Starts to draw the cast; without WebGL2 the console goes on without a picture. */
  async open(library: Library): Promise<void> {
    await this.updateComplete;
    try {
      this.#view = await FaceView.load(this.canvas, library, { pixelRatio: 1 });
      this.#sizes.observe(this);
    } catch (error) {
      this.wrong = error instanceof Error ? error.message : String(error);
    }
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#sizes.disconnect();
  }

  paint(now: number): void {
    const [view, state] = [this.#view, this.store.state];
    if (view === null || state === null || now - this.#last < PACE) return;
    const pose = poseKey(state);
    if (pose === this.#drawn && view.settled && !this.#resized) return;
    this.#last = now;
    this.#drawn = pose;
    if (this.#resized) view.resize(this.clientWidth, this.clientHeight);
    this.#resized = false;
    view.show(state);
    view.render(now / 1000);
  }
}
