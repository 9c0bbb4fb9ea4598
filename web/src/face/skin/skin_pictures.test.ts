import type * as THREE from "three";
import { describe, expect, it, vi } from "vitest";
import type { Library } from "../../link/assets";
import type { FaceDocument } from "../../link/messages";
import { SkinPictures } from "./skin_pictures";

/** Faces by source with the digests of their pictures, "" for none; what was asked, uploaded and closed. */
function stand(digests: Record<string, string>) {
  const [asked, uploads, closed]: [string[], THREE.Texture[], string[]] = [[], [], []];
  const faces = new Map(
    Object.entries(digests).map(([source, albedo]) => [source, { source, albedo } as unknown as FaceDocument]),
  );
  const albedo = async (face: string): Promise<ImageBitmap> => {
    asked.push(face);
    if (face === "broken") throw new Error("refused");
    return { width: 1, height: 1, close: () => closed.push(face) } as unknown as ImageBitmap;
  };
  const library = { faces, albedo } as unknown as Library;
  const pictures = new SkinPictures(library, (texture) => uploads.push(texture));
  return { pictures, asked, uploads, closed };
}

const showing = (...facesSeen: string[]) => [{ facesSeen }];

describe("pictures on the GPU", () => {
  it("are fetched once for faces that share one, and not for faces without", async () => {
    const { pictures, asked } = stand({ kaori: "a", twin: "a", dog: "" });
    pictures.want(["kaori", "twin", "dog"]);
    expect(pictures.here(["dog"])).toBe(true);
    expect(pictures.here(["kaori"])).toBe(false);
    await pictures.complete();
    expect(asked).toEqual(["kaori"]);
    expect(pictures.here(["kaori", "twin"])).toBe(true);
    expect(pictures.of("dog")).toBeUndefined();
    expect(pictures.of("kaori")).toBeUndefined(); // not yet on the GPU
  });

  it("are uploaded one a frame, and grow in where their face is seen already", async () => {
    const { pictures, uploads } = stand({ kaori: "a", old: "b" });
    pictures.want(["kaori", "old"]);
    await pictures.complete();
    pictures.advance(showing("kaori"), 0.1, false);
    expect(uploads).toHaveLength(1);
    expect(pictures.of("kaori")?.grown).toBe(0);
    const seen = Array.from({ length: 6 }, () => {
      pictures.advance(showing("kaori"), 0.1, false);
      return pictures.of("kaori")?.grown ?? 0;
    });
    expect(uploads).toHaveLength(2);
    expect(pictures.of("old")?.grown).toBe(1); // nobody saw it come
    expect(seen.every((grown, at) => grown >= (seen[at - 1] ?? 0) && grown - (seen[at - 1] ?? 0) < 0.3)).toBe(true);
    expect(seen.at(-1)).toBe(1);
    expect(pictures.settled(["kaori", "old"])).toBe(true);
  });

  it("show in full at once where that is asked for", async () => {
    const { pictures } = stand({ kaori: "a", old: "b" });
    pictures.want(["kaori", "old"]);
    await pictures.complete();
    pictures.advance(showing("kaori", "old"), 0, true);
    expect(pictures.settled(["kaori", "old"])).toBe(true);
  });

  it("that are refused keep nobody waiting", async () => {
    const warn = vi.spyOn(console, "warn").mockImplementation(() => undefined);
    const { pictures, asked } = stand({ broken: "a" });
    pictures.want(["broken"]);
    await pictures.complete();
    pictures.want(["broken"]);
    expect(asked).toEqual(["broken"]);
    expect(pictures.here(["broken"]) && pictures.settled(["broken"])).toBe(true);
    expect(warn).toHaveBeenCalledOnce();
    warn.mockRestore();
  });

  it("are forgotten when many came later, but never one that is seen; and come again", async () => {
    const names = Array.from({ length: 12 }, (_, at) => `face ${at}`);
    const { pictures, closed, asked } = stand(Object.fromEntries(names.map((name) => [name, name])));
    for (const name of names) {
      pictures.want([name]);
      await pictures.complete();
      pictures.advance(showing("face 0"), 0.1, true);
    }
    expect(closed).toEqual(["face 1", "face 2", "face 3", "face 4"]);
    expect(pictures.of("face 0")).toBeDefined();
    pictures.want(["face 1"]);
    await pictures.complete();
    expect(asked.at(-1)).toBe("face 1");
    pictures.dispose();
    expect(closed).toHaveLength(13);
  });

  it("are uploaded anew on another graphics context", async () => {
    const { pictures, uploads } = stand({ kaori: "a" });
    pictures.want(["kaori"]);
    await pictures.complete();
    pictures.advance(showing(), 0.1, true);
    pictures.rebuild({ detail: true, anisotropy: 4 });
    expect(pictures.of("kaori")).toBeUndefined();
    pictures.advance(showing("kaori"), 0, true);
    expect(uploads).toHaveLength(2);
    expect(pictures.of("kaori")?.texture.anisotropy).toBe(4);
  });
});
