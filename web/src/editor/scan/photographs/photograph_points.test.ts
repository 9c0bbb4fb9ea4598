import { beforeEach, describe, expect, it } from "vitest";
import { HANDLES, rowOf } from "./photograph_handles";
import { type FoundPhotograph, PhotographPoints } from "./photograph_points";

const photograph = (): FoundPhotograph => ({
  name: "anna.jpg",
  file: "1.jpg",
  picture: new Blob(),
  address: "",
  width: 640,
  height: 480,
  points: Float32Array.from({ length: 3 * 478 }, (_, at) => (at % 97) / 97),
});
const CHIN = HANDLES.findIndex(([label]) => label === "Chin");

describe("the points of photographs", () => {
  let points: PhotographPoints;
  const x = (photograph = 0): number => points.of(photograph)[3 * rowOf(CHIN)] as number;

  beforeEach(() => {
    points = new PhotographPoints([photograph(), photograph()]);
  });

  it("are moved in one photograph, and a drag is one step from where it began", () => {
    const before = x();
    points.move(0, CHIN, [0.01, 0]);
    points.move(0, CHIN, [0.05, 0], true);
    expect(x()).toBeCloseTo(before + 0.05, 6);
    expect(x(1)).toBeCloseTo(before, 6);
    points.undo();
    expect(x()).toBe(before);
    expect(points.canUndo).toBe(false);
    points.redo();
    expect(x()).toBeCloseTo(before + 0.05, 6);
    expect(points.canRedo).toBe(false);
  });

  it("add up from step to step, and a new step ends what could be done again", () => {
    const before = x();
    points.move(0, CHIN, [0.01, 0]);
    points.move(0, CHIN, [0.01, 0]);
    expect(x()).toBeCloseTo(before + 0.02, 6);
    points.undo();
    points.move(1, CHIN, [0.01, 0]);
    expect(points.canRedo).toBe(false);
    points.undo();
    expect(x()).toBeCloseTo(before + 0.01, 6);
  });

  it("have changed until they are fitted, and again when a step is taken back", () => {
    expect(points.changed).toBe(false);
    points.move(0, CHIN, [0.01, 0]);
    expect(points.changed).toBe(true);
    points.undo();
    expect(points.changed).toBe(false);
    points.redo();
    points.fitted();
    expect(points.changed).toBe(false);
    points.undo();
    expect(points.changed).toBe(true);
  });
});
