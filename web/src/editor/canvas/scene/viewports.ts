/** How the canvas is shared out and from where each face is seen. */

import { type Box, inBox } from "../math/boxes";
import { type Bounds, bounded, Camera, FIRST_VIEW, VIEWS, type View, type ViewName } from "../math/camera";
import { tiles } from "../math/canvas_layout";

const MOST_RATIO = 2; // pixels of the canvas per CSS pixel: more costs and is not seen
const PAN_REACH = 0.14; // metres
type Colour = readonly [number, number, number];

export class Viewports {
  view: View = { ...FIRST_VIEW };
  readonly ground: Colour = [0.031, 0.035, 0.039];
  readonly hovered: Colour = [0.105, 0.112, 0.125];
  ratio = 1;
  private boxes: Box[] = [];

  constructor(private readonly canvas: HTMLCanvasElement) {}

  dispose(): void {
    this.boxes = [];
  }

  /** The ground behind a face: the work's is a little lighter. */
  tile(n: number): Colour {
    return n === 0 ? [0.075, 0.08, 0.088] : [0.055, 0.06, 0.066];
  }

  /** Gives the canvas the pixels it is shown with; whether that changed anything. */
  fit(): boolean {
    const { canvas } = this;
    this.ratio = Math.min(MOST_RATIO, devicePixelRatio);
    const [width, height] = [canvas.clientWidth, canvas.clientHeight].map((side) =>
      Math.max(1, Math.round(side * this.ratio)),
    ) as [number, number];
    if (canvas.width === width && canvas.height === height) return false;
    [canvas.width, canvas.height] = [width, height];
    return true;
  }

  /** The boxes of the work and `count` faces beside it. */
  share(count: number): readonly Box[] {
    const { work, beside } = tiles(this.canvas.clientWidth, this.canvas.clientHeight, count);
    this.boxes = [work, ...beside];
    return this.boxes;
  }

  /** The face whose box a place of the canvas is in; -1: none. */
  at(x: number, y: number): number {
    return this.boxes.findIndex((box) => inBox(box, x, y));
  }

  /** The camera of a face: those beside the work turn with it, but keep their distance. */
  camera(n: number, bounds: Bounds): Camera {
    const box = this.boxes[n] ?? { left: 0, top: 0, width: this.canvas.clientWidth, height: this.canvas.clientHeight };
    const view = n === 0 ? this.view : { ...this.view, zoom: 1, pan: FIRST_VIEW.pan };
    return new Camera(view, box, bounds);
  }

  /** A box in pixels from the canvas' lower left corner. */
  pixels({ left, top, width, height }: Box): [number, number, number, number] {
    const [x, right] = [Math.round(left * this.ratio), Math.round((left + width) * this.ratio)];
    const [y, bottom] = [Math.round(top * this.ratio), Math.round((top + height) * this.ratio)];
    return [x, this.canvas.height - bottom, right - x, bottom - y];
  }

  look(name: ViewName): void {
    const [yaw, pitch] = VIEWS[name];
    this.view = { ...this.view, yaw, pitch };
  }

  /** The whole face, from where it is seen now. */
  whole(): void {
    this.view = { ...this.view, zoom: FIRST_VIEW.zoom, pan: FIRST_VIEW.pan };
  }

  reset(): void {
    this.view = { ...FIRST_VIEW };
  }

  /** Turns the head by pixels of the pointer. */
  orbit(dx: number, dy: number): void {
    const radiansPerPixel = Math.PI / Math.max(200, Math.min(this.canvas.clientWidth, this.canvas.clientHeight));
    this.change({ yaw: this.view.yaw - dx * radiansPerPixel, pitch: this.view.pitch + dy * radiansPerPixel });
  }

  /** Shifts the work by metres on the screen. */
  pan(right: number, up: number): void {
    this.change({ pan: [this.view.pan[0] - right, this.view.pan[1] - up] });
  }

  /** Comes nearer by a factor. */
  zoom(factor: number): void {
    this.change({ zoom: this.view.zoom * factor });
  }

  private change(part: Partial<View>): void {
    this.view = bounded({ ...this.view, ...part }, PAN_REACH);
  }
}
