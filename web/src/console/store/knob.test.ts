import { expect, it } from "vitest";
import type { CharacterState, FromClient } from "../../link/messages";
import { Knobs } from "./knob";
import { Outbox } from "./outbox";

/** The knobs of a character with this on air, what they send, and whom they ask. */
function knobsOf(air: CharacterState) {
  const [sent, asked]: [FromClient[], string[]] = [[], []];
  const outbox = new Outbox((message) => sent.push(message));
  const mayAct = (control: string): boolean => asked.push(control) > 0;
  const host = { air: () => air, targets: () => ["one"], withMacro: () => [], now: () => 0, mayAct };
  return { knobs: new Knobs(host, outbox), outbox, sent, asked };
}

it("is how much of a spring shows, which is all of it until that is set", () => {
  const air = { springs: { "ears-flap": 0.2 } } as unknown as CharacterState;
  const { knobs, outbox, sent, asked } = knobsOf(air);
  expect(knobs.spring("ears-flap").value(0)).toBe(0.2);
  expect(knobs.spring("ears-sway").value(0)).toBe(1);
  knobs.spring("ears-sway").nudge(0.4);
  outbox.flush();
  expect(sent).toEqual([{ type: "set_spring", character: "one", name: "ears-sway", amount: 0.4 }]);
  expect(asked).toEqual(["set_spring:ears-sway"]);
});

it("is how much of the skin's folds and blood shows, which is all of it until that is set", () => {
  const { knobs, outbox, sent, asked } = knobsOf({ skin: { blood: 0.2 } } as unknown as CharacterState);
  expect(knobs.skin("blood").value(0)).toBe(0.2);
  expect(knobs.skin("folds").value(0)).toBe(1);
  knobs.skin("folds").nudge(0.4);
  outbox.flush();
  expect(sent).toEqual([{ type: "set_skin", character: "one", name: "folds", amount: 0.4 }]);
  expect(asked).toEqual(["set_skin:folds"]);
});
