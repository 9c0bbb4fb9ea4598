import { encode } from "@msgpack/msgpack";
import { describe, expect, it, vi } from "vitest";
import { fetchWithRetry, Library, RefusedAddress, readCompound, readLine, readMesh } from "./assets";
import type { Manifest } from "./messages";

const bytes = (array: Uint32Array | Float32Array | Int16Array): Uint8Array => new Uint8Array(array.buffer);
const mesh = {
  name: "skin",
  source: bytes(Uint32Array.from([0, 1, 2])),
  uv: bytes(new Float32Array(6)),
  triangles: bytes(Uint32Array.from([0, 1, 2])),
  openness: new Uint8Array(3),
};
const manifest = {
  lines: [],
  version: 1,
  base: "d",
  digest: "d2",
  vertices: 3,
  skin: 3,
  meshes: [mesh],
  mask: "/assets/mask",
  faces: [{ name: "kaori", source: "kaori", url: "/assets/kaori" }],
  expressions: [{ name: "a smile", source: "a smile" }],
} as unknown as Manifest;
const compound = (rows: number[]): Uint8Array =>
  encode({
    scale: 1e-5,
    indices: bytes(Uint32Array.from(rows)),
    deltas: bytes(Int16Array.from(rows.flatMap(() => [1, 2, 3]))),
  });

describe("a library", () => {
  it("fetches each thing once, at its address", async () => {
    const asked: string[] = [];
    const library = new Library(manifest, async (address) => {
      asked.push(address);
      return address.startsWith("/compounds")
        ? compound([2])
        : encode({ positions: bytes(new Float32Array(9).fill(2)) });
    });
    expect(await library.positions("kaori")).toEqual(new Float32Array(9).fill(2));
    await library.positions("kaori");
    expect((await library.compound("kaori", "a smile")).indices).toEqual(Uint32Array.from([2]));
    await library.compound("kaori", "a smile");
    expect(asked).toEqual(["/assets/kaori", "/compounds/d/kaori/a%20smile"]);
  });

  it("shaves every face where heads are bald", () => {
    const look = { skin: "#d9a98c", hair_style: "bob", scalp: 0.7 };
    const haired = { ...manifest, faces: [{ name: "kaori", source: "kaori", look }] } as unknown as Manifest;
    const looks = [true, false].map((kept) => new Library(haired, undefined, kept).faces.get("kaori")?.look);
    expect(looks).toEqual([look, { ...look, hair_style: "", scalp: 0 }]);
  });

  it("fetches the picture on a face's skin by its digest, and its bytes stay as they are", async () => {
    const asked: string[] = [];
    const decoded = vi.fn(async () => "picture");
    vi.stubGlobal("createImageBitmap", decoded);
    const own = { name: "own", source: "#a/b", url: "", albedo: "digest" };
    const pictured = { ...manifest, faces: [...manifest.faces, own] } as unknown as Manifest;
    const library = new Library(pictured, async (address) => {
      asked.push(address);
      return new Uint8Array(4);
    });
    expect(await library.albedo("#a/b")).toBe("picture");
    expect(asked).toEqual(["/albedos/digest/%23a%2Fb"]);
    expect(decoded).toHaveBeenCalledWith(expect.any(Blob), { premultiplyAlpha: "none", colorSpaceConversion: "none" });
    await expect(library.albedo("kaori")).rejects.toThrow('no picture on the skin of "kaori"');
    vi.unstubAllGlobals();
  });

  it("refuses names and sizes that do not fit", async () => {
    const library = new Library(manifest, async () => encode({ positions: bytes(new Float32Array(6)) }));
    await expect(library.positions("nobody")).rejects.toThrow("nobody");
    await expect(library.positions("kaori")).rejects.toThrow("expected 3");
    await expect(library.compound("kaori", "frown")).rejects.toThrow("frown");
  });

  it("takes in names that come, change or go, and keeps what it has fetched", async () => {
    const own = (digest: string, content: string) => ({
      ...manifest,
      digest,
      faces: [...manifest.faces, { name: "kin", source: `#${content}`, url: `/contents/${content}` }],
      expressions: [{ name: "grin", source: `#${content}e` }],
    });
    const answers = [own("d3", "1"), own("d4", "2"), { ...manifest, base: "other" }];
    const asked: string[] = [];
    const library = new Library(manifest, async (address) => {
      asked.push(address);
      if (address === "/manifest") return encode(answers.shift());
      return address.startsWith("/compounds") ? compound([2]) : encode({ positions: bytes(new Float32Array(9)) });
    });
    await library.positions("kaori");
    expect(await library.renew()).toBe(true);
    expect([library.sourceOf("faces", "kin"), library.sourceOf("expressions", "grin")]).toEqual(["#1", "#1e"]);
    await library.compound("#1", "#1e");
    expect(await library.renew()).toBe(true);
    await library.positions("#1"); // still on its way out
    await library.positions("#2");
    await library.positions("kaori");
    expect(library.sourceOf("faces", "kin")).toBe("#2");
    expect(library.manifest.digest).toBe("d4");
    expect(await library.renew()).toBe(false);
    expect(library.manifest.digest).toBe("d4");
    expect(asked.filter((address) => address !== "/manifest")).toEqual([
      "/assets/kaori",
      "/compounds/d/%231/%231e",
      "/contents/1",
      "/contents/2",
    ]);
  });

  it("lets the newest of two answers win, whichever comes first", async () => {
    const waiting: ((bytes: Uint8Array) => void)[] = [];
    const library = new Library(manifest, () => new Promise((resolve) => waiting.push(resolve)));
    const [first, second] = [library.renew(), library.renew()];
    waiting[1]?.(encode({ ...manifest, digest: "new" }));
    waiting[0]?.(encode({ ...manifest, digest: "old" }));
    expect(await Promise.all([first, second])).toEqual([true, true]);
    expect(library.manifest.digest).toBe("new");
  });

  it("tries again until the server is there, but not against a refusal", async () => {
    let left = 2;
    const shaky = async (): Promise<Uint8Array> => {
      left -= 1;
      if (left >= 0) throw new Error("away");
      return Uint8Array.of(7);
    };
    expect(await fetchWithRetry("/x", shaky)).toEqual(Uint8Array.of(7));
    await expect(fetchWithRetry("/x", () => Promise.reject(new RefusedAddress("404")))).rejects.toThrow("404");
  });
});

describe("reading", () => {
  it("refuses a mesh that points past the positions", () => {
    expect(readMesh(mesh, 3).triangles).toEqual(Uint32Array.from([0, 1, 2]));
    expect(() => readMesh(mesh, 2)).toThrow("skin");
    expect(() => readMesh({ ...mesh, uv: bytes(new Float32Array(4)) }, 3)).toThrow("texture coordinates");
    expect(() => readMesh({ ...mesh, openness: new Uint8Array(2) }, 3)).toThrow("3 vertices but openness for 2");
  });

  it("refuses a line that points past the positions", () => {
    const line = { name: "lips", loop: bytes(Uint32Array.from([2, 0, 1])) };
    expect([...readLine(line, 3)]).toEqual([2, 0, 1]);
    expect(() => readLine(line, 2)).toThrow("lips");
  });

  it("refuses a compound that does not fit", () => {
    expect(() => readCompound(compound([3]), 3)).toThrow("3");
    expect(() =>
      readCompound(encode({ scale: Number.NaN, indices: new Uint8Array(), deltas: new Uint8Array() }), 3),
    ).toThrow("0 vertices");
  });
});
