import { describe, expect, it } from "vitest";
import { joinGltf } from "./joined_gltf";

const gltf = (document: object, name = "anna.gltf") => new File([JSON.stringify(document)], name);
const bytes = new Uint8Array(100_000).map((_, at) => at % 251);
const buffer = new File([bytes], "anna head.bin");
const BUFFERS = { buffers: [{ uri: "parts/anna%20head.bin", byteLength: bytes.length }] };

describe("a .gltf", () => {
  it("holds the buffers and pictures that came with it, byte for byte", async () => {
    const picture = new File(["png"], "skin.png", { type: "image/png" });
    const other = new File(["{}"], "smile.json");
    const document = { ...BUFFERS, images: [{ uri: "skin.png" }] };
    const [joined, ...rest] = await joinGltf([buffer, gltf(document), picture, other]);
    expect([joined?.name, rest]).toEqual(["anna.gltf", [other]]);
    const { buffers, images } = JSON.parse((await joined?.text()) ?? "") as typeof document;
    expect(buffers[0]?.byteLength).toBe(bytes.length);
    const [head, data] = buffers[0]?.uri.split(",") ?? [];
    expect(head).toBe("data:application/octet-stream;base64");
    expect(Uint8Array.from(atob(data ?? ""), (letter) => letter.charCodeAt(0))).toEqual(bytes);
    expect(images[0]?.uri).toBe(`data:image/png;base64,${btoa("png")}`);
  });

  it("stays as it is without them, or where it is none", async () => {
    const alone = [gltf(BUFFERS)];
    expect(await joinGltf(alone)).toBe(alone);
    const broken = new File(["{"], "broken.gltf");
    expect(await joinGltf([broken, buffer])).toEqual([broken, buffer]);
    const stranger = new File(["x"], "other.bin");
    const [same, left] = await joinGltf([gltf(BUFFERS), stranger]);
    expect(JSON.parse((await same?.text()) ?? "")).toEqual(BUFFERS);
    expect(left).toBe(stranger);
  });
});
