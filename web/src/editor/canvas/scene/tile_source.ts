/** What of each face is drawn now: from where, which part of it, with what eyes and hair. */

import type { Recipe } from "../../../link/editing_messages";
import type { Manifest } from "../../../link/messages";
import type { DraftStore } from "../../session/draft_store";
import { HEAD } from "../draw/needle_renderer";
import type { Changed } from "../draw/repaint";
import { ballsOf, gazeOf, shows } from "../model/gaze";
import type { ShownFace } from "../model/shown_face";
import { boxOf } from "../model/spread";
import type { ExpressionScene } from "./expression_scene";
import type { Painters } from "./painters";
import type { DressedTile } from "./tile_painter";
import type { Viewports } from "./viewports";

/** What tiles depend on. */
export interface TiledCanvas {
  readonly store: DraftStore;
  readonly viewports: Viewports;
  readonly editsFace: boolean;
  readonly input: { readonly over: number; readonly picker: { readonly needleLength: number } };
}

/** A face from where it is seen, and its eyes. */
type SeenFace = Pick<DressedTile, "member" | "n" | "camera" | "balls">;

/** Metres that lashes reach from the lids' edges at most. */
const LASHES = 0.009;

export class TileSource {
  /** `frames`: how each eyeball's axes are read (`ballFrames`). */
  constructor(
    private readonly canvas: TiledCanvas,
    private readonly painters: Pick<Painters, "hair" | "repaint">,
    private readonly frames: Parameters<typeof ballsOf>[0],
  ) {}

  /** Whether a face can be drawn: it is here, and so is its hair. */
  shown(member: ShownFace | undefined): member is ShownFace {
    return member !== undefined && member.block >= 0 && this.painters.hair.of(member) !== "awaited";
  }

  /** Face `n` as it is drawn: all of it or what a hand has changed; nothing when nothing of it is, or before it is here. */
  tile(
    scene: ExpressionScene,
    member: ShownFace | undefined,
    n: number,
    whole: boolean,
    version: number,
  ): DressedTile[] {
    const { viewports, editsFace, input, store } = this.canvas;
    const hair = member && this.painters.hair.of(member);
    if (!this.shown(member) || hair === "awaited") return [];
    const camera = viewports.camera(n, member.bounds);
    const { shownRecipe, layerPreview, liveEyes, manifest } = store;
    const hand = layerPreview.solo.size > 0 && shownRecipe ? handOf(shownRecipe) : liveEyes;
    const { angles, pupil } = gazeOf(shownRecipe, hand, manifest as Manifest);
    const balls = ballsOf(this.frames, member.figure.base, angles);
    const all: Changed = { part: camera.box };
    const changed = editsFace ? all : this.changed(scene, { member, n, camera, balls }); // remembered for the next time
    const { part, only } = whole ? all : changed;
    if (part.width === 0 || part.height === 0) return [];
    const ground = input.over === n && n > 0 ? viewports.hovered : viewports.tile(n);
    return [{ n, member, camera, part, only, ground, balls, pupil, hair, version }];
  }

  /** What of a face's tile the hand has changed; around it the work's needles stand too, and lashes. */
  private changed(scene: ExpressionScene, { member, n, camera, balls }: SeenFace): Changed {
    const { repaint } = this.painters;
    const spread = scene.spread(member);
    const needle = n > 0 ? 0 : this.canvas.input.picker.needleLength + 2 * HEAD * camera.metresPerPixel(camera.middle);
    const haired = boxOf(camera, spread, Math.max(needle, LASHES));
    const box = balls.some((ball) => shows(ball, camera, haired)) ? haired : boxOf(camera, spread, needle);
    const part = repaint.next(n, box, camera.box);
    return { part, only: () => repaint.triangles(n, part, camera, member.figure.base, spread.reach) };
  }
}

const handOf = ({ eyes, pupil }: Recipe) => ({ turns: eyes, pupil });
