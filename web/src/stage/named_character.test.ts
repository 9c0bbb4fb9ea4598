import { expect, it } from "vitest";
import { findCharacter } from "./named_character";

const SHOWN = { one: { label: "Kaori" }, dog: { label: "The Dog" }, two: { label: "Twin" }, three: { label: "twin" } };

it("finds a character by its name or its label, in any case", () => {
  expect(["one", "ONE", "kaori", " the dog "].map((typed) => findCharacter(typed, SHOWN))).toEqual([
    "one",
    "one",
    "one",
    "dog",
  ]);
});

it("finds none where none is meant, or several are", () => {
  expect(["nobody", "Twin", "constructor"].map((typed) => findCharacter(typed, SHOWN))).toEqual([
    undefined,
    undefined,
    undefined,
  ]);
});
