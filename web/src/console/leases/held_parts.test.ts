import { describe, expect, it } from "vitest";
import type { Leases, SeatState } from "../../link/messages";
import { explain, heldByOthers, heldHere, keysOf, listed, NOBODY, partOf } from "./held_parts";

const seat = (number: number, name: string): SeatState => ({
  number,
  name,
  colour: "#70ccee",
  manager: false,
  here: true,
});
const [ANA, BEN, ME] = [seat(1, "Ana"), seat(2, "Ben"), seat(3, "Me")];
const held = (parts: Leases["held"]): Leases => ({ ...NOBODY, on: true, held: parts, seats: [ANA, BEN, ME], you: 3 });

describe("held parts", () => {
  it("are in the way of who does not hold them, while leases are on", () => {
    const leases = held({ "one/face": ANA, "two/face": ME, "*/light": BEN });
    expect([...heldByOthers(leases, keysOf(["one", "two"], "face")).keys()]).toEqual(["one/face"]);
    expect([...heldByOthers(leases, keysOf(["one"], "light")).values()]).toEqual([BEN]);
    expect(heldByOthers(leases, keysOf(["one"], "head")).size).toBe(0);
    expect(heldByOthers({ ...leases, on: false }, ["one/face"]).size).toBe(0);
    expect(heldHere(leases, keysOf(["one", "two"], "face"))).toEqual(["two/face"]);
  });

  it("of an expression are its regions too, and one that was taken out of it is another's", () => {
    expect([...heldByOthers(held({ "one/expression": ANA }), ["one/mouth"])]).toEqual([["one/mouth", ANA]]);
    const carved = held({ "one/expression": ANA, "one/mouth": ME });
    expect(heldByOthers(carved, ["one/mouth"]).size).toBe(0);
    expect([...heldByOthers(carved, ["one/expression"]).keys()]).toEqual(["one/expression", "one/brows", "one/eyes"]);
    expect([...heldByOthers(held({ "one/expression": ME, "one/mouth": BEN }), ["one/expression"])]).toEqual([
      ["one/mouth", BEN],
    ]);
  });

  it("are what controls play", () => {
    expect(["fade_face", "set_channel:jawOpen", "set_head", "place"].map((control) => partOf(control))).toEqual([
      "face",
      "channels",
      "head",
      null,
    ]);
    const pads = (
      [
        ["lips", "mouth"],
        ["cheeks", "rest"],
      ] as const
    ).map(([name, part]) => ({ name, part, dimensions: 2, looks: [], missing: [] }));
    expect(["move_pad:lips", "move_pad:cheeks", "move_pad:gone"].map((control) => partOf(control, pads))).toEqual([
      "mouth",
      "expression",
      null,
    ]);
  });

  it("are told in words with their holders", () => {
    const label = (name: string) => name.toUpperCase();
    const holders = new Map([
      ["one/face", ANA],
      ["one/head", ANA],
      ["*/light", BEN],
    ]);
    expect(explain(holders, label)).toBe("Ana holds the face of ONE and the head of ONE, Ben the light");
    expect([listed([]), listed(["a"]), listed(["a", "b", "c"])]).toEqual(["", "a", "a, b and c"]);
  });
});
