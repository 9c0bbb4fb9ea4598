/** The lights of a stage (values: `perform/lights.py`), and their mix. */

import { LIGHTS as DECLARED, FIRST_LIGHT } from "../../link/constants";
import type { Triple } from "./tone";

/** What a constant's type stands for: any numbers in the same form. */
type Any<T> = T extends number ? number : { readonly [K in keyof T]: Any<T[K]> };

/** The light of a stage, in linear light; directions are unit vectors, `size` and `shade` as in `perform/lights.py`. */
export type Light = Any<(typeof DECLARED)[keyof typeof DECLARED]>;

/** Weights of lights by name; they sum to one. */
export type LightMix = Readonly<Record<string, number>>;

/** The lights that a show can call. */
export const LIGHTS: Readonly<Record<string, Light>> = DECLARED;

/** Mixes lights by weight: directions turn towards each other, everything else is linear; unknown names weigh nothing. */
export function mixLights(mix: LightMix): Light {
  const names = Object.keys(mix).filter((name) => LIGHTS[name] !== undefined);
  const total = names.reduce((sum, name) => sum + (mix[name] as number), 0);
  if (!(total > 1e-6)) return LIGHTS[FIRST_LIGHT] as Light;
  const shares = names.map((name) => (mix[name] as number) / total);
  return redirected(
    sumOf(
      names.map((name) => LIGHTS[name] as Light),
      shares,
    ),
    unit,
  );
}

/** The sum of share times value, number by number, of values of one form. */
function sumOf<T>(values: readonly T[], shares: readonly number[]): T {
  const [first] = values;
  if (typeof first === "number")
    return values.reduce((sum, value, n) => sum + (shares[n] as number) * Number(value), 0) as T;
  const part = (key: string) =>
    sumOf(
      values.map((value) => (value as Record<string, unknown>)[key]),
      shares,
    );
  if (Array.isArray(first)) return first.map((_, axis) => part(String(axis))) as T;
  return Object.fromEntries(Object.keys(first as object).map((key) => [key, part(key)])) as T;
}

/** A light whose lamps shine from elsewhere: `turn` gives the new direction for each old one. */
const redirected = (light: Light, turn: (direction: Triple) => Triple): Light => ({
  ...light,
  key: { ...light.key, direction: turn(light.key.direction) },
  fill: { ...light.fill, direction: turn(light.fill.direction) },
  rims: { ...light.rims, left: turn(light.rims.left), right: turn(light.rims.right) },
});

/** The vector of length one; straight ahead where there is no direction left. */
function unit([x, y, z]: Triple): Triple {
  const length = Math.hypot(x, y, z);
  return length > 1e-6 ? [x / length, y / length, z / length] : [0, 0, 1];
}

/** The light before another background, one linear colour. */
export const before = (light: Light, background: Triple): Light => ({
  ...light,
  backdrop: { edge: background, glow: background },
});

/** A light by other axes: where its own x, y and z point (unit vectors); a light that goes with a camera, or as a turned head sees it. */
export const lightAlong = (light: Light, axes: readonly [Triple, Triple, Triple]): Light =>
  redirected(light, ([x, y, z]) => {
    const along = (axis: 0 | 1 | 2): number => x * axes[0][axis] + y * axes[1][axis] + z * axes[2][axis];
    return [along(0), along(1), along(2)];
  });

/** A light as somebody sees it who is turned to their left by `turn` radians. */
export function lightTurned(light: Light, turn: number): Light {
  const [across, ahead] = [Math.cos(turn), Math.sin(turn)];
  if (turn === 0) return light;
  return lightAlong(light, [
    [across, 0, ahead],
    [0, 1, 0],
    [-ahead, 0, across],
  ]);
}
