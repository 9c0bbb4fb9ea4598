import { expect, test, vi } from "vitest";
import type { SourceState, State } from "../../link/messages";
import { countUnrouted, UnroutedSources, unrouted } from "./unrouted_sources";

const source = (name: string, characters: string[], kind = "tracker"): SourceState =>
  ({ name, characters, kind }) as never;
const characters = { one: { label: "One" }, rex: { label: "Rex" } } as unknown as State["characters"];

test("a tracker that plays nobody is said, with each character that it may play", () => {
  const route = vi.fn();
  const question = new UnroutedSources(route, vi.fn()).question([source("phone", [])], characters);
  expect(question?.text).toBe("phone sends and plays nobody.");
  expect(question?.offers.map(({ label }) => label)).toEqual(["Play One", "Play Rex"]);
  const [, second] = question?.offers ?? [];
  if (second && "act" in second) second.act();
  expect(route).toHaveBeenCalledWith(source("phone", []), "rex");
});

test("a tracker is asked about by its name, without its address unless another has the same", () => {
  const asked = (...names: string[]) =>
    new UnroutedSources(vi.fn(), vi.fn()).question(
      names.map((name) => source(name, [])),
      characters,
    )?.text;
  expect(asked("VMC 10.0.0.7")).toBe("VMC sends and plays nobody.");
  expect(asked("VMC 10.0.0.7", "VMC 10.0.0.8")).toBe("VMC 10.0.0.7 sends and plays nobody.");
});

test("who plays nobody is counted, without programs, also where the question was put away", () => {
  const sources = [
    source("phone", []),
    source("lips", [], "lips"),
    source("Mira", ["one"]),
    source("bot", [], "program"),
  ];
  expect(unrouted(sources).map(({ name }) => name)).toEqual(["phone", "lips"]);
  expect([1, 2].map(countUnrouted)).toEqual(["1 source plays nobody", "2 sources play nobody"]);
});

test("who plays somebody, and a program, is not said", () => {
  const sources = new UnroutedSources(vi.fn(), vi.fn());
  expect(sources.question([source("phone", ["one"]), source("bot", [], "program")], characters)).toBeNull();
});

test("what was put away is not said again until it has played somebody", () => {
  const dismissed = vi.fn();
  const sources = new UnroutedSources(vi.fn(), dismissed);
  sources.question([source("phone", [])], characters)?.dismiss();
  expect(dismissed).toHaveBeenCalled();
  expect(sources.question([source("phone", [])], characters)).toBeNull();
  expect(sources.question([source("phone", ["one"])], characters)).toBeNull();
  expect(sources.question([source("phone", [])], characters)).not.toBeNull();
});
