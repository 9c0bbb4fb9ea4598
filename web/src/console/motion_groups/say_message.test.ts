import { describe, expect, it } from "vitest";
import { sayMessage, speechWords } from "./say_message";

const SPEECH = { number: 1, text: "Hello", elapsed: 0.52, seconds: 2, sound: "", waiting: 0, next_sound: "", keys: [] };

describe("what is said", () => {
  it("is told with its time, its sound and what waits", () => {
    expect(speechWords(null)).toBe("Says nothing");
    expect(speechWords(SPEECH)).toBe("Hello: 0.5 of 2.0 s");
    expect(speechWords({ ...SPEECH, text: "", elapsed: -0.3, sound: "a", waiting: 2 })).toBe(
      "Speaks: 0.0 of 2.0 s, with sound, 2 waiting",
    );
  });

  it("is a message of text alone, in the language whose letters are read", () => {
    expect(sayMessage("one", "Hallo", "de")).toMatchObject({
      ...{ type: "say", character: "one", text: "Hallo", timing: "text", language: "de", sound: "" },
    });
  });
});
