/** Draws a grid of poses into one picture. */

import type { FaceView } from "../face/face_view";
import { type Pose, restPose } from "../face/pose/pose";

/** Pictures in rows and columns, with or without the names of rows and columns. */
export interface PictureGrid {
  /** Row by row; what a pose leaves out is at rest. */
  poses: readonly (readonly Partial<Pose>[])[];
  rows: readonly string[];
  columns: readonly string[];
  /** Words in the corner of each picture, row by row; empty: none. */
  captions: readonly (readonly string[])[];
  /** What is kept of each picture: left, top, width, height, as shares of it. */
  part: readonly [number, number, number, number];
  /** The colour behind the pictures; null: nothing. */
  paper: string | null;
  /** The media type of the file. */
  kind: string;
}

/** Where everything is on a sheet, in pixels. */
export interface Layout {
  width: number;
  height: number;
  /** What is kept of a picture: left, top, width, height. */
  part: [number, number, number, number];
  /** The upper left corner of a cell. */
  corner: (row: number, column: number) => [number, number];
  letter: number;
}

const GAP = 1;
const INK = "#bbb";
const JPEG_QUALITY = 0.86;

/** The places of a sheet's cells; `widest`: the width of the longest row's name in letters' heights. */
export function layOut(sheet: PictureGrid, width: number, height: number, widest: number): Layout {
  const [left, top, wide, high] = sheet.part;
  const [x, y] = [Math.round(left * width), Math.round(top * height)];
  const [w, h] = [Math.max(1, Math.round(wide * width)), Math.max(1, Math.round(high * height))];
  const letter = Math.min(32, Math.max(11, Math.round(w / 12)));
  const alone = sheet.poses.length === 1 && sheet.poses[0]?.length === 1;
  const gap = alone ? 0 : GAP;
  const margin = sheet.rows.length > 0 ? Math.ceil((widest + 1) * letter) : 0;
  const head = sheet.columns.length > 0 ? 2 * letter : 0;
  const columns = Math.max(...sheet.poses.map((row) => row.length));
  return {
    width: margin + columns * (w + gap) - gap,
    height: head + sheet.poses.length * (h + gap) - gap,
    part: [x, y, w, h],
    corner: (row, column) => [margin + column * (w + gap), head + row * (h + gap)],
    letter,
  };
}

/** Draws every pose in full, at one instant of time, so that the same sheet gives the same picture; `after`: fetched ahead. */
export async function drawPictureGrid(
  view: FaceView,
  sheet: PictureGrid,
  width: number,
  height: number,
  after?: Partial<Pose>,
): Promise<Blob> {
  const composer = new SheetComposer(sheet, width, height);
  view.centred = true;
  for (const [row, poses] of sheet.poses.entries())
    for (const [column, pose] of poses.entries()) {
      const next = poses[column + 1] ?? sheet.poses[row + 1]?.[0] ?? after;
      await view.present(wholePose(pose), 0, next && wholePose(next));
      composer.paste(view.canvas, row, column);
    }
  return composer.file();
}

/** A pose with all that it leaves out at rest, and the bytes of a body that shows, which come as base64. */
export function wholePose(pose: Partial<Pose>): Pose {
  const whole = { ...restPose("generic"), ...pose };
  const tracked = (whole.figure as { tracked?: { pose: string | Uint8Array } | null } | null | undefined)?.tracked;
  if (typeof tracked?.pose !== "string") return whole;
  const bytes = Uint8Array.from(atob(tracked.pose), (letter) => letter.charCodeAt(0));
  return { ...whole, figure: { ...whole.figure, tracked: { ...tracked, pose: bytes } } } as Pose;
}

/** A sheet that pictures are pasted into, one after the other, each drawn at `width` x `height`. */
export class SheetComposer {
  private readonly layout: Layout;
  private readonly canvas: OffscreenCanvas;
  private readonly context: OffscreenCanvasRenderingContext2D;

  constructor(
    private readonly sheet: PictureGrid,
    private readonly width: number,
    private readonly height: number,
  ) {
    const measure = new OffscreenCanvas(1, 1).getContext("2d") as OffscreenCanvasRenderingContext2D;
    measure.font = font(100);
    const widest = Math.max(0, ...sheet.rows.map((name) => measure.measureText(name).width / 100));
    this.layout = layOut(sheet, width, height, widest);
    this.canvas = new OffscreenCanvas(this.layout.width, this.layout.height);
    const context = this.canvas.getContext("2d");
    if (context === null)
      throw new Error(`No canvas has ${this.layout.width}x${this.layout.height} pixels; make the sheet smaller.`);
    this.context = context;
    write(context, sheet, this.layout);
  }

  /** Pastes the kept part of a picture; the canvas has fewer pixels than the page where the level spares them. */
  paste(picture: HTMLCanvasElement | OffscreenCanvas | ImageBitmap, row: number, column: number): void {
    const [left, top, wide, high] = this.layout.part;
    const [x, y] = this.layout.corner(row, column);
    const [across, down] = [picture.width / this.width, picture.height / this.height];
    this.context.drawImage(picture, left * across, top * down, wide * across, high * down, x, y, wide, high);
  }

  /** The sheet as an image file. */
  file(): Promise<Blob> {
    caption(this.context, this.sheet, this.layout);
    return this.canvas.convertToBlob({ type: this.sheet.kind, quality: JPEG_QUALITY });
  }
}

/** The paper, and the names of rows and columns. */
function write(context: OffscreenCanvasRenderingContext2D, sheet: PictureGrid, layout: Layout): void {
  const { letter, corner } = layout;
  const [, , wide, high] = layout.part;
  if (sheet.paper !== null) {
    context.fillStyle = sheet.paper;
    context.fillRect(0, 0, layout.width, layout.height);
  }
  context.fillStyle = INK;
  context.font = font(letter);
  context.textBaseline = "middle";
  for (const [row, name] of sheet.rows.entries()) context.fillText(name, letter / 2, corner(row, 0)[1] + high / 2);
  context.textAlign = "center";
  for (const [column, name] of sheet.columns.entries())
    context.fillText(name, corner(0, column)[0] + wide / 2, letter, wide);
}

function caption(
  context: OffscreenCanvasRenderingContext2D,
  sheet: PictureGrid,
  { letter, corner, part }: Layout,
): void {
  context.textAlign = "left";
  context.font = font(Math.round(0.7 * letter));
  context.fillStyle = "#fff";
  context.shadowColor = "#000";
  context.shadowBlur = letter / 4; // words on fur and skin are read too
  for (const [row, words] of sheet.captions.entries())
    for (const [column, word] of words.entries()) {
      const [x, y] = corner(row, column);
      context.fillText(word, x + letter / 2, y + part[3] - 0.7 * letter, part[2] - letter);
    }
}

const font = (height: number): string => `${height}px sans-serif`;
