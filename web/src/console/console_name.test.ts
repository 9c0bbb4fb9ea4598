import { expect, it } from "vitest";
import { ConsoleName, LONGEST_CONSOLE_NAME } from "./console_name";

it("stays in the browser, and is no longer than the wire has it", () => {
  const kept = new Map<string, string>();
  const own = () => ({
    getItem: (key: string) => kept.get(key) ?? null,
    setItem: (key: string, value: string) => void kept.set(key, value),
  });
  expect(new ConsoleName(own).read()).toBe("");
  new ConsoleName(own).write("  Ana  ");
  expect(new ConsoleName(own).read()).toBe("Ana");
  new ConsoleName(own).write("x".repeat(99));
  expect(new ConsoleName(own).read()).toHaveLength(LONGEST_CONSOLE_NAME);
});

it("lasts until the next load where the browser keeps nothing", () => {
  const name = new ConsoleName(() => {
    throw new Error("forbidden");
  });
  name.write("Ana");
  expect(name.read()).toBe("Ana");
});
