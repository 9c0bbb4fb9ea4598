import { describe, expect, it } from "vitest";
import type { SourceKind } from "../../link/assets";
import { type Pose, restPose, STANDING } from "./pose";
import { type Arrival, SourceCrossfade } from "./source_crossfade";

const FRAME = 1 / 60;
const shown: Arrival = () => "shown";

/** What names stand for, to be changed by the test. */
const cast = (sources: Record<string, string>) => ({
  known: sources,
  sourceOf: (_: SourceKind, name: string): string => sources[name] ?? name,
});
const sum = (weights: Record<string, number>): number =>
  Object.values(weights).reduce((total, part) => total + part, 0);

describe("a source crossfade", () => {
  it("names what stands for a name, and leaves the built-in cast as it is", () => {
    const sourceCrossfade = new SourceCrossfade(cast({ grin: "#1" }));
    const pose: Pose = { ...restPose("dog", "grin"), channels: { smile: 0.5 } };
    const shownPose = sourceCrossfade.pose(pose, FRAME, shown);
    expect([shownPose.faces, shownPose.expressions, shownPose.channels]).toEqual([
      { dog: 1 },
      { "#1": 1 },
      { smile: 0.5 },
    ]);
    expect(sourceCrossfade.settled(pose)).toBe(true);
  });

  it("passes poses over too, of the whole figure and of its regions", () => {
    const sources = cast({ greet: "#1", nod: "#2" });
    const sourceCrossfade = new SourceCrossfade(sources);
    const figure = { ...STANDING, poses: { greet: 0.5, stand: 0.5 }, regions: { head: { nod: 1 } } };
    const pose: Pose = { ...restPose("dog"), figure };
    expect(sourceCrossfade.pose(pose, FRAME, shown).figure).toEqual({
      ...figure,
      poses: { "#1": 0.5, stand: 0.5 },
      regions: { head: { "#2": 1 } },
    });
    Object.assign(sources.known, { greet: "#3" });
    for (let time = 0; time < 0.3; time += FRAME) {
      const { poses, regions } = sourceCrossfade.pose(pose, FRAME, shown).figure ?? STANDING;
      expect([sum(poses), regions]).toEqual([expect.closeTo(1), { head: { "#2": 1 } }]);
    }
    expect(sourceCrossfade.pose(pose, 0, shown).figure?.poses).toEqual({ "#3": 0.5, stand: 0.5 });
    expect(sourceCrossfade.settled(pose)).toBe(true);
  });

  it("passes from the old to the new within a quarter of a second, without a jump, and the sum stays", () => {
    const sources = cast({ grin: "#1", kin: "#3" });
    const sourceCrossfade = new SourceCrossfade(sources);
    const pose: Pose = { ...restPose("kin", "grin"), channels: { grin: -0.5 }, added: { grin: 0.2 } };
    sourceCrossfade.pose(pose, FRAME, shown);
    Object.assign(sources.known, { grin: "#2", kin: "#4" });
    expect(sourceCrossfade.settled(pose)).toBe(false);
    let last = 0;
    for (let frame = 0; frame < 16; frame++) {
      const { expressions, channels, added, faces } = sourceCrossfade.pose(pose, FRAME, shown);
      const part = expressions["#2"] ?? 0;
      expect(part).toBeGreaterThanOrEqual(last);
      expect(part - last).toBeLessThan(0.11);
      expect(channels["#2"]).toBeCloseTo(-0.5 * part);
      expect(added["#2"]).toBeCloseTo(0.2 * part);
      expect(faces["#4"]).toBeCloseTo(part);
      for (const weights of [expressions, faces]) expect(sum(weights)).toBeCloseTo(1);
      last = part;
    }
    expect(sourceCrossfade.pose(pose, 0, shown).expressions).toEqual({ "#2": 1 });
    expect(sourceCrossfade.settled(pose)).toBe(true);
  });

  it("waits until the new is loaded, and shows next to nothing of it until it is drawn", () => {
    const sources = cast({ grin: "#1" });
    const sourceCrossfade = new SourceCrossfade(sources);
    const pose = restPose("dog", "grin");
    sourceCrossfade.pose(pose, FRAME, shown);
    sources.known.grin = "#2";
    expect(sourceCrossfade.wanted("expressions", ["grin"])).toEqual(["#1", "#2"]);
    for (let frame = 0; frame < 100; frame++)
      expect(sourceCrossfade.pose(pose, FRAME, () => "away").expressions).toEqual({ "#1": 1 });
    for (let frame = 0; frame < 100; frame++) {
      const { expressions } = sourceCrossfade.pose(pose, FRAME, () => "here");
      expect(expressions["#2"]).toBeLessThan(0.01);
      expect(expressions["#2"]).toBeGreaterThan(0);
    }
    for (let frame = 0; frame < 16; frame++) sourceCrossfade.pose(pose, FRAME, shown);
    expect(sourceCrossfade.pose(pose, FRAME, shown).expressions).toEqual({ "#2": 1 });
  });

  it("asks for the new expression on the faces on air, and for the new face in what it wears", () => {
    const sources = cast({ grin: "#1", kin: "#3" });
    const sourceCrossfade = new SourceCrossfade(sources);
    const pose = restPose("kin", "grin");
    sourceCrossfade.pose(pose, FRAME, shown);
    Object.assign(sources.known, { grin: "#2", kin: "#4" });
    const asked: unknown[] = [];
    sourceCrossfade.pose(pose, FRAME, (faces, expressions) => {
      asked.push([faces, expressions]);
      return "away";
    });
    expect(asked).toEqual([
      [["#4"], ["#1"]],
      [["#3"], ["#2"]],
    ]);
  });

  it("changes in a region as on the whole face", () => {
    const sources = cast({ grin: "#1" });
    const sourceCrossfade = new SourceCrossfade(sources);
    const pose = { ...restPose("dog"), regions: { mouth: { grin: 1 } } };
    expect(sourceCrossfade.pose(pose, FRAME, shown).regions).toEqual({ mouth: { "#1": 1 } });
    sources.known.grin = "#2";
    expect(sourceCrossfade.settled(pose)).toBe(false);
    const half = sourceCrossfade.pose(pose, 0.125, shown).regions.mouth ?? {};
    expect((half["#1"] ?? 0) + (half["#2"] ?? 0)).toBeCloseTo(1, 12);
    for (let frame = 0; frame < 16; frame++) sourceCrossfade.pose(pose, FRAME, shown);
    expect(sourceCrossfade.pose(pose, FRAME, shown).regions).toEqual({ mouth: { "#2": 1 } });
    expect(sourceCrossfade.settled(pose)).toBe(true);
  });

  it("turns round smoothly when it is changed again on the way", () => {
    const sources = cast({ grin: "#1" });
    const sourceCrossfade = new SourceCrossfade(sources);
    const pose = restPose("dog", "grin");
    sourceCrossfade.pose(pose, FRAME, shown);
    sources.known.grin = "#2";
    let before: Record<string, number> = {};
    for (let frame = 0; frame < 7; frame++) before = sourceCrossfade.pose(pose, FRAME, shown).expressions;
    sources.known.grin = "#3";
    const after = sourceCrossfade.pose(pose, 0, shown).expressions;
    for (const source of ["#1", "#2"]) expect(after[source]).toBeCloseTo(before[source] as number, 2);
    for (let frame = 0; frame < 16; frame++) sourceCrossfade.pose(pose, FRAME, shown);
    expect(sourceCrossfade.pose(pose, FRAME, shown).expressions).toEqual({ "#3": 1 });
  });

  it("changes at once what is not on air, what nobody knew, and everything when told to", () => {
    const sources = cast({ grin: "#1" });
    const sourceCrossfade = new SourceCrossfade(sources);
    sourceCrossfade.pose(restPose("dog", "grin"), FRAME, shown);
    sourceCrossfade.pose(restPose("dog"), FRAME, shown);
    sources.known.grin = "#2";
    expect(sourceCrossfade.pose(restPose("dog", "grin"), 0, shown).expressions).toEqual({ "#2": 1 });
    sourceCrossfade.pose(restPose("dog", "new"), 0, shown);
    sources.known.new = "#5";
    expect(sourceCrossfade.pose(restPose("dog", "new"), 0, shown).expressions).toEqual({ "#5": 1 });
    sources.known.new = "#6";
    expect(sourceCrossfade.pose(restPose("dog", "new"), 0, () => "away", true).expressions).toEqual({ "#6": 1 });
  });
});
