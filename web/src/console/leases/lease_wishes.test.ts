import { describe, expect, it } from "vitest";
import type { Leases, SeatState } from "../../link/messages";
import { NOBODY } from "./held_parts";
import { askedHere, waited, wantedHere, wanting } from "./lease_wishes";

const seat = (number: number, name: string): SeatState => ({
  number,
  name,
  colour: "#70ccee",
  manager: false,
  here: true,
});
const [ANA, BEN, ME] = [seat(1, "Ana"), seat(2, "Ben"), seat(3, "Me")];
const leases = (held: Leases["held"], wishes: Leases["wishes"]): Leases => ({
  ...NOBODY,
  on: true,
  held,
  wishes,
  seats: [ANA, BEN, ME],
  you: 3,
});

describe("wishes for parts", () => {
  it("of others for what is held here come with whoever waits longest first", () => {
    const report = leases({ "one/face": ME, "one/expression": ME, "*/light": ANA }, [
      { part: "one/face", by: 1, seconds: 3 },
      { part: "one/mouth", by: 2, seconds: 70 },
      { part: "*/light", by: 2, seconds: 90 },
    ]);
    expect(askedHere(report).map(({ by, parts, seconds }) => [by.name, parts, seconds])).toEqual([
      ["Ben", ["one/mouth"], 70],
      ["Ana", ["one/face"], 3],
    ]);
    expect(wantedHere(report)).toBeNull();
    expect(wanting(report, "*/light").map(({ by }) => by.name)).toEqual(["Ben"]);
  });

  it("of this seat are its own, however many", () => {
    const report = leases({ "one/face": ANA, "one/head": BEN }, [
      { part: "one/face", by: 3, seconds: 3 },
      { part: "one/head", by: 3, seconds: 5 },
    ]);
    expect(askedHere(report)).toEqual([]);
    expect(wantedHere(report)).toEqual({ by: ME, parts: ["one/face", "one/head"], seconds: 5 });
  });

  it("are told in words", () => {
    expect([waited(0), waited(119), waited(121)]).toEqual(["0 s", "119 s", "2 min"]);
  });
});
