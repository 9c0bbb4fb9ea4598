import { describe, expect, it } from "vitest";
import { ACCEPTED_PHOTOGRAPHS, ACCEPTED_SCANS, arePhotographs, comingOf, nameOf } from "./dropped_files";

describe("files that are dropped", () => {
  it.each([
    [["anna.ply"], "expression", "scan"],
    [["Anna.STL"], "face", "scan"],
    [["anna.vrm"], "expression", "import"],
    [["anna.gltf"], "face", "either"],
    [["anna.gltf", "anna.bin"], "expression", "import"],
    [["anna.gltf", "anna.bin", "skin.png"], "expression", "import"],
    [["anna.gltf", "anna.bin"], "face", "scan"],
    [["anna.gltf", "anna.bin"], null, "scan"],
    [["anna.csv"], "face", "scan"],
    [["anna.HEIC"], "face", "scan"],
    [["anna.obj", "anna.mtl", "skin.jpg"], "expression", "scan"],
    [["anna.obj"], "face", "either"],
    [["anna.glb"], "face", "either"],
    [["anna.glb"], "expression", "import"],
    [["anna.glb"], null, "either"],
    [["anna.obj"], null, "either"],
    [["a.obj", "b.obj"], null, "import"],
    [["a.obj", "b.obj"], "face", "import"],
    [["smile.json", "anna.ply"], "face", "import"],
    [["notes.doc"], "face", "import"],
    [["front.JPG", "left.png"], "expression", "scan"],
    [["anna.jpeg"], "face", "scan"],
    [["anna.jpeg", "notes.doc"], "face", "import"],
    [["README"], "expression", "import"],
  ] as const)("%j while %s is open are taken as %s", (names, open, coming) => {
    expect(comingOf(names, open)).toBe(coming);
  });

  it("give a face its first name", () => {
    expect(nameOf(["skin.jpg", "anna_b  scan.OBJ"])).toBe("Anna b scan");
    expect(nameOf([".ply"])).toBe("Scanned face");
    expect(nameOf([])).toBe("Face from the camera");
    expect(nameOf([`${"a".repeat(200)}.ply`]).length).toBeLessThanOrEqual(64);
  });

  it("are photographs where all of them are pictures", () => {
    expect(arePhotographs(["a.jpg", "b.PNG", "c.jpeg", "d.HEIC"])).toBe(true);
    expect(arePhotographs(["a.jpg", "b.obj"])).toBe(false);
    expect(arePhotographs([])).toBe(false);
    expect(ACCEPTED_PHOTOGRAPHS.split(",")).toEqual(expect.arrayContaining([".jpg", ".png", ".heic"]));
  });

  it("may be chosen with what lies beside them", () => {
    expect(ACCEPTED_SCANS.split(",")).toEqual(expect.arrayContaining([".ply", ".mtl", ".jpg", ".glb"]));
  });
});
