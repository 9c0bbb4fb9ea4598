import { expect, it } from "vitest";
import type { ExpressionDocument, FaceDocument } from "../../link/messages";
import { expressionGroups, faceGroups, foundIn, type TileGroup } from "./tile_groups";

const face = (name: string, source = name, place = 0) =>
  ({ name, label: name, source, place, tags: [] }) as unknown as FaceDocument;
const unit = (name: string, kind: string, region: string, source = name) =>
  ({ name, label: name, source, place: 0, tags: [], kind, region }) as unknown as ExpressionDocument;
const FACES = [face("late", "#2", 2), face("cat"), face("early", "#1", 1), face("dog")];
const EXPRESSIONS = [
  unit("neutral", "neutral", ""),
  unit("smile", "performed", "mouth"),
  unit("ears-up", "omote", "ears"),
  unit("mine", "own", "", "#3"),
  unit("jawOpen", "arkit", "jaw"),
  unit("browInnerUp", "arkit", "brows"),
];
const named = (groups: readonly TileGroup[]) =>
  groups.map(([heading, tiles]) => [heading, tiles.map((tile) => tile.name)]);

it("puts the crew's own last, in the order in which they were kept", () => {
  expect(named(faceGroups(FACES, false))).toEqual([
    ["", ["cat", "dog"]],
    ["Own", ["early", "late"]],
  ]);
  expect(named(faceGroups(FACES, true))).toEqual([["", ["early", "late"]]]);
});

it("puts units under their regions, and nothing in two kinds", () => {
  expect(named(expressionGroups(EXPRESSIONS, "arkit"))).toEqual([
    ["brows", ["browInnerUp"]],
    ["jaw", ["jawOpen"]],
  ]);
  expect(named(expressionGroups(EXPRESSIONS, "performed"))).toEqual([
    ["", ["neutral", "smile", "ears-up"]],
    ["Own", ["mine"]],
  ]);
  expect(named(expressionGroups(EXPRESSIONS, "own"))).toEqual([["", ["mine"]]]);
});

it("finds by all words, in any case", () => {
  expect(foundIn(EXPRESSIONS, " JAW arkit ").map((tile) => tile.name)).toEqual(["jawOpen"]);
  expect(foundIn(FACES, "own").map((tile) => tile.name)).toEqual(["late", "early"]);
  expect(foundIn(FACES, "cat dog")).toEqual([]);
});
