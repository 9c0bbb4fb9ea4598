import { describe, expect, it } from "vitest";
import { LANDMARKS } from "../../../link/constants";
import type { Triple } from "../../canvas/math/vectors";
import { POINT_LABELS, ScanPoints } from "./scan_points";

const at = (x: number): Triple => [x, 0, 0];

describe("the points of a scan", () => {
  it("go from one to the next that is not set, around at the end", () => {
    const points = new ScanPoints();
    const order = LANDMARKS.map((_, place) => {
      const { chosen } = points;
      points.set(chosen, at(place), { goes: true });
      return chosen;
    });
    expect(order).toEqual([...LANDMARKS]);
    expect(points.chosen).toBe("mouth_right");
    points.remove("nose_tip");
    points.set("mouth_right", at(9), { goes: true });
    expect(points.chosen).toBe("nose_tip");
  });

  it("undo and redo each step, a drag as one, and show whose step it was", () => {
    const points = new ScanPoints();
    points.set("nose_tip", at(1));
    points.set("mouth_left", at(2));
    for (const x of [3, 4, 5]) points.set("mouth_left", at(x), { same: x > 3 });
    points.undo();
    expect([points.given.mouth_left, points.chosen]).toEqual([at(2), "mouth_left"]);
    points.undo();
    points.undo();
    expect([points.given, points.chosen, points.canUndo]).toEqual([{}, "nose_tip", false]);
    points.undo();
    for (let steps = 0; steps < 3; steps += 1) points.redo();
    expect([points.given, points.canRedo]).toEqual([{ nose_tip: at(1), mouth_left: at(5) }, false]);
    points.undo();
    points.set("nose_tip", at(7));
    expect(points.canRedo).toBe(false);
  });

  it("want another fit while they are others than those of the last", () => {
    const points = new ScanPoints();
    expect(points.changed).toBe(false);
    points.set("nose_tip", at(1));
    expect(points.changed).toBe(true);
    points.fitted();
    expect(points.changed).toBe(false);
    points.remove("nose_tip");
    expect(points.changed).toBe(true);
    points.undo();
    expect(points.changed).toBe(false);
    points.remove("mouth_left");
    expect(points.canRedo).toBe(true); // what was not set is not taken back
  });

  it("have a name for people each", () => {
    expect(new Set(LANDMARKS.map((name) => POINT_LABELS[name])).size).toBe(LANDMARKS.length);
  });
});
