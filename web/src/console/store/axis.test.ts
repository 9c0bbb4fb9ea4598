import { expect, it } from "vitest";
import type { CallState, CharacterState } from "../../link/messages";
import { followTimed, mixLabel, onAir } from "./axis";

it("lists what is on air, heaviest first, without dust", () => {
  expect(onAir({ a: 0.2, b: 0.8, c: 0.0004, d: -0.05 })).toEqual([
    ["b", 0.8],
    ["a", 0.2],
    ["d", -0.05],
  ]);
});

it("names a mix with its weights, one alone without, and counts those for which there is no line", () => {
  const label = (name: string): string => name.toUpperCase();
  expect(mixLabel({ cat: 0.52, goblin: 0.48 }, label)).toBe("CAT 52\nGOBLIN 48");
  expect(mixLabel({ cat: 1 }, label)).toBe("CAT");
  expect(mixLabel({ cat: 0.998, dog: 0.002 }, label)).toBe("CAT");
  expect(mixLabel({ a: 0.4, b: 0.3, c: 0.2, d: 0.1 }, label)).toBe("A 40\nB 30\n+ 2 more");
  expect(mixLabel({}, label)).toBe("");
});

const call = (target: string, by_hand: boolean, start = { generic: 1 }): CallState => ({
  ...{ target, by_hand, start, progress: 0.4, remaining: by_hand ? null : 2, fader: 0, pickup: 0.4 },
});
const stateWith = (face_call: CallState | null): CharacterState =>
  ({ face_call, expression_call: null }) as unknown as CharacterState;
const followed = (...states: CharacterState[]): boolean | null =>
  states.reduce<[boolean | null, CharacterState | null]>(
    ([timed, last], state) => [followTimed(timed, "face", last, state), state],
    [null, null],
  )[0];

it("knows a call that has seconds from one by hand, also when a T-bar has picked it up", () => {
  expect(followed(stateWith(null), stateWith(call("old", false)), stateWith(call("old", true)))).toBe(true);
  expect(followed(stateWith(null), stateWith(call("old", true)))).toBe(false);
  expect(followed(stateWith(call("old", true)))).toBe(null); // from before this console was there
  const again = call("old", true, { generic: 0.6, old: 0.4 } as unknown as { generic: number });
  expect(followed(stateWith(null), stateWith(call("old", false)), stateWith(call("old", true)), stateWith(again))).toBe(
    false,
  );
  expect(followed(stateWith(call("old", false)), stateWith(null))).toBe(null);
});
