import { afterEach, describe, expect, it, vi } from "vitest";
import { importFile, importFiles } from "./file_import";

afterEach(() => vi.unstubAllGlobals());

const file = (name: string) => new File(["words"], name);
const answering = (answer: (address: string) => Response) =>
  vi.stubGlobal("fetch", (address: string) => Promise.resolve(answer(address)));

describe("a file", () => {
  it("goes to the show under its name, as what it is", async () => {
    const asked: string[] = [];
    answering((address) => {
      asked.push(address);
      return Response.json({ labels: ["Grin"], said: ["Grin, from my grin.json"] });
    });
    expect((await importFile(file("my grin.json"), "expression")).labels).toEqual(["Grin"]);
    await importFile(file("aunt.glb"), "face");
    const addresses = asked.map((address) => address.replace(/&request=[\w-]+$/, ""));
    expect(addresses).toEqual(["/imports/my%20grin.json?as=expression", "/imports/aunt.glb?as=face"]);
  });

  it("that the show cannot take in is told in its words, and the others come in", async () => {
    answering((address) =>
      address.includes("notes")
        ? new Response("it is no expression.", { status: 400 })
        : Response.json({ labels: ["Grin"], said: ["Grin, from grin.json"] }),
    );
    expect(await importFiles([file("notes.txt"), file("grin.json")], "expression")).toEqual({
      done: "Taken in, under Own: Grin, from grin.json.",
      failed: ["notes.txt was not taken in: it is no expression."],
    });
  });

  it("that is cancelled is the last", async () => {
    answering((address) =>
      address.includes("grin")
        ? Response.json({ labels: ["Grin"], said: ["Grin, from grin.json"] })
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
