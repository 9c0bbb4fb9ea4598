import { describe, expect, it } from "vitest";
import { clipTime, endedWords, lightWords, ownPass, passWords, positionOf } from "./clip_passes";

describe("passes", () => {
  it("are where the clip was when they began, and go on from there", () => {
    expect(positionOf({ began: 100, start: 2.5, speed: 1 }, 101)).toBe(3.5);
    expect(positionOf({ began: 100, start: 2.5, speed: 0.5 }, 101)).toBe(3);
    expect(positionOf({ began: 100, start: 2.5, speed: 1 }, 99)).toBe(2.5); // a state from before
  });

  it("have times that never read sixty seconds", () => {
    expect([0, 59.97, 64.25, -0.5].map(clipTime)).toEqual(["0:00.0", "1:00.0", "1:04.3", "−0:00.5"]);
  });

  it("say who records what of whom", () => {
    const pass = {
      by: "Anna",
      parts: ["mouth" as const],
      name: "line",
      lane: "",
      character: "one",
      began: 0,
      start: 0,
      speed: 1,
    };
    expect(passWords(pass, "Kaori", 6)).toBe("Anna records mouth of Kaori in line");
    expect(passWords({ ...pass, speed: 0.5 }, "Kaori", 6)).toBe("Anna records mouth of Kaori in line at half speed");
    expect(lightWords({ ...pass, speed: 0.4 }, "Kaori", 6)).toBe("mouth of Kaori, line at 40 % of its speed · Anna");
    expect(lightWords(pass, "Kaori", 6)).toBe("mouth of Kaori, line · Anna");
    expect(endedWords(pass, true, 20)).toBe("Kept in line: mouth is a lane now; another hand ended it.");
    expect(endedWords(pass, true, 600)).toContain("it ended by itself after ten minutes");
  });

  it("are ended by the key of who records them, at any page of theirs that plays the character", () => {
    const pass = { by: "Anna", parts: [], name: "line", lane: "", character: "one", began: 0, start: 0, speed: 1 };
    expect(ownPass([pass], "Anna 2", ["one"])).toBe(pass);
    expect(ownPass([{ ...pass, by: "Anna 3" }], "Anna", ["two", "one"])?.by).toBe("Anna 3");
    expect(ownPass([pass], "Anna", ["two"])).toBeUndefined();
    expect(ownPass([pass], "Bo", ["one"])).toBeUndefined();
    expect(ownPass([{ ...pass, by: "" }], "Anna", ["one"])).toBeUndefined();
  });
});
