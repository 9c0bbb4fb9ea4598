import { expect, it } from "vitest";
import type { PadState } from "../../link/messages";
import { parseGoal } from "./goal_text";
import { goalOfPoint, pointsOffered } from "./pad_goal";

const look = (label: string, ...place: number[]) => ({ label, mix: { [label]: 1 }, place });
const PADS: PadState[] = [
  {
    name: "moods",
    part: "expression",
    dimensions: 2,
    looks: [look("Rest", 0, 0), look("Joy", 0.6, -0.25)],
    missing: [],
  },
  { name: "mouth", part: "mouth", dimensions: 1, looks: [look("Rest", -1), look("Pout", 1)], missing: [] },
];

it("offers a part the pads that play it, at their looks, as a goal is written", () => {
  const offered = pointsOffered("expression", PADS);
  expect(offered).toEqual(['pad = "moods", x = 0, y = 0', 'pad = "moods", x = 0.6, y = -0.25']);
  expect(parseGoal("one/expression", offered[1] as string)).toEqual(goalOfPoint({ pad: "moods", place: [0.6, -0.25] }));
  expect(pointsOffered("mouth", PADS)).toHaveLength(2);
  expect(pointsOffered("light", PADS)).toEqual([]);
});
