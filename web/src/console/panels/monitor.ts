/** The monitor: the scene on air, or one character of it, drawn only when it changes. */

import { css, html } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { FaceView } from "../../face/face_view";
import type { PictureBox } from "../../face/framing";
import { closeUp, type ScenePose, sceneIn, sceneKey } from "../../face/pose/scene_pose";
import type { Library } from "../../link/assets";
import { base, ellipsis, previewColours } from "../../ui/theme";
import { AnimatedElement } from "../controls/console_element";
import { low, narrow } from "../controls/screen_sizes";
import type { Topic } from "../store/page_store";

/** Milliseconds between two pictures: the monitor shows what is on air, the stage is what must be smooth. */
const PACE = 30;
const NOWHERE: ReadonlyMap<string, PictureBox> = new Map();

const style = css`
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
    max-width: calc(100% - 20px);
    ${ellipsis}
  }
  .tally.preview {
    ${previewColours}
    font-size: 11px;
  }
  :host([bare]) .tally {
    display: none;
  }
  .tally.small {
    left: 4px;
    top: 4px;
    font-size: 10px;
    letter-spacing: 0.06em;
    padding: 1px 5px;
  }
  @media ${narrow} or ${low} {
    .tally.small:not(.black) {
      display: none; /* it would cover a face; the keys below say who is played, and which is a close-up */
    }
  }
  .tally.black {
    background: #000;
    outline: 2px solid #b3261a;
  }
  .wrong,
  .loading {
    position: absolute;
    inset: auto 10px 10px;
    color: var(--attention);
  }
  .loading {
    color: var(--dim);
    text-align: center;
  }
`;

/** What is on air, live. It draws only when something has changed. */
@customElement("omote-monitor")
export class Monitor extends AnimatedElement {
  @state() private wrong: string | null = null;
  @state() private tally = "";
  /** The audience sees less than this picture, or nothing of it. */
  @state() private black = "";
  /** The face has been drawn: before that nothing shows of what is on air. */
  @state() private drawn = false;
  /** No badge stands on the picture: the page says elsewhere what is on air. */
  @property({ type: Boolean, reflect: true }) bare = false;
  @query("canvas") private canvas!: HTMLCanvasElement;
  #view: FaceView | null = null;
  #pose = "";
  #last = 0;
  #resized = true;
  readonly #sizes = new ResizeObserver(() => {
    this.#resized = true;
  });

  static override styles = [base, style];

  protected override readonly topics: readonly Topic[] = ["characters", "arrangement"];

  /** Where heads lie in the picture as it is: left, top, right and bottom as parts of it, by name. */
  get heads(): ReadonlyMap<string, PictureBox> {
    return this.#view?.heads ?? NOWHERE;
  }

  override render() {
    return html`
      <canvas aria-label=${this.store.bus === "air" ? "What is on air" : "What is in preview"}></canvas>
      ${this.drawn || this.wrong !== null ? this.#badge() : html`<div class="loading" role="status">The face on air is loading …</div>`}
      ${this.wrong === null ? "" : html`<div class="wrong">${this.wrong}</div>`}
    `;
  }

  #badge() {
    return html`<div class="tally ${this.store.bus} ${this.black === "" ? "" : "black"} ${this.#several ? "small" : ""}">${this.black || this.tally}</div>`;
  }

  get #several(): boolean {
    return Object.keys(this.store.state?.characters ?? {}).length > 1;
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
    const { state, played } = this.store;
    const alone = this.#several && this.store.arrangement.alone;
    this.tally = this.store.bus === "air" ? played.tally(alone) : "PREVIEW";
    this.black = blackWords(state?.black ?? 0);
    if (this.#view === null || state === null || now - this.#last < PACE) return;
    this.#draw(this.#view, alone ? closeUp(sceneIn(state), played.lead) : sceneIn(state), now);
  }

  #draw(view: FaceView, scene: ScenePose, now: number): void {
    const pose = sceneKey(scene);
    if (pose === this.#pose && view.still && !this.#resized) return;
    this.#last = now;
    this.#pose = pose;
    if (this.#resized) view.resize(this.clientWidth, this.clientHeight);
    this.#resized = false;
    view.showScene(scene);
    view.render(now / 1000);
    this.drawn ||= view.settled;
  }
}

/** What the badge says of a picture that is faded to black; nothing where it is up. */
const blackWords = (black: number): string =>
  black === 0 ? "" : black === 1 ? "BLACK" : `BLACK ${Math.round(100 * black)} %`;
