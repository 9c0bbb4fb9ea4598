import { expect, it } from "vitest";
import { othersOf } from "./item_commands";

it("counts oneself among those at an item once, whoever bears the same name", () => {
  expect(othersOf(["Ann", "Ben"], "Ann")).toEqual(["Ben"]);
  expect(othersOf(["Ann", "Ann"], "Ann")).toEqual(["Ann"]);
  expect(othersOf(["Ben"], "Ann")).toEqual(["Ben"]);
});
