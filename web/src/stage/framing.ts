import { PerspectiveCamera } from "three";
import type { Tile } from "./parameters";

/** What the picture shows: `centre` of the head in metres and the `height` and `width` that must be seen. */
export interface Shot {
  centre: [number, number, number];
  height: number;
  width: number;
}

/** The rectangle of one tile in its wall's picture, in pixels of the tile. */
export function tileView(tile: Tile, width: number, height: number): [number, number, number, number, number, number] {
  const [across, down] = [width * (1 + tile.bezel[0]), height * (1 + tile.bezel[1])]; // picture to picture
  const wallWidth = across * (tile.columns - 1) + width;
  const wallHeight = down * (tile.rows - 1) + height;
  return [wallWidth, wallHeight, tile.column * across, tile.row * down, width, height];
}

/** Points the camera so that the shot fills a picture of `width` x `height` pixels, or this tile's part of the wall's. */
export function frame(camera: PerspectiveCamera, shot: Shot, width: number, height: number, tile?: Tile): void {
  const [fullWidth, fullHeight] = tile === undefined ? [width, height] : tileView(tile, width, height);
  camera.aspect = fullWidth / fullHeight;
  const half = Math.tan((camera.fov * Math.PI) / 360);
  const distance = Math.max(shot.height, shot.width / camera.aspect) / 2 / half;
  camera.position.set(shot.centre[0], shot.centre[1], shot.centre[2] + distance);
  if (tile === undefined) camera.clearViewOffset();
  else camera.setViewOffset(...tileView(tile, width, height));
  camera.updateProjectionMatrix();
  camera.updateMatrixWorld();
}

/** A camera with the long lens of a portrait. */
export const portraitCamera = (): PerspectiveCamera => new PerspectiveCamera(18, 1, 0.1, 10);
