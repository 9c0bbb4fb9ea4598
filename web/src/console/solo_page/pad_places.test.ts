import { expect, it } from "vitest";
import type { PadState } from "../../link/messages";
import { NO_PLACES, type PadPlaces, placesAfter, withChosen } from "./pad_places";

const pad = (name: string, high = 1): PadState => ({
  name,
  part: "mouth",
  dimensions: 1,
  looks: [
    { label: "Rest", mix: { neutral: 1 }, place: [-1] },
    { label: "Pout", mix: { pout: 1 }, place: [high] },
  ],
  missing: [],
});
const pads = (...names: string[]): PadState[] => names.map((name) => pad(name));
const CHOSEN = ["mouth", "moods"];
const ALL = pads("moods", "mouth", "faces");
const BEGUN = placesAfter(NO_PLACES, ALL, CHOSEN);
const names = (places: PadPlaces): readonly string[] => places.names;

it("begins with the pads that were chosen, and fills what is empty as pads come", () => {
  expect(names(BEGUN)).toEqual(["mouth", "moods"]);
  const one = placesAfter(NO_PLACES, pads("faces"), CHOSEN);
  expect(names(one)).toEqual(["faces", ""]);
  expect(names(placesAfter(one, pads("faces", "mouth"), CHOSEN))).toEqual(["faces", "mouth"]);
});

it("keeps the place of a pad that is gone, until it comes back", () => {
  const gone = placesAfter(BEGUN, pads("moods", "faces"), CHOSEN);
  expect(names(gone)).toEqual(["mouth", "moods"]);
  expect(names(placesAfter(gone, pads("moods", "faces", "new"), CHOSEN))).toEqual(["mouth", "moods"]);
  expect(names(placesAfter(gone, ALL, CHOSEN))).toEqual(["mouth", "moods"]);
});

it("follows a pad that has another name and is as it was in all else, with the choice of it", () => {
  const renamed = placesAfter(BEGUN, pads("moods", "lips", "faces"), CHOSEN);
  expect(renamed).toMatchObject({ names: ["lips", "moods"], chosen: ["lips", "moods"] });
  expect(names(placesAfter(renamed, renamed.pads, renamed.chosen))).toEqual(["lips", "moods"]);
});

it.each([
  ["another pad in its place", [pad("moods"), pad("lips", 0.5), pad("faces")]],
  ["a new one behind the others", pads("moods", "faces", "lips")],
  ["names that are exchanged", pads("mouth", "moods", "faces")],
  ["one more at the same time", pads("moods", "lips", "faces", "new")],
])("takes %s for no other name", (_, after) => {
  expect(names(placesAfter(BEGUN, after, CHOSEN))).toEqual(["mouth", "moods"]);
});

it("has what a layout chooses", () => {
  expect(names(placesAfter(BEGUN, ALL, ["faces", "gone"]))).toEqual(["faces", "moods"]);
  expect(names(placesAfter(BEGUN, ALL, [...CHOSEN]))).toEqual(["mouth", "moods"]);
});

it("puts a pad in a place, or has two change places, also one that is gone", () => {
  const put = withChosen(BEGUN, 0, "faces");
  expect(put).toMatchObject({ names: ["faces", "moods"], chosen: ["faces", "moods", "mouth"] });
  expect(names(placesAfter(put, ALL, put.chosen))).toEqual(["faces", "moods"]);
  expect(names(withChosen(BEGUN, 1, "mouth"))).toEqual(["moods", "mouth"]);
  const gone = placesAfter(BEGUN, pads("moods", "faces"), CHOSEN);
  const after = withChosen(gone, 1, "faces");
  expect(names(placesAfter(after, [...gone.pads], after.chosen))).toEqual(["mouth", "faces"]);
});
