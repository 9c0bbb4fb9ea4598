/** Framing: where the camera stands for a shot, and the part of a wall that one stage shows. */

import { type Matrix3, PerspectiveCamera, Vector3 } from "three";

/** A stage's place on a wall: column and row of `columns` x `rows`, and the bezel between pictures. */
export interface WallTile {
  column: number;
  row: number;
  columns: number;
  rows: number;
  /** Width of the gap between two pictures, as a part of a picture's width and of its height. */
  bezel: [number, number];
}

/**
 * What the picture shows: `centre` of the head in metres and the `height` and `width` that must be seen; `zoom`: of that,
 * the middle alone, so many times larger.
 */
export interface Shot {
  centre: [number, number, number];
  height: number;
  width: number;
  zoom?: number;
}

/** The head with its collar, as a director frames it. */
export const PORTRAIT: Shot = { centre: [0, -0.011, 0.05], height: 0.305, width: 0.23 };

/**
 * Close on brows, eyes and mouth: what tells one expression from another on a picture as small as a thumb. It is cut out
 * of a portrait, as those that come with the pages are (tools/pictures/portraits.py): a shot would step back for the ears.
 */
export const THUMBNAIL: Shot = { ...PORTRAIT, centre: [0, -0.014, 0.05], zoom: PORTRAIT.height / 0.185 };

/** Behind figures in pictures of them, whose suits are black: grey in linear light. */
export const FIGURE_GROUND: [number, number, number] = [0.1, 0.105, 0.115];

export type Point = readonly [number, number, number];

/** The rectangle of one tile in its wall's picture, in pixels of the tile. */
export function tileView(
  tile: WallTile,
  width: number,
  height: number,
): [number, number, number, number, number, number] {
  const [across, down] = [width * (1 + tile.bezel[0]), height * (1 + tile.bezel[1])]; // picture to picture
  const wallWidth = across * (tile.columns - 1) + width;
  const wallHeight = down * (tile.rows - 1) + height;
  return [wallWidth, wallHeight, tile.column * across, tile.row * down, width, height];
}

/** Hair, and air around what a picture has to hold, metres. */
export const AIR = 0.012;

/** Points of a head that turns about a pivot, which is carried to `place`. */
export function turnedAbout(points: readonly Point[], pivot: Vector3, turn: Matrix3, place = pivot): Point[] {
  return points.map((point) => new Vector3(...point).sub(pivot).applyMatrix3(turn).add(place).toArray());
}

/** A shot that keeps a turned head where it is straight: by the middle of its farthest points but the lowest, the neck's. */
export function following(shot: Shot, straight: readonly Point[], turned: readonly Point[]): Shot {
  const lowest = straight.reduce((low, point, at) => (point[1] < (straight[low] as Point)[1] ? at : low), 0);
  const middle = (points: readonly Point[], axis: 0 | 1): number => {
    const values = points.filter((_, at) => at !== lowest).map((point) => point[axis]);
    return (Math.min(...values) + Math.max(...values)) / 2;
  };
  if (straight.length < 2) return shot;
  const [x, y, z] = shot.centre;
  const moved = (axis: 0 | 1): number => middle(turned, axis) - middle(straight, axis);
  return { ...shot, centre: [x + moved(0), y + moved(1), z] };
}

/** Where the camera stands for a shot that also holds `points`: a little aside first, then farther away. */
export function cameraPosition(
  shot: Shot,
  points: readonly Point[],
  half: number,
  aspect: number,
): [number, number, number] {
  const [x, y, z] = shot.centre;
  const near = Math.max(shot.height, shot.width / aspect) / 2 / half;
  const wide = (depth: number): number => (near - (depth - z)) * half * aspect;
  const over = (side: 1 | -1): number =>
    Math.max(0, ...points.map((point) => side * (point[0] - x) + AIR - wide(point[2])));
  const aside = x + (over(1) - over(-1)) / 2;
  const far = points.flatMap((point) => [
    (Math.abs(point[0] - aside) + AIR) / (half * aspect) + (point[2] - z), // nothing is cut off at a side
    (point[1] - y + AIR) / half + (point[2] - z), // nor above; below, the neck goes on
  ]);
  return [aside, y, z + Math.max(near, ...far)];
}

/**
 * Points the camera from where it stands for a picture of `width` x `height` pixels, or this tile's part of the wall's.
 * `stand`: where that is, by half the height and width of what the camera sees a metre away.
 */
export function aim(
  camera: PerspectiveCamera,
  [width, height]: readonly [number, number],
  tile: WallTile | undefined,
  stand: (half: number, aspect: number) => [number, number, number],
): void {
  const [fullWidth, fullHeight] = tile === undefined ? [width, height] : tileView(tile, width, height);
  camera.aspect = fullWidth / fullHeight;
  camera.position.set(...stand(Math.tan((camera.fov * Math.PI) / 360), camera.aspect));
  if (tile === undefined) camera.clearViewOffset();
  else camera.setViewOffset(...tileView(tile, width, height));
  camera.updateProjectionMatrix();
  camera.updateMatrixWorld();
}

/** Points the camera so that the shot, and the points of the head, fill the picture. */
export function frame(
  camera: PerspectiveCamera,
  shot: Shot,
  points: readonly Point[],
  width: number,
  height: number,
  tile?: WallTile,
): void {
  aim(camera, [width, height], tile, (half, aspect) => cameraPosition(shot, points, half, aspect));
}

/** How far hair and collar may stand out from the farthest points of a head at its sides, metres. */
const HAIR = 0.015;

/** The part of a picture's columns that a head with these farthest points lies in, hair and all: shares of its width. */
export function headColumns(camera: PerspectiveCamera, points: readonly Point[]): [number, number] {
  const at = points.flatMap(([x, y, z]) =>
    [-HAIR, HAIR].map((aside) => (1 + new Vector3(x + aside, y, z).project(camera).x) / 2),
  );
  return [Math.max(0, Math.min(1, ...at)), Math.min(1, Math.max(0, ...at))];
}

/** Left, top, right and bottom as parts of a picture. */
export type PictureBox = readonly [number, number, number, number];

/** The part of the picture that points lie in; null where that is none. */
export function boxOf(camera: PerspectiveCamera, points: readonly Point[]): PictureBox | null {
  const seen = points.map((point) => new Vector3(...point).project(camera));
  const [across, down] = [seen.map(({ x }) => (1 + x) / 2), seen.map(({ y }) => (1 - y) / 2)];
  const box: PictureBox = [Math.min(...across), Math.min(...down), Math.max(...across), Math.max(...down)];
  const [left, top, right, bottom] = box;
  return left < 1 && right > 0 && top < 1 && bottom > 0 ? box : null;
}

/** A head to be framed: its farthest points while it is straight, and how it is turned about a pivot, which is at a place. */
export interface FramedHead {
  straight: readonly Point[];
  pivot: { readonly value: Vector3 };
  headPlace: { readonly value: Vector3 };
  headTurn: { readonly value: Matrix3 };
  /** Whether it stays in the middle of the picture when it turns. */
  centred: boolean;
}

/** The shot of a head, and its farthest points as it is turned. */
export function shotOfHead(
  shot: Shot,
  { straight, pivot, headTurn, headPlace, centred }: FramedHead,
): { shot: Shot; points: Point[] } {
  const points = turnedAbout(straight, pivot.value, headTurn.value, headPlace.value);
  return { shot: centred ? following(shot, straight, points) : shot, points };
}

/** A camera with the long lens of a portrait. */
export const portraitCamera = (): PerspectiveCamera => new PerspectiveCamera(18, 1, 0.1, 10);
