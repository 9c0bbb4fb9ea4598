import { describe, expect, it } from "vitest";
import { askedItem, editorAddress } from "./editor_address";

const read = (address: string) => askedItem(new URL(address, "http://show"));

describe("the address of an item in the editor", () => {
  it("comes back as it was written, whatever the name", () => {
    for (const kind of ["face", "expression"] as const)
      for (const name of ["on_air_1", "a&b=c", "\u9762#?"])
        expect(read(editorAddress(kind, name))).toEqual({ kind, name });
  });

  it("may name no kind, or an item after #, or nothing", () => {
    expect(read("/editor?name=hobbart")).toEqual({ kind: null, name: "hobbart" });
    expect(read("/editor?kind=light&name=hobbart")).toEqual({ kind: null, name: "hobbart" });
    expect(read("/editor#hobbart")).toEqual({ kind: null, name: "hobbart" });
    expect([read("/editor"), read("/editor#"), read("/editor?kind=face")]).toEqual([null, null, null]);
  });
});
