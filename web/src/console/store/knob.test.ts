import { expect, it } from "vitest";
import type { CharacterState, FromClient } from "../../link/messages";
import { Knobs } from "./knob";
import { Outbox } from "./outbox";

it("is how much of a spring shows, which is all of it until that is set", () => {
  const sent: FromClient[] = [];
  const outbox = new Outbox((message) => sent.push(message));
  const asked: string[] = [];
  const air = { springs: { "ears-flap": 0.2 } } as unknown as CharacterState;
  const mayAct = (control: string): boolean => asked.push(control) > 0;
  const knobs = new Knobs(
    { air: () => air, targets: () => ["one"], withMacro: () => [], now: () => 0, mayAct },
    outbox,
  );
  expect(knobs.spring("ears-flap").value(0)).toBe(0.2);
  expect(knobs.spring("ears-sway").value(0)).toBe(1);
  knobs.spring("ears-sway").nudge(0.4);
  outbox.flush();
  expect(sent).toEqual([{ type: "set_spring", character: "one", name: "ears-sway", amount: 0.4 }]);
  expect(asked).toEqual(["set_spring:ears-sway"]);
});
