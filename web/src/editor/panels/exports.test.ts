import { afterEach, expect, it, vi } from "vitest";
import { LongRequests } from "../../ui/long_requests";
import { credit, download, exportsOf, LICENCES } from "./exports";

afterEach(() => vi.unstubAllGlobals());

it("an expression goes out as a document and on the face under work", () => {
  const exported = exportsOf({ kind: "expression", name: "crooked_smile", label: "Crooked smile" }, "dog");
  expect(exported.map(({ file }) => file)).toEqual(["crooked_smile.json", "dog-crooked_smile.glb"]);
  expect(exported[1]?.address).toBe("/exports/dog.glb?expressions=crooked_smile");
});

it("a file is called as the item is called now, also after it was renamed", () => {
  const files = (label: string) =>
    exportsOf({ kind: "expression", name: "grin", label }, "dog").map(({ file }) => file);
  expect(files("Wide smirk!")).toEqual(["wide_smirk.json", "dog-wide_smirk.glb"]);
  expect(files("\u6d99 \u00dc")).toEqual(["\u6d99_\u00fc.json", "dog-\u6d99_\u00fc.glb"]);
  expect(files("?!")[0]).toBe("grin.json");
});

it("a face goes out by its own name", () => {
  const exported = exportsOf({ kind: "face", name: "my_aunt", label: "My aunt" }, "dog");
  expect(exported.map(({ address }) => address)).toEqual([
    "/exports/my_aunt.glb?expressions=arkit",
    "/exports/my_aunt.glb?expressions=performed",
    "/exports/my_aunt.vrm?expressions=arkit",
    "/exports/my_aunt.usdz?expressions=arkit",
    "/exports/my_aunt.obj?expressions=neutral",
  ]);
  expect(exported.map(({ file }) => file.replace("my_aunt", ""))).toEqual([
    ".glb",
    "-performed.glb",
    ".vrm",
    ".usdz",
    ".zip",
  ]);
});

it("says which files the show's computer cannot make, and why", () => {
  const [item, why] = [{ kind: "face", name: "ann", label: "Ann" } as const, "USD needs usd-core"];
  const exported = exportsOf(item, "dog", { usdz: why });
  expect(exported.map(({ unwritable }) => unwritable)).toEqual([undefined, undefined, undefined, why, undefined]);
  expect(exportsOf(item, "dog").some((entry) => "unwritable" in entry)).toBe(false);
});

it("an avatar goes out with its author and its terms, and only then; nothing else asks for them", () => {
  const [plain, , avatar] = exportsOf({ kind: "face", name: "ann", label: "Ann" }, "dog");
  if (plain === undefined || avatar === undefined) throw new Error("it has both");
  const said = { author: " Ann & Bo ", licence: "strict" };
  expect(credit(avatar, said).address).toBe("/exports/ann.vrm?expressions=arkit&author=Ann%20%26%20Bo&licence=strict");
  expect(() => credit(avatar, { ...said, author: " , " })).toThrow("fill in its author");
  expect(credit(plain, { ...said, author: "" })).toBe(plain);
  expect(LICENCES[0]?.[0]).toBe("strict");
});

const one = { what: "", address: "/exports/smirk.json", file: "smirk.json" };

it("what the server refuses is its own sentence", async () => {
  vi.stubGlobal("fetch", () => Promise.resolve(new Response("there is no expression 'smirk'.", { status: 404 })));
  await expect(download(one, new LongRequests())).rejects.toThrow("There is no expression 'smirk'.");
});

it("a server that is away is a sentence", async () => {
  vi.stubGlobal("fetch", () => Promise.reject(new TypeError("Failed to fetch")));
  await expect(download(one, new LongRequests())).rejects.toThrow("does not answer; try again");
});
