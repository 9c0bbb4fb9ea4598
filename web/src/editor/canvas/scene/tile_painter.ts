/** Draws the tiles of the canvas: each face with its eyes, lashes, hair and collar, and what lies over the work. */

import type { Multisampled } from "../../../face/gpu/multisampled";
import type { Backgrounds } from "../draw/backgrounds";
import type { FacePainter, PixelBox } from "../draw/face_painter";
import type { HairLayers } from "../draw/hair_layers";
import type { FaceHair, HairPainter, Target } from "../draw/hair_painter";
import type { LashPainter } from "../draw/lash_painter";
import type { Tile } from "../draw/repaint";
import type { Box } from "../math/boxes";
import { type Ball, shows } from "../model/gaze";
import type { Overlay } from "./overlay";

/** A tile with all that is drawn in it. */
export interface DressedTile extends Tile {
  readonly balls: readonly Ball[];
  readonly pupil: number;
  readonly hair: FaceHair | undefined;
  /** Rises when the face's rows move: hair that was drawn before has stood still since. */
  readonly version: number;
}

/** What draws; all on one context. */
export interface TilePainters {
  readonly face: FacePainter;
  readonly hair: HairPainter;
  readonly lashes: LashPainter;
  readonly layers: HairLayers;
  readonly backgrounds: Backgrounds;
  readonly overlay: Pick<Overlay, "draw">;
  readonly multisampled: Multisampled;
  readonly pixels: (box: Box) => PixelBox;
  /** Whether the canvas itself has one sample a pixel. */
  readonly rough: boolean;
}

export class TilePainter {
  /** By tile: the version of the rows that hair was drawn for, and whether the picture's edges are smooth. */
  private readonly drawn = new Map<number, { version: number; smooth: boolean }>();

  constructor(private readonly painters: TilePainters) {}

  /** Draws parts of tiles as a hand moves what is in them: hair stands still, edges are as the canvas has them. */
  drawParts(tiles: readonly DressedTile[]): void {
    const { backgrounds, pixels, rough } = this.painters;
    for (const tile of tiles) if (!this.fits(tile)) this.drawLayers(tile);
    backgrounds.lay(tiles.map(({ part, ground }) => ({ part: pixels(part), colour: ground })));
    for (const tile of tiles) {
      this.drawFace(tile, { framebuffer: null, box: pixels(tile.camera.box), part: pixels(tile.part) });
      this.mark(tile, !rough);
    }
  }

  /** Draws a whole tile with smooth edges, and its hair where the face has it now. */
  drawWhole(tile: DressedTile): void {
    const { backgrounds, multisampled, pixels, rough, face } = this.painters;
    const whole = { ...tile, part: tile.camera.box, only: undefined };
    if (!this.fits(whole) || this.drawn.get(tile.n)?.version !== tile.version) this.drawLayers(whole);
    const box = pixels(tile.camera.box);
    const [left, bottom, width, height] = box;
    if (rough) {
      const own: PixelBox = [0, 0, width, height];
      multisampled.fit(width, height);
      face.frame(own, own, multisampled.framebuffer);
      face.wipe(tile.ground);
      this.drawFace(whole, { framebuffer: multisampled.framebuffer, box: own, part: own });
      multisampled.showAt(left, bottom, width, height);
    } else {
      backgrounds.lay([{ part: box, colour: tile.ground }]);
      this.drawFace(whole, { framebuffer: null, box, part: box });
    }
    this.mark(tile, true);
  }

  /** Whether a tile is as well drawn as can be. */
  finished({ n, version }: Pick<DressedTile, "n" | "version">): boolean {
    const drawn = this.drawn.get(n);
    return drawn?.smooth === true && drawn.version === version;
  }

  private mark({ n }: DressedTile, smooth: boolean): void {
    const drawn = this.drawn.get(n);
    if (drawn !== undefined) drawn.smooth = smooth;
  }

  private fits(tile: DressedTile): boolean {
    return this.painters.layers.has(tile.n, keyOf(tile));
  }

  /** Draws a face's hair and collar into its layers. */
  private drawLayers(tile: DressedTile): void {
    const { layers, multisampled, pixels, face, hair } = this.painters;
    const { n, version, member, camera } = tile;
    const [, , width, height] = pixels(camera.box);
    const box: PixelBox = [0, 0, width, height];
    const target: Target = { framebuffer: multisampled.framebuffer, box, part: box };
    layers.make(n, keyOf(tile), width, height, (masked) => {
      if (masked) {
        face.frame(box, box, multisampled.framebuffer);
        face.mask(drawnFace(tile), camera);
      }
      hair.draw({ block: member.block, hair: tile.hair }, camera, target);
    });
    this.drawn.set(n, { version, smooth: false });
  }

  private drawFace(tile: DressedTile, target: Target): void {
    const { face, lashes, layers, overlay } = this.painters;
    const { n, member, camera, part, only } = tile;
    const { box, framebuffer } = target;
    const { block, document } = member;
    face.frame(box, target.part, framebuffer);
    layers.lay(n, "behind", box, target.part);
    face.frame(box, target.part, framebuffer);
    const balls = tile.balls.filter((ball) => shows(ball, camera, part));
    face.face({ ...drawnFace(tile), balls }, camera, only?.());
    if (balls.length > 0) lashes.draw(block, document.look, camera, box[3]);
    layers.lay(n, "before", box, target.part);
    face.frame(box, target.part, framebuffer);
    if (n === 0) overlay.draw(block, camera);
  }
}

const drawnFace = ({ member: { block, skinTexture, document }, balls, pupil }: DressedTile) => ({
  block,
  skinTexture,
  look: document.look,
  balls,
  pupil,
});

/** What a picture of hair was made for: another view of it, or another head, needs another. */
const keyOf = ({ member, camera: { box, matrix }, hair }: DressedTile): string =>
  [member.source, hair?.mesh.uuid ?? "", box.width, box.height, ...matrix].join();
