/** The canvas of a scan: three looks at it, and the points on it, set by clicks, drags and keys. */

import { html, LitElement, svg } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import type { Mesh } from "../../../link/assets";
import { LANDMARKS } from "../../../link/constants";
import { ARROWS } from "../../../ui/gestures";
import { base } from "../../../ui/theme";
import type { Triple } from "../../canvas/math/vectors";
import { type Drawable, type LandmarkName, placed, unplaced } from "../data/scan_document";
import type { ScanPoints } from "../data/scan_points";
import { isHidden, pick, ScanCameras, SIDE_LABELS } from "./scan_cameras";
import { type ScanMix, ScanPainter } from "./scan_painter";
import { style } from "./scan_views_style";

/** A press that moves less, pixels, is a click. */
const STILL = 6;
/** Pixels within which a press takes a point in hand; for fingers. */
const GRASP = { mouse: 11, touch: 24 };
const MORE = 10;
const CLOSER = 1.2;

/** What a hand does between press and release. */
interface Hand {
  readonly at: number;
  readonly from: readonly [number, number];
  last: readonly [number, number];
  readonly point: LandmarkName | null;
  readonly shifts: boolean;
  moved: boolean;
}

/** Tells `set` when a point has been set or moved. */
@customElement("omote-scan-views")
export class ScanViews extends LitElement {
  @property({ attribute: false }) scan!: Drawable;
  /** Null: nothing is set on it. */
  @property({ attribute: false }) points: ScanPoints | null = null;
  @property({ attribute: false }) meshes: readonly Mesh[] = [];
  @property({ attribute: false }) shown: ScanMix = { share: 0.5, heat: false };
  /** Raised where points have changed. */
  @property({ attribute: false }) step = 0;
  @state() private active = 0;
  @query("canvas") private canvas!: HTMLCanvasElement;
  #painter: ScanPainter | null = null;
  #cameras: ScanCameras | null = null;
  #loaded: Drawable | null = null;
  readonly #hands = new Map<number, Hand>();
  readonly #size = new ResizeObserver(() => this.#resize());

  static override styles = [base, style];

  override connectedCallback(): void {
    super.connectedCallback();
    this.#size.observe(this);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#size.disconnect();
    this.#painter?.dispose();
    this.#painter = null;
  }

  override willUpdate(): void {
    if (this.#loaded === this.scan) return;
    this.#cameras = new ScanCameras(this.scan);
    this.#cameras.resize(this.clientWidth, this.clientHeight);
  }

  override updated(): void {
    if (this.#loaded !== this.scan) {
      this.#loaded = this.scan;
      const gl = this.canvas.getContext("webgl2", { antialias: true });
      if (gl !== null) {
        this.#painter ??= new ScanPainter(gl);
        this.#painter.load(this.scan, this.meshes);
      }
      this.#resize();
    } else this.#paint();
  }

  override render() {
    const boxes = this.#cameras?.boxes ?? [];
    return html`<canvas tabindex="0" aria-label="The scan from three sides" aria-describedby="keys"
        @pointerdown=${this.#down} @pointermove=${this.#move} @pointerup=${this.#up} @pointercancel=${this.#cancel}
        @wheel=${this.#wheel} @keydown=${this.#key} @contextmenu=${(event: Event) => event.preventDefault()}></canvas>
      <svg aria-hidden="true">${boxes.map((_, at) => LANDMARKS.map((name) => this.points && this.#mark(this.points, at, name)))}</svg>
      <div class="names" aria-hidden="true">${boxes.map(
        ({ left, top }, at) =>
          html`<span class=${at === this.active ? "active" : ""} style="left:${left}px;top:${top}px">${SIDE_LABELS[at]}</span>`,
      )}</div>`;
  }

  #mark(points: ScanPoints, at: number, name: LandmarkName) {
    const givenPoint = points.given[name];
    const own = givenPoint ?? this.scan.found[name];
    const camera = this.#cameras?.camera(at);
    if (own === undefined || camera === undefined) return null;
    const place = placed(this.scan.placement, own);
    const [x, y] = camera.project(place);
    if (this.#cameras?.at(x, y) !== at) return null;
    const names = [givenPoint === undefined ? "found" : "given"];
    if (name === points.chosen) names.push("chosen");
    if (this.#hands.size === 0 && isHidden(this.scan.surface, camera, place)) names.push("hidden");
    return svg`<g class=${names.join(" ")} data-point=${name}><circle cx=${x} cy=${y} r="6"></circle>
      <text x=${x} y=${y - 10}>${LANDMARKS.indexOf(name) + 1}</text></g>`;
  }

  // --- pictures -------------------------------------------------------------------------------------------------------

  #resize(): void {
    if (this.canvas === null || this.#cameras === null) return;
    const ratio = Math.min(2, devicePixelRatio);
    this.canvas.width = Math.max(1, Math.round(ratio * this.clientWidth));
    this.canvas.height = Math.max(1, Math.round(ratio * this.clientHeight));
    this.#cameras.resize(this.clientWidth, this.clientHeight);
    this.requestUpdate();
    this.#paint();
  }

  #paint(): void {
    const cameras = this.#cameras;
    if (cameras === null) return;
    const ratio = this.canvas.width / Math.max(1, this.clientWidth);
    cameras.boxes.forEach((box, at) => {
      this.#painter?.paint(box, cameras.camera(at), this.shown, ratio);
    });
  }

  // --- hands ----------------------------------------------------------------------------------------------------------

  readonly #down = (event: PointerEvent): void => {
    if (event.button > 2) return;
    const [x, y] = this.#place(event);
    const at = this.#cameras?.at(x, y) ?? -1;
    if (at < 0) return;
    this.canvas.setPointerCapture(event.pointerId);
    this.active = at;
    const shifts = event.button > 0;
    const point =
      this.#hands.size === 0 && !shifts
        ? this.#under(at, x, y, event.pointerType === "mouse" ? GRASP.mouse : GRASP.touch)
        : null;
    this.#hands.set(event.pointerId, { at, from: [x, y], last: [x, y], point, shifts, moved: shifts });
    if (point !== null && this.points !== null) this.points.chosen = point;
  };

  readonly #move = (event: PointerEvent): void => {
    const hand = this.#hands.get(event.pointerId);
    if (hand === undefined) return;
    const [x, y] = this.#place(event);
    const before = this.#spread();
    const [dx, dy] = [x - hand.last[0], y - hand.last[1]];
    if (!hand.moved && Math.hypot(x - hand.from[0], y - hand.from[1]) < STILL) return;
    hand.last = [x, y];
    if (this.#hands.size > 1) {
      if (before > 0) this.#cameras?.zoom(hand.at, this.#spread() / before, x, y);
      this.#cameras?.shift(hand.at, dx / 2, dy / 2);
    } else if (hand.point !== null) this.#put(hand.at, hand.point, x, y, { same: hand.moved });
    else if (event.shiftKey || hand.shifts) this.#cameras?.shift(hand.at, dx, dy);
    else this.#cameras?.turn(hand.at, dx, dy);
    hand.moved = true;
    this.requestUpdate();
  };

  readonly #up = (event: PointerEvent): void => {
    const hand = this.#hands.get(event.pointerId);
    this.#hands.delete(event.pointerId);
    if (hand === undefined) return;
    if (hand.moved || this.#hands.size > 0) this.requestUpdate();
    else if (hand.point === null && this.points !== null)
      this.#put(hand.at, this.points.chosen, ...hand.from, { goes: true });
    else this.#tell();
  };

  readonly #cancel = (event: PointerEvent): void => {
    this.#hands.delete(event.pointerId);
    this.requestUpdate();
  };

  readonly #wheel = (event: WheelEvent): void => {
    event.preventDefault();
    const at = this.#cameras?.at(...this.#place(event)) ?? -1;
    if (at < 0) return;
    this.#cameras?.zoom(at, Math.exp(-0.0015 * event.deltaY), ...this.#place(event));
    this.requestUpdate();
  };

  /** Pixels between two fingers; 0: there are not two. */
  #spread(): number {
    const [hand, other] = [...this.#hands.values()];
    return hand === undefined || other === undefined
      ? 0
      : Math.hypot(hand.last[0] - other.last[0], hand.last[1] - other.last[1]);
  }

  #place({ clientX, clientY }: MouseEvent): [number, number] {
    const { left, top } = this.canvas.getBoundingClientRect();
    return [clientX - left, clientY - top];
  }

  /** The point that lies under a pointer and can be seen. */
  #under(at: number, x: number, y: number, reach: number): LandmarkName | null {
    const camera = this.#cameras?.camera(at);
    if (camera === undefined) return null;
    const far = (name: LandmarkName): number => {
      const own = this.points?.given[name];
      if (own === undefined) return Infinity;
      const place = placed(this.scan.placement, own);
      const [px, py] = camera.project(place);
      return isHidden(this.scan.surface, camera, place) ? Infinity : Math.hypot(px - x, py - y);
    };
    const nearest = [...LANDMARKS].sort((a, b) => far(a) - far(b))[0] as LandmarkName;
    return far(nearest) <= reach ? nearest : null;
  }

  #put(at: number, name: LandmarkName, x: number, y: number, how: { goes?: boolean; same?: boolean }): void {
    const camera = this.#cameras?.camera(at);
    const point: Triple | undefined = camera && pick(this.scan.surface, camera, x, y);
    if (point === undefined || this.points === null) return;
    this.points.set(name, unplaced(this.scan.placement, point), how);
    this.#tell();
  }

  #tell(): void {
    this.requestUpdate();
    this.dispatchEvent(new CustomEvent("set"));
  }

  // --- keys -----------------------------------------------------------------------------------------------------------

  readonly #key = (event: KeyboardEvent): void => {
    if (event.ctrlKey || event.metaKey || !this.#obey(event)) return;
    event.preventDefault();
    event.stopPropagation();
    this.requestUpdate();
  };

  #obey({ key, shiftKey, altKey }: KeyboardEvent): boolean {
    const arrow = ARROWS[key];
    const number = Number(key);
    if (arrow !== undefined) {
      const far = shiftKey ? MORE : 1;
      if (altKey) this.#cameras?.turn(this.active, 20 * arrow[0], -20 * arrow[1]);
      else this.#nudge(far * arrow[0], -far * arrow[1]);
    } else if (number >= 1 && number <= LANDMARKS.length && this.points !== null) {
      this.points.chosen = LANDMARKS[number - 1] as LandmarkName;
      this.#tell();
    } else if (key === "v") this.active = (this.active + 1) % SIDE_LABELS.length;
    else if (key === "+" || key === "-") this.#cameras?.zoom(this.active, key === "+" ? CLOSER : 1 / CLOSER);
    else if (key === "0") this.#cameras?.reset();
    else if (key === "Enter") this.#nudge(0, 0);
    else return false;
    return true;
  }

  /** Moves the chosen point by pixels of the active look; one that is neither set nor found begins in its middle. */
  #nudge(dx: number, dy: number): void {
    const camera = this.#cameras?.camera(this.active);
    if (camera === undefined || this.points === null) return;
    const name = this.points.chosen;
    const own = this.points.given[name] ?? this.scan.found[name];
    const { left, top, width, height } = camera.box;
    const [x, y] =
      own === undefined ? [left + width / 2, top + height / 2] : camera.project(placed(this.scan.placement, own));
    this.#put(this.active, name, x + dx, y + dy, {});
  }
}
