import { describe, expect, it } from "vitest";
import { FIRST_LIGHT } from "../../link/constants";
import { LIGHTS, type Light, lightTurned, mixLights } from "./lights";
import type { Triple } from "./tone";

const names = Object.keys(LIGHTS);
const directions = ({ key, fill, rims }: Light) => [key.direction, fill.direction, rims.left, rims.right];
const length = ([x, y, z]: Triple) => Math.hypot(x, y, z);

describe("a mix of lights", () => {
  it.each(names)("is %s itself where only that is on air", (name) => {
    const [mixed, own] = [mixLights({ [name]: 1 }), LIGHTS[name] as Light];
    expect(mixed.exposure).toBe(own.exposure);
    expect(mixed.key.colour).toEqual(own.key.colour);
    directions(mixed).forEach((from, at) => {
      expect(from).toEqual(directions(own)[at]?.map((part) => expect.closeTo(part, 12)));
    });
  });

  it("keeps directions of length one", () => {
    const mix = Object.fromEntries(names.map((name) => [name, 1 / names.length]));
    for (const from of directions(mixLights(mix))) expect(length(from)).toBeCloseTo(1, 12);
  });

  it("is the light a show begins with where no known light is on air", () => {
    expect(mixLights({})).toBe(LIGHTS[FIRST_LIGHT]);
    expect(mixLights({ candle: 1 })).toBe(LIGHTS[FIRST_LIGHT]);
  });

  it("does not change with names it does not know", () => {
    expect(mixLights({ [FIRST_LIGHT]: 0.5, candle: 0.5 })).toEqual(mixLights({ [FIRST_LIGHT]: 1 }));
  });
});

describe("a light as somebody sees it who is turned", () => {
  const theatre = LIGHTS.theatre as Light;

  it("is the light itself where nobody is turned", () => {
    expect(lightTurned(theatre, 0)).toBe(theatre);
  });

  it("comes from the other side after half a turn, from as high as before", () => {
    const [x, y, z] = theatre.key.direction;
    const { key, rims } = lightTurned(theatre, Math.PI);
    key.direction.forEach((part, axis) => {
      expect(part).toBeCloseTo([-x, y, -z][axis] as number, 12);
    });
    expect(Math.hypot(...rims.left)).toBeCloseTo(Math.hypot(...theatre.rims.left), 12);
  });

  it("meets a nose that is turned to the audience's right from its own right", () => {
    const ahead: Light = { ...theatre, key: { ...theatre.key, direction: [0, 0, 1] } };
    expect(lightTurned(ahead, Math.PI / 2).key.direction[0]).toBeCloseTo(-1, 12);
  });
});
