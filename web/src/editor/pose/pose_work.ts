/** The figure under work with others beside it, and what a hand takes hold of on it. */

import { css, html, nothing } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { Vector3 } from "three";
import { FaceView } from "../../face/face_view";
import type { Figure } from "../../face/figure/figure";
import { poseOf } from "../../face/figure/pose_recipe";
import type { Vector } from "../../face/figure/rotations";
import { FIGURE_GROUND } from "../../face/framing";
import { restPose, STANDING } from "../../face/pose/pose";
import { FRONT, type ScenePose } from "../../face/pose/scene_pose";
import { ALL } from "../../link/constants";
import type { PoseRecipe } from "../../link/editing_messages";
import { base } from "../../ui/theme";
import { whileShown } from "../../ui/topic_element";
import { controls } from "../controls/controls_style";
import { EditorElement } from "../controls/editor_element";
import type { Topic } from "../session/draft_store";
import { GRIPS, type Grip, reach } from "./pose_grips";
import { alike } from "./pose_words";

/** Bodies beside the one under work, and how far from it, metres. */
export const BESIDE = 2;
const APART = 0.95;
/** Radians that a figure turns for a picture's width. */
const TURN = Math.PI;
const VIEWS: Readonly<Record<string, number>> = {
  front: 0,
  whole: 0,
  left: -Math.PI / 2,
  right: Math.PI / 2,
  "three-quarter": -0.7,
};
const WORK = "work";

const style = css`
  :host {
    position: absolute;
    inset: 0;
    overflow: hidden;
    background: #4a4b4e;
  }
  canvas {
    position: absolute;
    inset: 0;
    width: 100%;
    height: 100%;
    touch-action: none;
  }
  .grip {
    position: absolute;
    width: 30px;
    height: 30px;
    min-height: 30px;
    margin: -15px 0 0 -15px;
    padding: 0;
    border: 0;
    background: none;
    touch-action: none;
    cursor: grab;
  }
  .grip:hover {
    background: none;
  }
  .grip::after {
    content: "";
    position: absolute;
    inset: 9px;
    border-radius: 50%;
    background: #fff;
    border: 2px solid #000;
  }
  .grip:hover::after,
  .grip.held::after {
    inset: 6px;
    background: var(--hand);
  }
  .coming {
    position: absolute;
    left: 12px;
    top: 10px;
  }
`;

/** A figure to grab: hands, elbows, feet, hips and head follow the pointer, on every body at once. */
@customElement("omote-pose-work")
export class PoseWork extends EditorElement {
  @state() private places: ReadonlyMap<string, readonly [number, number]> = new Map();
  @state() private held = "";
  @query("canvas") private canvas!: HTMLCanvasElement;
  #view: FaceView | null = null;
  #turn = 0;
  #frame = 0;
  #shown = "";
  #version = 0;

  static override styles = [base, controls, style];

  protected override readonly topics: readonly Topic[] = ["draft", "live", "cast"];

  constructor() {
    super();
    whileShown(this, () => {
      const seen = new ResizeObserver(() => this.#redraw());
      seen.observe(this);
      return () => {
        seen.disconnect();
        cancelAnimationFrame(this.#frame);
        this.#view?.dispose();
        this.#view = null;
      };
    });
  }

  override firstUpdated(): void {
    void this.#open();
  }

  override updated(): void {
    this.#redraw();
  }

  /** Shows the figures from a side. */
  view(key: string): void {
    this.#turn = VIEWS[key] ?? 0;
    this.#redraw();
  }

  override render() {
    return html`<canvas aria-label="The figure under work and others beside it" @pointerdown=${this.#turnAbout}></canvas>
      ${this.#view === null ? html`<p class="coming" role="status">The figures are coming ...</p>` : nothing}
      ${GRIPS.map((grip) => {
        const at = this.places.get(grip.name);
        return at === undefined
          ? nothing
          : html`<button class="grip ${this.held === grip.name ? "held" : ""}" data-grip=${grip.name} tabindex="-1" aria-hidden="true" title="${grip.label}: drag it"
              style="left:${(100 * at[0]).toFixed(2)}%;top:${(100 * at[1]).toFixed(2)}%"
              @pointerdown=${(event: PointerEvent) => this.#grab(event, grip)}></button>`;
      })}`;
  }

  async #open(): Promise<void> {
    const { library } = this.store;
    if (library === null) return;
    const view = await FaceView.load(this.canvas, library, {
      shotSize: "full",
      background: FIGURE_GROUND,
      pixelRatio: 1,
    });
    if (!this.isConnected) {
      view.dispose();
      return;
    }
    this.#view = view;
    this.requestUpdate();
  }

  #redraw(): void {
    if (this.#frame === 0) this.#frame = requestAnimationFrame(() => this.#draw());
  }

  #draw(): void {
    this.#frame = 0;
    const [view, recipe] = [this.#view, this.#recipe];
    if (view === null || recipe === null || !this.isConnected) return;
    view.resize(this.clientWidth, this.clientHeight);
    view.showScene(this.#scene(view, recipe));
    view.render();
    this.#locate(view);
    if (!view.still) this.#redraw();
  }

  get #recipe(): PoseRecipe | null {
    return this.store.livePose ?? this.store.pose;
  }

  #scene(view: FaceView, recipe: PoseRecipe): ScenePose {
    const { store } = this;
    const key = JSON.stringify(recipe);
    if (key !== this.#shown) this.#version += 1;
    this.#shown = key;
    const name = `draft ${this.#version}`;
    const skeleton = view.figureOf(WORK)?.figure.skeleton;
    if (skeleton !== undefined) view.library.showPose(name, poseOf(recipe, skeleton));
    const faces = [store.work, ...store.neighbours.slice(0, BESIDE)];
    const characters = faces.map((face, number) => {
      const x = number === 0 ? 0 : number === 1 ? -APART : APART;
      const figure = { ...STANDING, poses: { [name]: 1 } };
      const place = { ...FRONT, x, turn: this.#turn };
      return [number === 0 ? WORK : `beside ${number}`, { ...restPose(face), figure, place, presence: 1 }] as const;
    });
    return { characters: Object.fromEntries(characters), framing: { [ALL]: 1 }, black: 0 };
  }

  /** Finds where the grips lie in the picture. */
  #locate(view: FaceView): void {
    const placed = view.figureOf(WORK);
    const places = new Map<string, readonly [number, number]>();
    for (const grip of GRIPS) {
      const at = placed?.figure.pointOf(grip.bone, grip.offset);
      if (placed === undefined || at === undefined) continue;
      const { x, y } = new Vector3(...at).applyMatrix4(placed.matrix).project(view.camera);
      places.set(grip.name, [(1 + x) / 2, (1 - y) / 2]);
    }
    if (JSON.stringify([...places]) !== JSON.stringify([...this.places])) this.places = places;
  }

  #grab(event: PointerEvent, grip: Grip): void {
    const placed = this.#view?.figureOf(WORK);
    if (placed === undefined || this.#recipe === null) return;
    event.preventDefault();
    const button = event.currentTarget as HTMLElement;
    button.setPointerCapture(event.pointerId);
    this.held = grip.name;
    const follow = (moved: PointerEvent): void => this.#pull(moved, grip, placed.figure);
    const end = (last: PointerEvent): void => {
      button.removeEventListener("pointermove", follow);
      button.removeEventListener("pointerup", end);
      button.removeEventListener("pointercancel", end);
      this.held = "";
      const { livePose } = this.store;
      if (last.type === "pointercancel" || livePose === null) this.store.showPose(null);
      else this.store.setPose(livePose, `drag of ${grip.label.toLowerCase()}`);
    };
    button.addEventListener("pointermove", follow);
    button.addEventListener("pointerup", end);
    button.addEventListener("pointercancel", end);
  }

  /** A grip goes to the pointer, in the plane of the picture in which it lies. */
  #pull({ clientX, clientY }: PointerEvent, grip: Grip, figure: Figure): void {
    const [view, placed, recipe] = [this.#view, this.#view?.figureOf(WORK), this.#recipe];
    const at = figure.pointOf(grip.bone, grip.offset);
    if (view === null || placed === undefined || recipe === null || at === undefined) return;
    const box = this.getBoundingClientRect();
    const deep = new Vector3(...at).applyMatrix4(placed.matrix).project(view.camera).z;
    const pointed = new Vector3(
      (2 * (clientX - box.left)) / box.width - 1,
      1 - (2 * (clientY - box.top)) / box.height,
      deep,
    );
    const target = pointed.unproject(view.camera).applyMatrix4(placed.matrix.clone().invert()).toArray() as Vector;
    const placeIn = (tried: PoseRecipe): Vector =>
      figure.pointIn(poseOf(tried, figure.skeleton), grip.bone, grip.offset) ?? target;
    const reached = reach(recipe, grip, target, placeIn);
    this.store.showPose(this.store.options.mirror ? alike(reached, grip.words[0]?.path[0]) : reached);
  }

  /** A drag beside the grips turns the figures. */
  readonly #turnAbout = (event: PointerEvent): void => {
    const { canvas } = this;
    canvas.setPointerCapture(event.pointerId);
    const [from, before] = [event.clientX, this.#turn];
    const follow = (moved: PointerEvent): void => {
      this.#turn = before + (TURN * (moved.clientX - from)) / this.clientWidth;
      this.#redraw();
    };
    const end = (): void => {
      canvas.removeEventListener("pointermove", follow);
      canvas.removeEventListener("pointerup", end);
      canvas.removeEventListener("pointercancel", end);
    };
    canvas.addEventListener("pointermove", follow);
    canvas.addEventListener("pointerup", end);
    canvas.addEventListener("pointercancel", end);
  };
}
