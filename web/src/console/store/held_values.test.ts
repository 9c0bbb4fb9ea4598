import { expect, it } from "vitest";
import { ECHO, HeldValues } from "./held_values";

const LATER = 1e9;

it("shows the server's value while nobody touches", () => {
  expect(new HeldValues<number>().read("jaw", 0.3, 0)).toBe(0.3);
});

it("shows the hand's value as long as the hand is on it, whatever the server says", () => {
  const holds = new HeldValues<number>();
  holds.grip("jaw", 0.7);
  expect(holds.read("jaw", 0.1, LATER)).toBe(0.7);
  expect(holds.gripped("jaw")).toBe(true);
  expect(holds.read("smile", 0.1, LATER)).toBe(0.1);
});

it("keeps the hand's value for a moment after it let go, then follows: the last touch wins", () => {
  const holds = new HeldValues<number>();
  holds.grip("jaw", 0.7);
  holds.leave("jaw", 1000);
  expect(holds.gripped("jaw")).toBe(false);
  expect(holds.read("jaw", 0.1, 1000 + ECHO - 1)).toBe(0.7);
  expect(holds.read("jaw", 0.1, 1000 + ECHO)).toBe(0.1);
});

it("does not let go of a grip because a key steps it", () => {
  const holds = new HeldValues<number>();
  holds.grip("jaw", 0.7);
  holds.nudge("jaw", 0.8, 0);
  expect(holds.read("jaw", 0.1, LATER)).toBe(0.8);
});

it("gives a nudged value back a moment after it was sent, however long the page took to send it", () => {
  const holds = new HeldValues<number>();
  holds.nudge("jaw", 0.8, 50);
  expect(holds.read("jaw", 0.1, LATER)).toBe(0.8);
  expect(holds.counts("jaw", LATER)).toBe(true);
  holds.sent(LATER);
  expect(holds.read("jaw", 0.1, LATER + ECHO - 1)).toBe(0.8);
  holds.sent(LATER + ECHO - 1); // what was sent already is not sent again
  expect(holds.read("jaw", 0.1, LATER + ECHO)).toBe(0.1);
  expect(holds.counts("jaw", LATER + ECHO)).toBe(false);
});

it("has nothing to hold after all hands are off", () => {
  const holds = new HeldValues<number>();
  holds.grip("jaw", 0.7);
  holds.clear();
  expect(holds.read("jaw", 0.1, 0)).toBe(0.1);
});

it("leaves what was never held alone", () => {
  const holds = new HeldValues<number>();
  holds.leave("jaw", 0);
  expect(holds.read("jaw", 0.1, 0)).toBe(0.1);
});
