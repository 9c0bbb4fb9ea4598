/** Framings of a scene: where the camera stands for one character, for two, for all. */

import { Frustum, type PerspectiveCamera } from "three";
import { ALL, FRAMING_JOINT } from "../link/constants";
import { heldBy, inSize, PORTRAIT_SIZE, type ShotSize, sizeOf, weightsBy } from "../link/framings";
import {
  AIR,
  aim,
  boxOf,
  cameraPosition,
  headColumns,
  type PictureBox,
  type Point,
  type Shot,
  type WallTile,
} from "./framing";

/** A shot of one character where it stands, and the points of it that a picture has to hold. */
export interface PlacedShot {
  readonly shot: Shot;
  readonly points: readonly Point[];
}

/** A character where it stands: its shots by their sizes, and how far it is on the stage, 0..1. */
export interface PlacedHead {
  readonly shots: ReadonlyMap<ShotSize, PlacedShot>;
  readonly presence: number;
}

type Heads = ReadonlyMap<string, PlacedHead>;

/** The weights of framings by their texts. */
export type Framing = Readonly<Record<string, number>>;

/** The weights of the sizes of shots, which sum to one. */
export type ShotSizes = ReadonlyMap<ShotSize, number>;

/** How much of figures a mix of framings shows; portraits where it is empty. */
export function sizesIn(framing: Framing): ShotSizes {
  const sizes = [...weightsBy(framing, sizeOf)].filter(([, weight]) => weight > 0);
  const whole = sizes.reduce((sum, [, weight]) => sum + weight, 0);
  if (!(whole > 0)) return new Map([[PORTRAIT_SIZE, 1]]);
  return new Map(sizes.map(([size, weight]) => [size, weight / whole]));
}

/** A mix of framings with its portraits as shots of another size. */
export function portraitsAs(framing: Framing, size: ShotSize): Framing {
  const named = (key: string) => (sizeOf(key) === PORTRAIT_SIZE ? inSize(key, size) : key);
  return Object.fromEntries(weightsBy(framing, named));
}

/** A mix of framings with all of its shots as portraits of the same heads. */
export const asPortraits = (framing: Framing): Framing => Object.fromEntries(weightsBy(framing, heldBy));

/**
 * The shots that a framing of all is between, with their weights, which sum to one: those of the n most present, by how much
 * more present the last of them is than the next. So the camera makes room for who comes as they come. With nobody on the
 * stage it holds everybody's places.
 */
export function shotsOfAll(heads: Heads): [string[], number][] {
  const names = [...heads.keys()].sort((name, other) => presenceOf(heads, other) - presenceOf(heads, name));
  const most = names.length > 0 ? presenceOf(heads, names[0] as string) : 0;
  if (most <= 0) return names.length > 0 ? [[names, 1]] : [];
  const shares = names.map((name, at) => presenceOf(heads, name) - presenceOf(heads, names[at + 1] ?? ""));
  return shares.flatMap((share, at) => (share > 0 ? [[names.slice(0, at + 1), share / most]] : []));
}

const presenceOf = (heads: Heads, name: string): number => heads.get(name)?.presence ?? 0;

/** The characters of a framing that there are. */
function namesIn(framing: string, heads: Heads): string[] {
  return heldBy(framing)
    .split(FRAMING_JOINT)
    .filter((name) => heads.has(name));
}

/** One shot that holds several, as near as the largest or nearest of them allows. */
export function groupShot(shots: readonly Shot[], half: number, aspect: number): Shot {
  const [first] = shots;
  if (first !== undefined && shots.length === 1) return first;
  const span = (axis: 0 | 1, size: "width" | "height"): [number, number] => [
    Math.min(...shots.map((shot) => shot.centre[axis] - shot[size] / 2)),
    Math.max(...shots.map((shot) => shot.centre[axis] + shot[size] / 2)),
  ];
  const [left, right] = span(0, "width");
  const [low, high] = span(1, "height");
  const z = Math.max(...shots.map(({ centre }) => centre[2]));
  const [x, y] = [(left + right) / 2, (low + high) / 2];
  // metres from z that the camera stands off for a shot: what lies farther back may reach farther out
  const far = shots.map(({ centre, height, width }) => {
    const [across, up] = [Math.abs(centre[0] - x) + width / 2, Math.abs(centre[1] - y) + height / 2];
    return Math.max(up, across / aspect) / half + centre[2] - z;
  });
  return { centre: [x, y, z], height: 2 * half * Math.max(...far), width: 0 };
}

/** A character in a shot of a size. */
const shotOf = (heads: Heads, name: string, size: ShotSize): PlacedShot =>
  (heads.get(name) as PlacedHead).shots.get(size) as PlacedShot;

/** Where the camera stands for one shot of these characters. */
function standOf(
  names: readonly string[],
  size: ShotSize,
  heads: Heads,
  half: number,
  aspect: number,
): [number, number, number] {
  const held = names.map((name) => shotOf(heads, name, size));
  const shots = held.map(({ shot }) => shot);
  const points = held.flatMap((each) => [...each.points]);
  return cameraPosition(groupShot(shots, half, aspect), points, half, aspect);
}

/** Where the camera stands for a mix of framings: the weighted mean of where it stands for each. */
export function standFor(
  framing: Framing,
  heads: Heads,
  half: number,
  aspect: number,
): [number, number, number] | undefined {
  const shots = Object.entries(framing).flatMap(([key, weight]): [string[], ShotSize, number][] => {
    const [names, size] = [heldBy(key) === ALL ? [] : namesIn(key, heads), sizeOf(key)];
    if (names.length > 0) return [[names, size, weight]];
    return shotsOfAll(heads).map(([group, part]) => [group, size, part * weight]);
  });
  const total = shots.reduce((sum, [, , weight]) => sum + weight, 0);
  if (!(total > 0)) return undefined;
  const mean: [number, number, number] = [0, 0, 0];
  for (const [names, size, weight] of shots) {
    if (weight === 0) continue;
    const stand = standOf(names, size, heads, half, aspect);
    for (const axis of [0, 1, 2] as const) mean[axis] += (stand[axis] * weight) / total;
  }
  return mean;
}

/** How somebody keeps out of a shot of others: metres to the picture's right, and how far below the picture, 0..1. */
export interface Clearance {
  readonly aside: number;
  readonly sunk: number;
}

export const NO_CLEARANCE: Clearance = { aside: 0, sunk: 0 };
/** Half the width of the shoulders, in widths of a head's own shot. */
const SHOULDERS = 1.2;
/** Metres beside those whom a shot holds: who stands nearer goes down instead of aside. */
const BEHIND = 0.12;

/** From 0 to 1 as x does, without a corner. */
const smooth = (x: number): number => {
  const part = Math.min(1, Math.max(0, x));
  return part * part * (3 - 2 * part);
};

/**
 * How everybody keeps out of the shots that do not hold them: beyond the edge of the picture on their own side, or below it
 * where they stand behind (or between) those that are held, each by the weight of the framing. So a shot of one shows one.
 */
export function clearances(framing: Framing, heads: Heads, half: number, aspect: number): Map<string, Clearance> {
  const byName = new Map<string, Clearance>();
  for (const [key, weight] of Object.entries(framing)) {
    const [names, size] = [heldBy(key) === ALL ? [] : namesIn(key, heads), sizeOf(key)];
    if (names.length === 0 || names.length === heads.size || weight === 0) continue;
    const stand = standOf(names, size, heads, half, aspect);
    const held = names.map((name) => shotOf(heads, name, size).shot.centre[0]);
    for (const name of heads.keys()) {
      if (names.includes(name)) continue;
      const { aside, sunk } = byName.get(name) ?? NO_CLEARANCE;
      const more = clearanceFrom(shotOf(heads, name, size), held, stand, half * aspect);
      byName.set(name, { aside: aside + weight * more.aside, sunk: Math.min(1, sunk + weight * more.sunk) });
    }
  }
  return byName;
}

/** How a head keeps out of one shot; `held`: where those stand across that it holds; `wide`: half of what it sees a metre away. */
function clearanceFrom({ shot, points }: PlacedShot, held: readonly number[], stand: Point, wide: number): Clearance {
  const [left, right] = [Math.min(...held), Math.max(...held)];
  const [x, y, z] = shot.centre;
  const side = x > (left + right) / 2 ? 1 : -1;
  const outside = Math.max(left - x, x - right);
  const shoulder: Point = [x - side * SHOULDERS * shot.width, y, z];
  const needs = [...points, shoulder].map(
    (point) => wide * Math.max(0, stand[2] - point[2]) + AIR - side * (point[0] - stand[0]),
  );
  const aside = side * Math.max(0, ...needs) * smooth(outside / BEHIND);
  return { aside, sunk: 1 - smooth((outside - BEHIND) / BEHIND) };
}

/** A character that a camera is pointed at. */
export interface FramedCharacter {
  /** Its farthest points as they were drawn last. */
  readonly seen: readonly Point[];
  /** Where it stands, as far as the camera must know, in shots of these sizes. */
  place(shot: Shot, centred: boolean, sizes: ShotSizes): PlacedHead;
  /** Puts it before the camera, out of shots of others; its points, none where no part of it is in the picture. */
  appear(camera: PerspectiveCamera, frustum: Frustum, clearance: Clearance): readonly Point[];
}

/** Where heads lie in the picture last drawn, by name; those in sight alone. */
export function headBoxes(
  camera: PerspectiveCamera,
  characters: ReadonlyMap<string, Pick<FramedCharacter, "seen">>,
): Map<string, PictureBox> {
  const boxes = [...characters].map(([name, { seen }]) => [name, boxOf(camera, seen)] as const);
  return new Map(boxes.filter((entry): entry is readonly [string, PictureBox] => entry[1] !== null));
}

/** What a picture asks of the camera. */
export interface FramedPicture {
  readonly size: readonly [number, number];
  readonly tile: WallTile | undefined;
  /** The shot of each head. */
  readonly shot: Shot;
  readonly centred: boolean;
}

/**
 * Points the camera as a mix of framings has it, and puts everybody in their places before it; returns the part of the
 * picture's columns that heads lie in. The camera stays where it is while there is nobody.
 */
export function frameScene(
  camera: PerspectiveCamera,
  characters: ReadonlyMap<string, FramedCharacter>,
  framing: Framing,
  { size, tile, shot, centred }: FramedPicture,
): [number, number] {
  const sizes = sizesIn(framing);
  const heads = new Map([...characters].map(([name, character]) => [name, character.place(shot, centred, sizes)]));
  const stood = camera.position.toArray();
  camera.zoom = shot.zoom ?? 1;
  aim(camera, size, tile, (half, aspect) => standFor(framing, heads, half, aspect) ?? stood);
  const frustum = new Frustum().setFromProjectionMatrix(
    camera.projectionMatrix.clone().multiply(camera.matrixWorldInverse),
  );
  const clear = clearances(framing, heads, Math.tan((camera.fov * Math.PI) / 360), camera.aspect);
  const sides = [...characters].flatMap(([name, character]) => {
    const points = character.appear(camera, frustum, clear.get(name) ?? NO_CLEARANCE);
    return points.length > 0 ? [headColumns(camera, points)] : [];
  });
  return [Math.min(1, ...sides.map(([left]) => left)), Math.max(0, ...sides.map(([, right]) => right))];
}
