import { expect, test } from "vitest";
import { handleDeform } from "./handle_deform";

/** A head that is a ball of skin, with an eyeball inside its surface, and handles around. */
function sphere(count: number, radius: number, middle: readonly [number, number, number]): number[] {
  return Array.from({ length: count }, (_, n) => {
    const y = 1 - (2 * (n + 0.5)) / count;
    const [ring, turn] = [Math.sqrt(1 - y * y), n * 2.39996];
    return [
      middle[0] + radius * ring * Math.cos(turn),
      middle[1] + radius * y,
      middle[2] + radius * ring * Math.sin(turn),
    ];
  }).flat();
}

const [SKIN, BALL] = [300, 40];
const EYE = [0.03, 0.02, 0.085] as const;
const POSITIONS = Float32Array.from([...sphere(SKIN, 0.1, [0, 0, 0]), ...sphere(BALL, 0.014, EYE)]);
const ROWS = { skin: SKIN, balls: [Uint32Array.from({ length: BALL }, (_, n) => SKIN + n)] };
const HANDLES = [0, 40, 85, 130, 170, 210, 255, 299];
const STILL = new Float64Array(3 * HANDLES.length);
const MOVES = Float64Array.from(STILL, (_, at) => 0.006 * Math.sin(1 + 7 * at));

const near = (values: ArrayLike<number>, wanted: ArrayLike<number>, digits = 6): void => {
  let worst = 0;
  for (let at = 0; at < wanted.length; at++)
    worst = Math.max(worst, Math.abs((values[at] as number) - (wanted[at] as number)));
  expect(worst).toBeLessThan(10 ** -digits);
};

const middleOf = (positions: Float32Array): number[] =>
  [0, 1, 2].map((axis) =>
    [...(ROWS.balls[0] as Uint32Array)].reduce((sum, row) => sum + (positions[3 * row + axis] as number) / BALL, 0),
  );

const heightsOf = (positions: Float32Array): number[] => {
  const middle = middleOf(positions);
  const far = (row: number) =>
    Math.hypot(...[0, 1, 2].map((axis) => (positions[3 * row + axis] as number) - (middle[axis] as number)));
  const radius = Math.sqrt([...(ROWS.balls[0] as Uint32Array)].reduce((sum, row) => sum + far(row) ** 2 / BALL, 0));
  return Array.from({ length: SKIN + BALL }, (_, row) => far(row) / radius);
};

test("at the moves that it was made from a face is what it was", () => {
  near(handleDeform(POSITIONS, ROWS, HANDLES, STILL).at(STILL), POSITIONS);
});

test("handles off the lids arrive where they are put", () => {
  const after = handleDeform(POSITIONS, ROWS, HANDLES, STILL).at(MOVES);
  HANDLES.forEach((row, place) => {
    if ((heightsOf(POSITIONS)[row] as number) < 1.6) return;
    for (let axis = 0; axis < 3; axis++)
      expect(after[3 * row + axis]).toBeCloseTo(
        (POSITIONS[3 * row + axis] as number) + (MOVES[3 * place + axis] as number),
        6,
      );
  });
});

test("what was moved can go back to rest, and on from there", () => {
  const moved = handleDeform(POSITIONS, ROWS, HANDLES, STILL).at(MOVES).slice();
  const again = handleDeform(moved, ROWS, HANDLES, MOVES);
  near(again.at(MOVES), moved, 5);
  near(again.at(STILL), POSITIONS, 5);
});

test("it does not matter in which order handles were moved", () => {
  const shape = handleDeform(POSITIONS, ROWS, HANDLES, STILL);
  const few = MOVES.map((move, at) => (at < 6 ? move : 0));
  const first = shape.at(few).slice();
  shape.at(MOVES);
  near(shape.at(few), first);
  shape.hold(MOVES);
  near(shape.at(few), first);
});

test("an eyeball stays round, and the skin over it as high above it", () => {
  const after = handleDeform(POSITIONS, ROWS, HANDLES, STILL).at(MOVES);
  const [before, now] = [heightsOf(POSITIONS), heightsOf(after)];
  for (const row of ROWS.balls[0] as Uint32Array) expect(now[row]).toBeCloseTo(before[row] as number, 4);
  before.forEach((height, row) => {
    if (row < SKIN && height < 1.12) expect(now[row]).toBeCloseTo(height, 4);
  });
  expect(before.some((height, row) => row < SKIN && height < 1.12)).toBe(true);
});
