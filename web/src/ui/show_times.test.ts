import { expect, it } from "vitest";
import { ageOf, clockOf, sinceOf } from "./show_times";

it("reads the time that has passed, and never a negative one", () => {
  expect([-1, 0, 59.9, 249, 3600, 36_001].map(sinceOf)).toEqual([
    "0:00:00",
    "0:00:00",
    "0:00:59",
    "0:04:09",
    "1:00:00",
    "10:00:01",
  ]);
});

it("says how old something is that has not just been", () => {
  expect([0, 59, 60, 3599, 3600, 172_799, 172_800].map(ageOf)).toEqual([
    "",
    "",
    "1 min ago",
    "59 min ago",
    "1 h ago",
    "47 h ago",
    "2 days ago",
  ]);
});

it("reads the clock of this place in 24 hours", () => {
  expect(clockOf(new Date(2026, 1, 3, 20, 4, 9))).toBe("20:04:09");
});
