import { expect, test } from "vitest";
import type { FaceRecipe, HandlesAsset } from "../../link/editing_messages";
import { strokeOf } from "../canvas/input/handle_drag";
import { boundsOf, Camera, FIRST_VIEW } from "../canvas/math/camera";
import { size } from "../canvas/math/vectors";
import { handlesOf, movedBy, namesOf, withMoves } from "./face_handles";

const ASSET: HandlesAsset = {
  points: [7, 20, 30, 41],
  labels: ["chin", "left ear", "right ear", "nose tip"],
  mirror: [0, 2, 1, 3],
};
const PLAIN: FaceRecipe = {
  kind: "face",
  base: { generic: 1 },
  regions: {},
  amount: 1,
  points: [],
  moves: [],
  gains: [],
  look: {},
};
const HANDLES = handlesOf(ASSET, PLAIN);
const CAMERA = new Camera(
  { ...FIRST_VIEW, yaw: 0.7, pitch: -0.3 },
  { left: 10, top: 20, width: 640, height: 480 },
  boundsOf(Float32Array.from([-0.1, -0.1, -0.1, 0.1, 0.1, 0.1])),
);

test("a face without moved handles has all of the head's, at rest", () => {
  expect(HANDLES.rows).toEqual(ASSET.points);
  expect(HANDLES.mirror).toEqual(ASSET.mirror);
  expect([...HANDLES.moves]).toEqual(new Array(12).fill(0));
});

test("moves go into the recipe and come back", () => {
  const moves = movedBy(HANDLES.moves, HANDLES, [1], [0.01, 0.02, 0.03], true);
  const recipe = withMoves(PLAIN, HANDLES, moves);
  expect(recipe.moves[0]).toEqual([0, 0, 0]);
  const again = handlesOf(ASSET, recipe);
  expect([...again.moves]).toEqual([...moves]);
  expect(again.labels).toEqual(ASSET.labels);
});

test("handles that this head does not know keep their place, without a mirror image", () => {
  const strange = handlesOf(ASSET, {
    points: [30, 99, 20],
    moves: [
      [0, 0, 0],
      [0, 0, 1],
      [0, 0, 0],
    ],
  });
  expect(strange.labels).toEqual(["right ear", "handle 2", "left ear"]);
  expect(strange.mirror).toEqual([2, -1, 0]);
});

test("mirrored, the other side does the same; the midline stays on itself; both sides at once are not moved twice", () => {
  const by = [0.01, 0.02, 0.03] as const;
  expect([...movedBy(HANDLES.moves, HANDLES, [1], by, true)]).toEqual([
    0, 0, 0, 0.01, 0.02, 0.03, -0.01, 0.02, 0.03, 0, 0, 0,
  ]);
  expect([...movedBy(HANDLES.moves, HANDLES, [0], by, true)].slice(0, 3)).toEqual([0, 0.02, 0.03]);
  expect([...movedBy(HANDLES.moves, HANDLES, [0], by, false)].slice(0, 3)).toEqual([...by]);
  const both = movedBy(HANDLES.moves, HANDLES, [1, 2], by, true);
  expect([...both].slice(3, 9)).toEqual([...by, ...by]);
});

test("what is dragged stays under the pointer, or on the line of sight", () => {
  const point = [0.02, 0.03, 0.06] as [number, number, number];
  const [x, y] = CAMERA.project(point);
  const stroke = strokeOf(CAMERA, point, [x, y], [x + 40, y - 25], false);
  const [rightwards, upwards, depth] = CAMERA.project([
    point[0] + stroke[0],
    point[1] + stroke[1],
    point[2] + stroke[2],
  ]);
  expect([rightwards, upwards]).toEqual([expect.closeTo(x + 40, 2), expect.closeTo(y - 25, 2)]);
  expect(depth).toBeCloseTo(CAMERA.project(point)[2], 6);
  const near = strokeOf(CAMERA, point, [x, y], [x, y + 30], true);
  expect(size(near)).toBeCloseTo(30 * CAMERA.metresPerPixel(point), 9);
  const nearer = CAMERA.project([point[0] + near[0], point[1] + near[1], point[2] + near[2]]);
  expect(nearer[2]).toBeLessThan(depth);
});

test("a history names the first handle and counts the others", () => {
  expect(namesOf(HANDLES, [3])).toBe("nose tip");
  expect(namesOf(HANDLES, [1, 0, 2])).toBe("left ear and 2 more");
});
