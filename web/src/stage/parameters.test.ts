import { describe, expect, it } from "vitest";
import { tileView } from "../face/framing";
import { encodeSrgb } from "../face/light/tone";
import { ParameterError, readParameters } from "./parameters";

describe("a stage's address", () => {
  it("needs no parameter", () => {
    expect(readParameters("")).toEqual({
      background: undefined,
      sound: "may",
      light: undefined,
      transparent: false,
      hair: true,
      hud: false,
      quality: "auto",
      tile: undefined,
      bus: "air",
      character: undefined,
      name: "",
    });
  });

  it("has a name that can be read, or none", () => {
    expect(readParameters("?name=left").name).toBe("left");
    expect(() => readParameters("?name=")).toThrow("no name of a stage");
    expect(() => readParameters(`?name=${"x".repeat(25)}`)).toThrow("no name of a stage");
  });

  it("switches with or without =1", () => {
    expect(readParameters("?transparent&hud=1&quality=low")).toMatchObject({
      transparent: true,
      hud: true,
      quality: "low",
    });
    expect(readParameters("?transparent=0").transparent).toBe(false);
    expect(["?hair=0", "?hair=1", "?hair"].map((query) => readParameters(query).hair)).toEqual([false, true, true]);
  });

  it.each(["#00b140", "00b140", "%2300B140", "green", "Green"])("puts %s behind the head", (colour) => {
    const [red, green, blue] = readParameters(`?background=${colour}`).background ?? [];
    expect(red).toBe(0);
    expect(encodeSrgb([0, green ?? 0, 0])[1] * 255).toBeCloseTo(0xb1, 6);
    expect(encodeSrgb([0, 0, blue ?? 0])[2] * 255).toBeCloseTo(0x40, 6);
  });

  it("reads on behind the colour's #", () => {
    expect(readParameters("?background=#000000&light=flat&hud")).toMatchObject({ light: "flat", hud: true });
  });

  it("places a tile", () => {
    expect(readParameters("?tile=2,1&of=3x3&bezel=4,5").tile).toEqual({
      column: 2,
      row: 1,
      columns: 3,
      rows: 3,
      bezel: [0.04, 0.05],
    });
  });

  it("shows one character of the scene", () => {
    expect(readParameters("?character=kaori_2").character).toBe("kaori_2");
    expect(readParameters("?character=The%20Dog").character).toBe("The Dog");
  });

  it.each([
    ["?character=", "names no character"],
    [`?character=${"x".repeat(81)}`, "names no character"],
    ["?colour=red", "colour"],
    ["?hud=maybe", "hud=maybe"],
    ["?background=gren", "background=gren is no colour; write green, blue"],
    ["?background=constructor", "is no colour"],
    ["?background=#00b14", "background=#00b14"],
    ["?background=#000000&transparent", "exclude"],
    ["?light=candle", "light=candle"],
    ["?shot=wide", "shot=wide"],
    ["?quality=best", "quality=best"],
    ["?tile=1&of=3x3", "tile=1"],
    ["?tile=-1,0&of=3x3", "tile=-1,0"],
    ["?tile=3,0&of=3x3", "tile=3,0"],
    ["?tile=0,0", "of="],
    ["?of=3x3", "tile="],
    ["?tile=0,0&of=0x3", "of=0x3"],
    ["?tile=0,0&of=3x3&bezel=wide", "bezel=wide"],
    ["?tile=0,0&of=3x3&bezel=99", "bezel=99"],
    ["?tile=0,0&of=3x3&bezel=1,2,3", "bezel=1,2,3"],
    ["?bezel=2", "tile="],
    ["?bus=blind", "bus=blind"],
    ["?bus=preview&tile=0,0&of=2x2", "a wall shows what is on air"],
  ])("refuses %s with a sentence that names it", (query, named) => {
    expect(() => readParameters(query)).toThrow(ParameterError);
    expect(() => readParameters(query)).toThrow(named);
  });
});

describe("tiles", () => {
  it("cover the wall side by side", () => {
    const views = [0, 1, 2].map((column) => tileView({ column, row: 0, columns: 3, rows: 3, bezel: [0, 0] }, 400, 300));
    expect(views.map(([, , left]) => left)).toEqual([0, 400, 800]);
    expect(views[0]?.slice(0, 2)).toEqual([1200, 900]);
  });

  it("leave out what the bezels hide", () => {
    const [width, height, left, top] = tileView({ column: 2, row: 1, columns: 3, rows: 2, bezel: [0.1, 0.2] }, 100, 50);
    expect([width, height, left, top]).toEqual([320, 110, 220, 60].map((value) => expect.closeTo(value, 9)));
  });
});
