import { expect, it } from "vitest";
import type { ItemDocument } from "../../link/editing_messages";
import { labelOf } from "./sources";

it("names what is mixed in, what was deleted since too, and what nobody has", () => {
  const sources = [{ source: "dog", label: "Dog", group: "Faces" }];
  const items = [{ label: "Lee", content: "#a", deleted: true }] as ItemDocument[];
  expect(["dog", "#a", "#b", "cat"].map((source) => labelOf(sources, source, items))).toEqual([
    "Dog",
    "Lee (deleted)",
    "What came in",
    "cat",
  ]);
  expect(labelOf(sources, "#a")).toBe("What came in");
});
