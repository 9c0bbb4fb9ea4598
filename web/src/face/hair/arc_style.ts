/** A style that tests can reckon with: arcs on a ball around the skull's middle. */

import { Vector3 } from "three";
import type { HairStrands } from "../../link/strands";
import { MIDDLE } from "./radial_map";

/** Metres from the skull's middle to the ball's skin. */
export const BALL = 0.1;
const STATIONS = 8;

/** An arc from a root toward a side, both directions from the middle: so many radians long, so many metres over the skin. */
export interface Arc {
  root: readonly [number, number, number];
  toward: readonly [number, number, number];
  length: number;
  height: number;
}

/** A style of arcs, each carried by row 0 alone. */
export function arcStyle(arcs: readonly Arc[]): HairStrands {
  const places = arcs.length * STATIONS;
  return {
    stations: STATIONS,
    links: 1,
    width: 0.004,
    points: Float32Array.from(
      arcs.flatMap((arc) => Array.from({ length: STATIONS }, (_, at) => placeOn(arc, at)).flat()),
    ),
    rows: new Uint32Array(places),
    weights: new Float32Array(places).fill(1),
    anchors: new Uint32Array(arcs.length),
    facing: new Int8Array(3 * places),
    light: new Uint8Array(places),
    fullness: new Float32Array(arcs.length).fill(1),
  };
}

function placeOn({ root, toward, length, height }: Arc, at: number): [number, number, number] {
  const part = at / (STATIONS - 1);
  const up = new Vector3(...root).normalize();
  const aside = new Vector3(...toward).addScaledVector(up, -up.dot(new Vector3(...toward))).normalize();
  const place = up.multiplyScalar(Math.cos(part * length)).addScaledVector(aside, Math.sin(part * length));
  return place
    .multiplyScalar(BALL + height * Math.min(1, 3 * part))
    .add(MIDDLE)
    .toArray();
}
