import { describe, expect, it } from "vitest";
import type { Library } from "../../link/assets";
import type { FaceDocument, Manifest } from "../../link/messages";
import { ensureFace, wearing } from "./thumbnail_renderer";

const document = { name: "hobbart", source: "#b" } as FaceDocument;

function library(): Library {
  const faces = new Map([["generic", { name: "generic" } as FaceDocument]]);
  return {
    faces,
    manifest: { hair: [{ name: "crop", url: "", scalp: 0.9 }] } as unknown as Manifest,
    hasFace: (source: string) => faces.has(source),
    sourceOf: (_: "faces" | "expressions", name: string) => (name === "hers" ? "#a" : name),
  } as unknown as Library;
}

describe("a picture of a face", () => {
  it("waits for the look of one that was saved a moment ago, and asks for it once", async () => {
    const cast = library();
    const asked: string[] = [];
    const load = async (_: Manifest, source: string) => {
      asked.push(source);
      return { document, positions: new Float32Array() };
    };
    await ensureFace(cast, "#b", load);
    await ensureFace(cast, "#b", load);
    expect(asked).toEqual(["#b"]);
    expect(cast.faces.get("#b")).toBe(document);
  });

  it("asks for nothing that the cast has", async () => {
    const cast = library();
    const load = () => Promise.reject(new Error("asked"));
    await ensureFace(cast, "generic", load);
    await ensureFace(cast, "hers", load);
  });

  it("shows another style on the same head, and the face as it is where it wears that one", () => {
    const look = { hair_style: "bob", scalp: 1, hair: "#102030" };
    const own = { name: "hers", source: "#a", url: "/contents/a", look } as FaceDocument;
    const cast = library();
    cast.faces.set("#a", own);
    expect(wearing(cast, "hers", "bob")).toBe("#a");
    const bald = cast.faces.get(wearing(cast, "hers", ""));
    expect(bald).toEqual({ ...own, look: { ...look, hair_style: "", scalp: 0 } });
    expect(cast.faces.get(wearing(cast, "#a", "crop"))?.look).toEqual({ ...look, hair_style: "crop", scalp: 0.9 });
    expect(cast.faces.get("#a")).toBe(own);
  });

  it("refuses a name that nobody knows instead of drawing it black", async () => {
    await expect(ensureFace(library(), "nobody")).rejects.toThrow('There is no face "nobody" in this cast.');
  });
});
