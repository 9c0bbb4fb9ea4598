import { describe, expect, it } from "vitest";
import { addressOn, readBus } from "./bus";

describe("the bus of a page", () => {
  it("is air, unless its address says preview", () => {
    expect(["", "?bus=air", "?bus=", "?x=1", "?bus=blind"].map(readBus)).toEqual(Array(5).fill("air"));
    expect(readBus("?layout=a&bus=preview")).toBe("preview");
  });

  it("changes and all else of the address stays", () => {
    const here = { pathname: "/console", search: "?layout=a%20b", hash: "#1" };
    const there = addressOn("preview", here);
    expect(readBus(new URL(there, "http://x").search)).toBe("preview");
    const back = new URL(addressOn("air", new URL(there, "http://x")), "http://x");
    expect([back.pathname, new URLSearchParams(back.search).get("layout"), back.hash]).toEqual([
      "/console",
      "a b",
      "#1",
    ]);
    expect(addressOn("air", { pathname: "/cues", search: "?bus=preview", hash: "" })).toBe("/cues");
  });
});
