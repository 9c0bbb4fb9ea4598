import { describe, expect, it } from "vitest";
import { ModelFace } from "./model_face";

describe("the face that expressions are drawn on", () => {
  it("is the one that is called, before it is there", () => {
    const model = new ModelFace("generic");
    expect(model.follow({ generic: 0.9, dog: 0.1 }, "dog", 0)).toBe("generic");
    expect(model.follow({ generic: 0.6, dog: 0.4 }, "dog", 300)).toBe("dog");
  });

  it("is the one that stands alone on air where none is called", () => {
    const model = new ModelFace("generic");
    expect(model.follow({ dog: 1 }, null, 0)).toBe("generic");
    expect(model.follow({ dog: 1 }, null, 300)).toBe("dog");
  });

  it("stays while faces mix, and while one call follows another", () => {
    const model = new ModelFace("generic");
    for (let now = 0; now < 5000; now += 200) {
      expect(model.follow({ dog: 0.5, cat: 0.5 }, null, now)).toBe("generic");
      expect(model.follow({ dog: 0.5, cat: 0.5 }, now % 400 === 0 ? "dog" : "cat", now + 100)).toBe("generic");
    }
  });
});
