import { afterEach, describe, expect, it, vi } from "vitest";
import { importFile, importFiles, readableOf, sayTakenIn, type TakenIn } from "./file_import";

afterEach(() => vi.unstubAllGlobals());

const GRIN: TakenIn = { kind: "expression", name: "grin", label: "Grin", known: false };
const file = (name: string) => new File(["words"], name);
const answering = (answer: (address: string) => Response) =>
  vi.stubGlobal("fetch", (address: string) => Promise.resolve(answer(address)));

describe("a file", () => {
  it("goes to the show under its name, as what it is", async () => {
    const asked: string[] = [];
    answering((address) => {
      asked.push(address);
      return Response.json({ items: [GRIN], said: ["Grin, from my grin.json"] });
    });
    expect((await importFile(file("my grin.json"), "expression")).items).toEqual([GRIN]);
    await importFile(file("aunt.glb"), "face");
    const addresses = asked.map((address) => address.replace(/&request=[\w-]+$/, ""));
    expect(addresses).toEqual(["/imports/my%20grin.json?as=expression", "/imports/aunt.glb?as=face"]);
  });

  it("that the show cannot take in is told in its words, and the others come in", async () => {
    answering((address) =>
      address.includes("notes")
        ? new Response("it is no expression.", { status: 400 })
        : Response.json({ items: [GRIN, { ...GRIN, known: true }], said: ["Grin, from grin.json", "Grin"] }),
    );
    expect(await importFiles([file("notes.txt"), file("grin.json")], "expression")).toEqual({
      done: "Taken in, under Own: Grin, from grin.json; Grin is there already.",
      failed: ["notes.txt was not taken in: it is no expression."],
    });
  });

  it("ends its sentence, for another may follow", async () => {
    answering(() => new Response("export the scan as .ply", { status: 400 }));
    await expect(importFile(file("a.ply"), "face")).rejects.toThrow("a.ply was not taken in: export the scan as .ply.");
  });

  it("is parted from folders, which a page cannot read, before anything is sent", async () => {
    const folder = new File([], "scans");
    vi.spyOn(folder, "slice").mockReturnValue({
      arrayBuffer: () => Promise.reject(new DOMException("it is a folder", "NotReadableError")),
    } as Blob);
    const [empty, full] = [new File([], "empty.ply"), file("grin.json")];
    expect(await readableOf([empty, full])).toEqual([[empty, full], ""]);
    const [files, refused] = await readableOf([folder, full]);
    expect(files).toEqual([full]);
    expect(refused).toContain("scans cannot be read: a folder");
    expect(await readableOf([])).toEqual([[], "Nothing that a page can read was dropped: drop files."]);
  });

  it("that brings what is called as something else is told under its new name", () => {
    const items = [{ ...GRIN, label: "Grin 2" }];
    expect(sayTakenIn({ items, said: ["Grin, from grin.json"] })).toBe("Grin, from grin.json, named Grin 2");
  });

  it("that brings many is summed up", () => {
    const items = Array.from({ length: 52 }, (_, index) => ({ ...GRIN, label: `E${index}` }));
    const imported = { items, said: items.map(({ label }) => `${label}, taken from kaori`) };
    const three = "E0, taken from kaori; E1, taken from kaori; E2, taken from kaori";
    expect(sayTakenIn(imported)).toBe(`${three}; 49 more`);
    const existing = items.map((item) => ({ ...item, known: true }));
    expect(sayTakenIn({ ...imported, items: existing })).toBe("all 52 are there already, E0 and others");
    const some = [...items.slice(0, 2), ...existing.slice(2)];
    expect(sayTakenIn({ ...imported, items: some })).toBe(
      "E0, taken from kaori; E1, taken from kaori; 50 are there already",
    );
  });

  it("that is cancelled is the last", async () => {
    answering((address) =>
      address.includes("grin")
        ? Response.json({ items: [GRIN], said: ["Grin, from grin.json"] })
        : new Response(null, { status: 204 }),
    );
    const files = [file("grin.json"), file("head.glb"), file("a.json"), file("b.json")];
    expect(await importFiles(files, "expression")).toEqual({
      done: "Taken in, under Own: Grin, from grin.json. Import of head.glb: cancelled; nothing has changed. 2 more files were not sent.",
      failed: [],
    });
  });

  it("that cannot be sent is a sentence", async () => {
    vi.stubGlobal("fetch", () => Promise.reject(new TypeError("Failed to fetch")));
    await expect(importFile(file("grin.json"), "expression")).rejects.toThrow("grin.json was not sent");
  });
});
