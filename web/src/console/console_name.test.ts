import { describe, expect, it } from "vitest";
import { ConsoleName, LONGEST_CONSOLE_NAME } from "./console_name";

/** What a browser, or a tab, keeps. */
function memory() {
  const kept = new Map<string, string>();
  return () => ({
    getItem: (key: string) => kept.get(key) ?? null,
    setItem: (key: string, value: string) => void kept.set(key, value),
  });
}
const forbidden = () => {
  throw new Error("forbidden");
};

describe("the name of a console", () => {
  it("stays in the browser, and is no longer than the wire has it", () => {
    const browser = memory();
    expect(new ConsoleName(browser, memory()).read()).toBe("");
    new ConsoleName(browser, memory()).write("  Ana  ");
    expect(new ConsoleName(browser, memory()).read()).toBe("Ana");
    new ConsoleName(browser, memory()).write("x".repeat(99));
    expect(new ConsoleName(browser, memory()).read()).toHaveLength(LONGEST_CONSOLE_NAME);
  });

  it("is asked for again where the show gave it", () => {
    const browser = memory();
    new ConsoleName(browser, memory()).receive("console 2");
    expect(new ConsoleName(browser, memory()).read()).toBe("console 2");
  });

  it("of a second tab is that tab's own, through its reloads, and leaves the first its", () => {
    const [browser, first, second] = [memory(), memory(), memory()];
    new ConsoleName(browser, first).receive("console 1");
    const other = new ConsoleName(browser, second);
    expect(other.read()).toBe("console 1");
    other.receive("console 2"); // the first is there
    const after = [first, second, memory()].map((tab) => new ConsoleName(browser, tab).read());
    expect(after).toEqual(["console 1", "console 2", "console 1"]);
  });

  it("lasts until the next load where the browser keeps nothing", () => {
    const name = new ConsoleName(forbidden, forbidden);
    name.write("Ana");
    expect(name.read()).toBe("Ana");
  });
});
