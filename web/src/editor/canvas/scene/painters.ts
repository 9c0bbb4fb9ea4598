/** Makes all that draws on the canvas, on one context. */

import type { Anatomy } from "../../../face/anatomy/anatomy";
import { Multisampled } from "../../../face/gpu/multisampled";
import { drawsInSoftware } from "../../../face/quality/software_rendering";
import type { Library } from "../../../link/assets";
import { Backgrounds } from "../draw/backgrounds";
import type { FaceAtlas } from "../draw/face_atlas";
import { FacePainter } from "../draw/face_painter";
import { HairLayers } from "../draw/hair_layers";
import { HairPainter } from "../draw/hair_painter";
import { LashPainter } from "../draw/lash_painter";
import { NeedleRenderer } from "../draw/needle_renderer";
import { Repaint } from "../draw/repaint";
import { coarseMeshes } from "../math/coarse_mesh";
import { HairCache } from "./hair_cache";
import { type OverlaidCanvas, Overlay } from "./overlay";
import { TilePainter } from "./tile_painter";
import type { Viewports } from "./viewports";

/** What draws. */
export interface Painters {
  readonly face: FacePainter;
  readonly tiles: TilePainter;
  readonly overlay: Overlay;
  readonly repaint: Repaint;
  readonly hair: HairCache;
  dispose(): void;
}

/** What the painters need of the canvas. */
export interface PaintedCanvas extends OverlaidCanvas {
  readonly viewports: Viewports;
  redraw(): void;
}

/** Painters of the faces of an atlas; the cast's hair comes later and is then drawn. */
export function makePainters(
  gl: WebGL2RenderingContext,
  canvas: PaintedCanvas,
  faceAtlas: FaceAtlas,
  library: Library,
  anatomy: Anatomy,
): Painters {
  const { meshes } = library;
  const face = new FacePainter(gl, faceAtlas, meshes, coarseMeshes(meshes, anatomy), anatomy);
  const hair = new HairPainter(gl, faceAtlas, anatomy, drawsInSoftware());
  const lashes = new LashPainter(gl, faceAtlas, anatomy);
  const overlay = new Overlay(canvas, face, new NeedleRenderer(gl, face));
  const [multisampled, backgrounds] = [new Multisampled(gl), new Backgrounds(gl)];
  const layers = new HairLayers(gl, multisampled);
  const pixels = canvas.viewports.pixels.bind(canvas.viewports);
  const rough = drawsInSoftware();
  const tiles = new TilePainter({ face, hair, lashes, layers, backgrounds, overlay, multisampled, pixels, rough });
  const dispose = (): void => {
    overlay.dispose();
    layers.forget();
    multisampled.dispose();
    hair.dispose();
  };
  const cache = new HairCache(library, hair, () => canvas.redraw());
  return { face, tiles, overlay, repaint: new Repaint(face), hair: cache, dispose };
}
