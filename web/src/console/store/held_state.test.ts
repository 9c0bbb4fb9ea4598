import { expect, test } from "vitest";
import type { CharacterState, HeldState } from "../../link/messages";
import { handsOf } from "./held_state";

const air = { channels: { jawOpen: 0.7 }, head: [0.1, 0, 0], gaze: [0.2, 0], held: null } as unknown as CharacterState;

test("faders stand where hands hold them, not where sources play", () => {
  const held: HeldState = { channels: { smile: 0.5 }, head: [0, 0, 0], gaze: [0, 0.1] };
  expect(handsOf({ ...air, held })).toBe(held);
});

test("without layers hands hold what is on air", () => {
  expect(handsOf(air).channels).toEqual({ jawOpen: 0.7 });
});
