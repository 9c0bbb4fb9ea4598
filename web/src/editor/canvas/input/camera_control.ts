/** Hands that turn, shift and enlarge what is seen: two fingers, wheel, drags beside the needles. */

import type { Bounds, Camera } from "../math/camera";
import type { Pair } from "../math/vectors";
import type { Viewports } from "../scene/viewports";

/** What two fingers span. */
interface Span {
  far: number;
  middle: Pair;
}

/** What is looked at. */
interface CameraTarget {
  readonly viewports: Viewports;
  readonly work: { readonly bounds: Bounds } | undefined;
  redraw(): void;
}

export class CameraControl {
  private span: Span | undefined;

  constructor(private readonly target: CameraTarget) {}

  /** Whether two fingers are at it. */
  get pinching(): boolean {
    return this.span !== undefined;
  }

  /** The camera of the work. */
  get camera(): Camera | undefined {
    const { viewports, work } = this.target;
    return work === undefined ? undefined : viewports.camera(0, work.bounds);
  }

  orbit(dx: number, dy: number): void {
    this.target.viewports.orbit(dx, dy);
    this.target.redraw();
  }

  /** Shifts the work by pixels. */
  pan(dx: number, dy: number): void {
    const metresPerPixel = this.metresPerPixel;
    this.target.viewports.pan(dx * metresPerPixel, -dy * metresPerPixel);
    this.target.redraw();
  }

  /** Comes nearer by a factor to what lies at a place of the canvas. */
  zoomAt([x, y]: Pair, factor: number): void {
    const { camera } = this;
    if (camera === undefined) return;
    const { left, top, width, height } = camera.box;
    const before = this.metresPerPixel;
    this.target.viewports.zoom(factor);
    const less = before - this.metresPerPixel;
    this.target.viewports.pan(-(x - left - width / 2) * less, (y - top - height / 2) * less);
    this.target.redraw();
  }

  wheel(event: WheelEvent): void {
    event.preventDefault();
    const unit = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? 24 : 1;
    this.zoomAt([event.offsetX, event.offsetY], Math.exp(-event.deltaY * unit * (event.ctrlKey ? 0.01 : 0.0016)));
  }

  /** Two fingers come down, or move. */
  pinch(fingers: readonly Pair[]): void {
    const [a, b] = fingers;
    if (a === undefined || b === undefined) return;
    const now = { far: Math.hypot(a[0] - b[0], a[1] - b[1]), middle: [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2] as Pair };
    if (this.span !== undefined) {
      this.pan(now.middle[0] - this.span.middle[0], now.middle[1] - this.span.middle[1]);
      this.zoomAt(now.middle, now.far / Math.max(this.span.far, 1));
    }
    this.span = now;
  }

  /** The fingers leave. */
  release(): void {
    this.span = undefined;
  }

  reset(): void {
    this.target.viewports.reset();
    this.target.redraw();
  }

  private get metresPerPixel(): number {
    const { camera, target } = this;
    return camera === undefined || target.work === undefined ? 0 : camera.metresPerPixel(target.work.bounds.centre);
  }
}
