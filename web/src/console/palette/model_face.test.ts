import { describe, expect, it } from "vitest";
import { ModelFace } from "./model_face";

describe("the face that expressions are drawn on", () => {
  it("is the one on air once it stands there alone for a while", () => {
    const model = new ModelFace("generic");
    expect(model.follow({ dog: 1 }, false, 0)).toBe("generic");
    expect(model.follow({ dog: 1 }, false, 700)).toBe("generic");
    expect(model.follow({ dog: 1 }, false, 900)).toBe("dog");
  });

  it("stays while faces mix or are called, however long", () => {
    const model = new ModelFace("generic");
    for (let now = 0; now < 5000; now += 100) {
      expect(model.follow({ dog: 0.5, cat: 0.5 }, false, now)).toBe("generic");
      expect(model.follow({ dog: 1 }, true, now + 50)).toBe("generic");
    }
  });
});
