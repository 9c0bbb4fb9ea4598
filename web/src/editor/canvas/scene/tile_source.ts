/** What of each face is drawn now: from where, which part of it, with what eyes. */

import type { Recipe } from "../../../link/editing_messages";
import type { Manifest } from "../../../link/messages";
import type { DraftStore } from "../../session/draft_store";
import type { DrawnFace, ShownFace } from "../draw/drawn_face";
import { HEAD } from "../draw/overlay_meshes";
import type { Camera } from "../math/camera";
import { gazeOf, shows } from "../model/gaze";
import { complexionOfRecipe } from "../model/recipe_complexion";
import { boxOf } from "../model/spread";
import type { ExpressionScene } from "./expression_scene";
import type { CanvasTile } from "./tile_painter";
import type { Viewports } from "./viewports";

/** What tiles depend on. */
export interface TiledCanvas {
  readonly store: DraftStore;
  readonly viewports: Viewports;
  readonly editsFace: boolean;
  readonly input: { readonly over: number; readonly picker: { readonly needleLength: number } };
}

/** Metres that lashes reach from the lids' edges at most. */
const LASHES = 0.009;

export class TileSource {
  constructor(private readonly canvas: TiledCanvas) {}

  /** Face `n` as it is drawn: all of it or what a hand has changed; nothing when nothing of it is, or before it is here. */
  tile(
    scene: ExpressionScene,
    member: ShownFace | undefined,
    n: number,
    whole: boolean,
    version: number,
  ): CanvasTile[] {
    const { viewports, editsFace, input, store } = this.canvas;
    const drawn = member?.drawn;
    if (member === undefined || drawn === undefined) return [];
    const camera = viewports.camera(n, member.bounds);
    const { shownRecipe, layerPreview, liveEyes, liveComplexion, manifest } = store;
    const hand = layerPreview.solo.size > 0 && shownRecipe ? handOf(shownRecipe) : liveEyes;
    drawn.look(gazeOf(shownRecipe, hand, manifest as Manifest));
    const blood = hand === liveEyes ? liveComplexion : (shownRecipe?.complexion ?? []);
    const bled = drawn.bleed(complexionOfRecipe(shownRecipe, blood, manifest as Manifest));
    const all = { part: camera.box, reach: undefined };
    const changed = editsFace ? all : this.changed(scene, member, drawn, n, camera); // remembered for the next time
    const { part, reach } = whole || bled ? all : changed;
    if (part.width === 0 || part.height === 0) return [];
    const ground = input.over === n && n > 0 ? viewports.hovered : viewports.tile(n);
    return [{ n, drawn, camera, part, reach, ground, version }];
  }

  /** What of a face's tile the hand has changed; around it the work's needles stand too, and lashes. */
  private changed(
    scene: ExpressionScene,
    member: ShownFace,
    drawn: DrawnFace,
    n: number,
    camera: Camera,
  ): Pick<CanvasTile, "part" | "reach"> {
    const spread = scene.spread(member);
    const needle = n > 0 ? 0 : this.canvas.input.picker.needleLength + 2 * HEAD * camera.metresPerPixel(camera.middle);
    const haired = boxOf(camera, spread, Math.max(needle, LASHES));
    const box = drawn.balls.some((ball) => shows(ball, camera, haired)) ? haired : boxOf(camera, spread, needle);
    return { part: drawn.repaint.next(box, camera.box), reach: spread.reach };
  }
}

const handOf = ({ eyes, pupil }: Recipe) => ({ turns: eyes, pupil });
