import { beforeEach, describe, expect, it } from "vitest";
import type { FromClient, Place, State } from "../../link/messages";
import { ConsoleStore } from "../store/console_store";
import { extentOf, FARTHEST_TURN, facing, PLACE_PARTS, type PlacePart, Placing, shown, written } from "./placing";

const FRONT: Place = { x: 0, depth: 0, size: 1, turn: 0 };
const part = (name: string) => PLACE_PARTS.find((candidate) => candidate.part === name) as PlacePart;

describe("a number of a place", () => {
  it.each(PLACE_PARTS)("is read as it was written: $part", (placePart) => {
    for (const value of [
      placePart.least,
      placePart.low,
      (placePart.least + placePart.most) / 2,
      placePart.high,
      placePart.most,
    ]) {
      const wire = written(placePart, String(value)) as number;
      expect(Number(shown(placePart, wire))).toBeCloseTo(value, placePart.step < 1 ? 2 : 0);
    }
  });

  it("is in degrees where it turns, and zero has no sign", () => {
    expect(shown(part("turn"), Math.PI / 2)).toBe("90");
    expect(written(part("turn"), "-180")).toBeCloseTo(-Math.PI, 12);
    expect(shown(part("x"), -0.001)).toBe("0.00");
  });

  it.each(["", "  ", "abc", "10.5", "-11", "NaN", "Infinity"])("is rejected in a sentence where it is %j", (text) => {
    expect(written(part("x"), text)).toMatch(/^Left, right: .* is no number from -10 to 10 m\.$/);
  });
});

describe("the map", () => {
  it("shows everybody with room around, and the front line, also with nobody there", () => {
    const places = [{ ...FRONT, x: -3, depth: 4 }, FRONT];
    for (const shown of [places, [], [FRONT]]) {
      const [left, back, width, height] = extentOf(shown);
      expect([-left, -back > 1]).toEqual([left + width, true]);
      expect(back + height).toBeGreaterThan(0);
      for (const { x, depth } of shown) expect([x > left, -depth > back]).toEqual([true, true]);
    }
  });
});

describe("who face each other", () => {
  it("turn to each other's side, to the same degree, and no farther than the audience allows", () => {
    const turns = facing({ a: { ...FRONT, x: -0.35 }, b: { ...FRONT, x: 0.35 } });
    expect(turns).toEqual({ a: FARTHEST_TURN, b: -FARTHEST_TURN });
    const far = facing({ a: FRONT, b: { ...FRONT, x: 0.1, depth: 2 } });
    expect(far.b).toBeCloseTo(Math.atan2(-0.1, 2), 12);
  });

  it("turn to the front where they stand at one place, or alone", () => {
    expect(facing({ a: FRONT, b: FRONT })).toEqual({ a: 0, b: 0 });
    expect(facing({ a: { ...FRONT, turn: 1 } })).toEqual({ a: 0 });
  });
});

describe("placing", () => {
  let sent: FromClient[];
  let store: ConsoleStore;
  let placing: Placing;

  beforeEach(() => {
    sent = [];
    store = new ConsoleStore(
      (message) => sent.push(message),
      () => 0,
      "a",
    );
    placing = new Placing(store);
    store.setOnline(true);
    const one = {
      label: "One",
      presence: 1,
      place: FRONT,
      faces: {},
      channels: {},
      face_call: null,
      expression_call: null,
      home_face: "generic",
    };
    store.receive({ type: "state", characters: { one, two: { ...one, label: "Two" } } } as never as State);
  });

  it("follows a hand with at most one message a frame, and is one step to take back", () => {
    for (const x of [0.1, 0.2]) placing.drag("one", { x });
    placing.drag("one", { depth: 1 });
    store.flush();
    expect(sent).toMatchObject([{ type: "place_character", character: "one", ...FRONT, x: 0.2, depth: 1 }]);
    placing.release();
    placing.release();
    sent.length = 0;
    store.undo();
    store.redo();
    expect(sent).toMatchObject([FRONT, { ...FRONT, x: 0.2, depth: 1 }]);
    expect(store.history.next("undo")?.what).toBe("place One");
  });

  it("is nothing to take back where nothing moved, or nobody is there", () => {
    placing.drag("one", {});
    placing.release();
    placing.drag("nobody", { x: 1 });
    placing.move({ nobody: { x: 1 } }, 1);
    expect(store.history.next("undo")).toBeNull();
  });

  it("moves several in one step", () => {
    placing.move({ one: { turn: 0.5 }, two: { turn: -0.5 } }, 3);
    expect(sent).toMatchObject([
      { character: "one", ...FRONT, turn: 0.5, seconds: 3 },
      { character: "two", ...FRONT, turn: -0.5, seconds: 3 },
    ]);
    sent.length = 0;
    store.undo();
    expect(sent).toMatchObject([
      { character: "one", ...FRONT },
      { character: "two", ...FRONT },
    ]);
  });

  it("says that nothing was sent while the link is lost", () => {
    store.setOnline(false);
    placing.drag("one", { x: 1 });
    placing.release();
    placing.move({ one: { x: 1 } }, 1);
    expect([sent, store.history.next("undo")]).toEqual([[], null]);
    expect(store.notice).toMatch(/Not sent/);
  });
});
