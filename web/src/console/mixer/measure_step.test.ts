import { expect, test } from "vitest";
import { MeasureSteps } from "./measure_step";

const measured = (rest: number) => ({ name: "phone", neutral: { jawOpen: rest }, highest: {} });

test("a measure is a step once the show has told it, and only once", () => {
  const steps = new MeasureSteps();
  steps.ask(measured(0));
  expect(steps.receive([measured(0)])).toEqual([]);
  const [step] = steps.receive([measured(0.2)]);
  expect(step?.undo).toEqual([{ type: "measure_source", source: "phone", neutral: { jawOpen: 0 }, highest: {} }]);
  expect(step?.redo).toEqual([{ type: "measure_source", source: "phone", neutral: { jawOpen: 0.2 }, highest: {} }]);
  expect(steps.receive([measured(0.3)])).toEqual([]);
});

test("a measure of another console is no step of this one", () => {
  expect(new MeasureSteps().receive([measured(0.2)])).toEqual([]);
});
