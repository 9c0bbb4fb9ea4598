import { describe, expect, it } from "vitest";
import { commandOf, HELP, TOOLS, VIEWS } from "./keys";

const press = (key: string, more: Partial<Parameters<typeof commandOf>[0]> = {}): Parameters<typeof commandOf>[0] => ({
  key,
  code: /^[a-z]$/i.test(key) ? `Key${key.toUpperCase()}` : "",
  ctrlKey: false,
  altKey: false,
  metaKey: false,
  shiftKey: false,
  repeat: false,
  ...more,
});

describe("a key", () => {
  it("saves while typing, and undoes only outside fields, which have an undo of their own", () => {
    expect(commandOf(press("s", { ctrlKey: true }), true)).toEqual({ do: "save" });
    expect(commandOf(press("z", { metaKey: true }), false)).toEqual({ do: "undo" });
    expect(commandOf(press("Z", { ctrlKey: true, shiftKey: true }), false)).toEqual({ do: "redo" });
    expect(commandOf(press("z", { ctrlKey: true }), true)).toBeNull();
  });

  it("undoes step after step while it is held", () => {
    expect(commandOf(press("z", { ctrlKey: true, repeat: true }), false)).toEqual({ do: "undo" });
  });

  it("is only a letter in a field", () => {
    for (const key of ["d", "?", "/", "Escape"]) expect(commandOf(press(key), true)).toBeNull();
  });

  it("takes up each tool and turns to each view", () => {
    for (const [tool, , key] of TOOLS) expect(commandOf(press(key), false)).toEqual({ do: "tool", tool });
    for (const [view, , key] of VIEWS)
      expect(commandOf(press(key, { code: `Digit${key}` }), false)).toEqual({ do: "view", view });
  });

  it("of a tool is in the help", () => {
    const help = HELP.map(([keys]) => keys).join(" ");
    for (const [, , key] of TOOLS) expect(help).toContain(key);
  });
});
