import { describe, expect, it } from "vitest";
import { randomId } from "../../ui/browser_storage";
import { seatToken } from "./seat_token";

describe("the seat of a tab", () => {
  it("outlives a reload and is another in another tab", () => {
    let madeCount = 0;
    const make = () => `token ${++madeCount}`;
    const tab = () => {
      const kept = new Map<string, string>();
      return { getItem: (key: string) => kept.get(key) ?? null, setItem: kept.set.bind(kept) as never };
    };
    const [one, other] = [tab(), tab()];
    expect([seatToken(() => one, make), seatToken(() => one, make), seatToken(() => other, make)]).toEqual([
      "token 1",
      "token 1",
      "token 2",
    ]);
  });

  it("is another each time that one is made", () => {
    expect(new Set(Array.from({ length: 100 }, randomId)).size).toBe(100);
  });

  it("lasts as long as the page where the browser keeps nothing", () => {
    const forbidden = () => {
      throw new Error("forbidden");
    };
    expect(seatToken(forbidden, () => "mine")).toBe("mine");
  });
});
