import { describe, expect, it } from "vitest";
import type { ClipOutline, LaneOutline } from "../../link/messages";
import { curvePath, freeLaneName, laneKey, rulerMarks, spanBetween, viewSpan } from "./timeline";

const lane = (start: number, stop: number): LaneOutline => ({
  name: "",
  parts: ["mouth"],
  weight: 1,
  muted: false,
  shift: 0,
  start,
  stop,
  spans: [],
  moves: {},
});
const clip = (...lanes: LaneOutline[]): ClipOutline => ({
  name: "line",
  start: 0,
  stop: 30,
  trimmed: true,
  blend_in: 0,
  blend_out: 0,
  loop: false,
  speed: 1,
  sound: "",
  sound_at: 0,
  lanes,
  edits: 1,
});

describe("the time line", () => {
  it("shows all lanes and the trim, and grows in steps while it is recorded", () => {
    const shown = viewSpan(clip(lane(-2, 20), lane(1, 40)), 0);
    expect(shown.from).toBe(-2);
    expect(shown.to).toBeGreaterThanOrEqual(40);
    expect(viewSpan(null, 3)).toEqual({ from: 0, to: 10 });
    for (const position of [11, 25, 99]) {
      const { from, to } = viewSpan(null, position);
      expect([from, to % 10]).toEqual([0, 0]);
      expect(to).toBeGreaterThan(position);
    }
  });

  it("has numbers on its ruler that do not touch, at round times", () => {
    expect(rulerMarks({ from: -1, to: 3 }, 80)).toEqual([-1, 0, 1, 2, 3]);
    for (const pixels of [0.5, 3, 20, 150, 900]) {
      const marks = rulerMarks({ from: 0, to: 60 }, pixels);
      const [first = 0, second = 60] = marks;
      expect((second - first) * pixels).toBeGreaterThanOrEqual(60 * Math.min(1, pixels));
    }
  });

  it("selects what lies between two places, and nothing between one and itself", () => {
    expect(spanBetween(4, 1)).toEqual({ from: 1, to: 4 });
    expect(spanBetween(1, 1.01)).toBeNull();
  });

  it("calls a lane by its number, unless another bears it as a name", () => {
    const lanes = [{ name: "2" }, { name: "mouth" }, { name: "" }];
    expect(lanes.map((_, index) => laneKey(lanes, index))).toEqual(["1", "mouth", "3"]);
    expect(laneKey([{ name: "a" }, { name: "a" }], 1)).toBe("2");
  });

  it("finds a name that no lane has", () => {
    expect(freeLaneName([], "mouth")).toBe("mouth");
    expect(freeLaneName([{ name: "mouth" }, { name: "mouth 2" }], "mouth")).toBe("mouth 3");
  });

  it("draws weights from the foot of the box and angles about its middle", () => {
    expect(curvePath([0, 1], false)).toBe("M0.0 96.0L1000.0 4.0");
    expect(curvePath([0, 0.5], true)).toBe("M0.0 50.0L1000.0 4.0");
  });
});
