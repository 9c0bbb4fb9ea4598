import { beforeEach, describe, expect, it, vi } from "vitest";
import { fans } from "../../../face/anatomy/topology";
import type { DraftState, FaceRecipe } from "../../../link/editing_messages";
import type { Request } from "../../link/requests";
import { DraftStore } from "../../session/draft_store";
import { handlesOf } from "../../session/face_handles";
import { boundsOf, Camera, FIRST_VIEW } from "../math/camera";
import type { Pair } from "../math/vectors";
import type { FaceScene } from "../scene/face_scene";
import { HandleDrag } from "./handle_drag";

const ASSET = { points: [0, 1, 2], labels: ["left ear", "right ear", "chin"], mirror: [1, 0, 2] };
// A plate that faces the camera, with a handle in three of its corners.
const POSITIONS = Float32Array.from([0.05, 0.05, 0.1, -0.05, 0.05, 0.1, 0, -0.05, 0.1, 0, 0.02, 0.101]);
const TRIANGLES = Uint32Array.from([0, 3, 2, 3, 1, 2, 0, 1, 3]);
const BOX = { left: 0, top: 0, width: 600, height: 600 };
const CAMERA = new Camera(FIRST_VIEW, BOX, boundsOf(POSITIONS));

const recipeOf = (more: Partial<FaceRecipe> = {}): FaceRecipe => ({
  kind: "face",
  base: { generic: 1 },
  regions: {},
  amount: 1,
  points: [],
  moves: [],
  gains: [],
  look: {},
  ...more,
});

const draftOf = (recipe: FaceRecipe): DraftState => ({
  type: "draft",
  request: -1,
  item: 1,
  recipe,
  content: "#a",
  undo: 0,
  redo: 0,
  base: 1,
  dirty: false,
  what: "",
  net: null,
  miss: 0,
  others: [],
});

const event = (more: Partial<PointerEvent> = {}): PointerEvent =>
  ({
    button: 0,
    pointerType: "mouse",
    altKey: false,
    shiftKey: false,
    ctrlKey: false,
    metaKey: false,
    ...more,
  }) as PointerEvent;

const at = (row: number): Pair => {
  const [x, y] = CAMERA.project([...POSITIONS.subarray(3 * row, 3 * row + 3)] as [number, number, number]);
  return [x, y];
};

describe("dragged handles", () => {
  let store: DraftStore;
  let asked: Request[];
  let shown: Float64Array[];
  let input: HandleDrag;

  beforeEach(() => {
    asked = [];
    shown = [];
    store = new DraftStore((request) => {
      asked.push(request);
      return new Promise(() => undefined);
    });
    store.receive(draftOf(recipeOf()));
    input = handsOf(store);
  });

  const handsOf = (of: DraftStore): HandleDrag => {
    const faceScene = {
      all: [{ figure: { base: POSITIONS } }],
      handles: handlesOf(ASSET, recipeOf()),
      move: (moves: Float64Array) => shown.push(moves),
    } as unknown as FaceScene;
    return new HandleDrag({
      store: of,
      faceScene,
      fans: fans([TRIANGLES], 4),
      skin: TRIANGLES,
      camera: () => CAMERA,
      redraw: vi.fn(),
    });
  };

  const recipeAsked = (): FaceRecipe => {
    const last = asked.at(-1);
    if (last?.type !== "set_face") throw new Error("nothing was asked of the face");
    return last.recipe;
  };

  it("drags a handle in the plane of the screen, live, and asks once it lets go", () => {
    const [x, y] = at(2);
    expect(input.press([x, y], event())).toBe(true);
    input.drag([x + 30, y + 10], event());
    expect(asked).toEqual([]);
    expect(shown.at(-1)?.slice(0, 6)).toEqual(new Float64Array(6));
    input.release();
    const metresPerPixel = CAMERA.metresPerPixel([0, -0.05, 0.1]);
    const { points, moves } = recipeAsked();
    expect(points).toEqual(ASSET.points);
    expect(moves[2]).toEqual([
      expect.closeTo(30 * metresPerPixel, 9),
      expect.closeTo(-10 * metresPerPixel, 9),
      expect.closeTo(0, 9),
    ]);
  });

  it("goes along the view with Alt, from where it is then", () => {
    const [x, y] = at(0);
    input.press([x, y], event());
    input.drag([x, y - 20], event());
    input.drag([x, y - 20], event({ altKey: true }));
    input.drag([x, y - 5], event({ altKey: true }));
    input.release();
    const [, up, towards] = recipeAsked().moves[0] as [number, number, number];
    expect(up).toBeCloseTo(20 * CAMERA.metresPerPixel([0.05, 0.05, 0.1]), 7);
    expect(towards).toBeCloseTo(15 * CAMERA.metresPerPixel([0.05, 0.05, 0.1]), 7);
  });

  it("does on the other side what it does on one", () => {
    store.setOptions({ mirror: true });
    const [x, y] = at(0);
    input.press([x, y], event());
    input.drag([x + 12, y], event());
    input.release();
    const [left, right] = recipeAsked().moves as unknown as [number[], number[]];
    expect(right[0]).toBeCloseTo(-(left[0] as number), 9);
    expect(left[0]).toBeGreaterThan(0);
  });

  it("takes nothing where no handle is, and asks nothing for a mere press", () => {
    expect(input.press([300, 290], event())).toBe(false);
    input.press(at(2), event());
    input.release();
    expect(asked).toEqual([]);
  });

  it("puts everything back when the hand is taken away", () => {
    const [x, y] = at(2);
    input.press([x, y], event());
    input.drag([x + 30, y], event());
    input.cancel();
    expect(shown.at(-1)).toEqual(new Float64Array(9));
    expect(asked).toEqual([]);
  });

  it("shows again what the server has when it refuses", async () => {
    store = new DraftStore(() => Promise.reject(new Error("handle 2 is moved too far")));
    store.receive(draftOf(recipeOf()));
    input = handsOf(store);
    store.listen("notices", () => input.takeAnswer());
    const [x, y] = at(2);
    input.press([x, y], event());
    input.drag([x + 300, y], event());
    input.release();
    expect(input.ahead).toBe(true);
    await vi.waitFor(() => expect(store.notices).toHaveLength(1));
    expect(shown.at(-1)).toEqual(new Float64Array(9));
  });

  it("adds up nudges until the key is up, and resets what is chosen", () => {
    store.select([2]);
    expect(input.nudge(0.001, 0, 0)).toBe(true);
    input.nudge(0.0002, 0, 0);
    expect(asked).toEqual([]);
    input.endNudge();
    input.endNudge();
    expect(asked).toHaveLength(1);
    expect(recipeAsked().moves[2]?.[0]).toBeCloseTo(0.0012, 9);
    input.reset();
    expect(store.face?.moves[2]).toEqual([0, 0, 0]); // shown at once, asked when the nudges are answered
    store.select([]);
    expect(input.nudge(0.001, 0, 0)).toBe(false);
  });
});
