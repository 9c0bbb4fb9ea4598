import { describe, expect, it } from "vitest";
import { LEAST_APART, MOST_LOOKS } from "../../link/constants";
import type { PadLook } from "../../link/messages";
import {
  apart,
  freeLabel,
  freeName,
  freePlace,
  nameTaken,
  neutralPlace,
  padName,
  roomiest,
  scaled,
  shownMix,
  spread,
  withLook,
  withMoved,
} from "./pad_layout";

const look = (label: string, ...place: number[]): PadLook => ({ label, mix: { [label.toLowerCase()]: 1 }, place });
const LOOKS = [look("Neutral", 0, 0), look("Joy", 0.5, 0.5), look("Sad", -0.5, -0.5), look("Fear", -0.5, 0.5)];
const SQUARE = { part: "expression", dimensions: 2 } as const;
const least = (looks: readonly PadLook[]): number =>
  Math.min(...looks.flatMap((one, at) => looks.slice(0, at).map((other) => apart(one.place, other.place))));
const onPad = (looks: readonly PadLook[]): boolean =>
  looks.flatMap(({ place }) => place).every((at) => Math.abs(at) <= 1);

describe("a look that is moved", () => {
  it("goes where it is led, on the pad", () => {
    expect(withMoved(LOOKS, 1, [0.25, 3])[1]?.place).toEqual([0.25, 1]);
    expect(withMoved(LOOKS, 1, [0.25, 3])[0]).toBe(LOOKS[0]);
  });

  it("never comes nearer to another than a pad allows, wherever it is led", () => {
    for (let x = -1; x <= 1; x += 0.02)
      for (const y of [-1, -0.5, -0.48, 0, 0.01, 0.5, 1]) {
        const looks = withMoved([...LOOKS, look("Corner", 1, 1), look("Next", 1, 0.93)], 1, [x, y]);
        expect(least(looks)).toBeGreaterThanOrEqual(LEAST_APART);
        expect(onPad(looks)).toBe(true);
      }
  });

  it("finds a way round another on a line too", () => {
    const looks = withMoved([look("A", -0.5), look("B", 0), look("C", 0.5)], 0, [0.01]);
    expect(least(looks)).toBeGreaterThanOrEqual(LEAST_APART);
  });
});

describe("another look", () => {
  it("has a label and a place of its own", () => {
    const looks = withLook(LOOKS, look("joy", 0.5, 0.5)) as PadLook[];
    expect(looks).toHaveLength(5);
    expect(least(looks)).toBeGreaterThanOrEqual(LEAST_APART);
    expect(looks[4]?.label).toBe("joy 2");
    expect(freeLabel("Joy", looks)).toBe("Joy 3");
  });

  it("has no room beside as many as a pad can have", () => {
    const full = Array.from({ length: MOST_LOOKS }, (_, at) => look(`L${at}`, at / 12, 0));
    expect(withLook(full, look("More", -1, -1))).toBeNull();
  });

  it("stands in the roomiest place where no pointer says one", () => {
    expect(roomiest(LOOKS, 2)).toEqual([0.8, -0.8]);
    expect(
      freePlace(
        roomiest(LOOKS, 2),
        LOOKS.map(({ place }) => place),
      ),
    ).toEqual([0.8, -0.8]);
  });
});

describe("all looks", () => {
  it("are spread on a ring around the one at rest, in their order", () => {
    const [rest, ...others] = spread({ ...SQUARE, looks: LOOKS });
    expect(rest?.place).toEqual([0, 0]);
    for (const { place } of others) expect(Math.hypot(...place)).toBeCloseTo(0.8, 9);
    const [joy, sad, fear] = others as [PadLook, PadLook, PadLook];
    expect(apart(joy.place, sad.place)).toBeCloseTo(apart(sad.place, fear.place), 9);
  });

  it("are spread along a line in their order", () => {
    const looks = [look("B", 0.3), look("A", -0.3), look("C", 0.5)];
    const places = spread({ part: "mouth", dimensions: 1, looks }).map(({ place }) => place[0]);
    expect(places[1]).toBe(-0.8);
    expect(places[0]).toBeCloseTo(0, 9);
    expect(places[2]).toBeCloseTo(0.8, 9);
  });

  it("are scaled as far as the pad goes, and as they stay apart", () => {
    expect(scaled(LOOKS, 1.2)[1]?.place).toEqual([0.6, 0.6]);
    expect(onPad(scaled(LOOKS, 100))).toBe(true);
    expect(least(scaled(LOOKS, 0.001))).toBeGreaterThanOrEqual(LEAST_APART);
  });
});

describe("what a pad is told", () => {
  it("rests at the look at rest, else in the middle", () => {
    expect(neutralPlace({ ...SQUARE, looks: [look("Joy", 0.5, 0.5), look("Neutral", -0.2, 0.1)] })).toEqual([
      -0.2, 0.1,
    ]);
    expect(neutralPlace({ ...SQUARE, looks: [look("Joy", 0.5, 0.5)] })).toEqual([0, 0]);
  });

  it("keeps what shows as parts of one, of a region its own mix", () => {
    const air = {
      faces: { generic: 1 },
      expressions: { joy: 0.75, sad: 0.252, fear: -0.002 },
      regions: { mouth: { pout: 1 } },
      figure: null,
    };
    const mix = shownMix("expression", air) as Record<string, number>;
    expect(Object.keys(mix)).toEqual(["joy", "sad"]);
    expect((mix.joy as number) + (mix.sad as number)).toBeCloseTo(1, 12);
    expect(shownMix("mouth", air)).toEqual({ pout: 1 });
    expect(shownMix("brows", air)).toEqual(mix);
    expect(shownMix("face", { ...air, faces: {} })).toBeNull();
    expect(shownMix("pose", air)).toEqual({ stand: 1 });
    const poses = { bow: 0.25, stand: 0.75 };
    const figure = { poses, regions: {}, bodies: {}, pose_call: null, region_calls: {}, body_call: null, fader: 0 };
    expect(shownMix("pose", { ...air, figure })).toEqual(poses);
  });

  it("gives names that an address can have", () => {
    expect(padName("  my mood: 1/2 ")).toBe("my-mood-1-2");
    expect(padName("x".repeat(40))).toHaveLength(24);
    const pads = [{ name: "Moods" }, { name: "lips" }];
    expect(["mOODS", "Moods", "own"].map((name) => nameTaken(name, "lips", pads))).toEqual(["Moods", "Moods", ""]);
    expect(nameTaken("LIPS", "lips", pads)).toBe("");
    expect(freeName("moods", [{ name: "Moods" }, { name: "moods-2" }])).toBe("moods-3");
  });
});
