import { encode } from "@msgpack/msgpack";
import { expect, it } from "vitest";
import { RefusedAddress } from "../../link/assets";
import type { Manifest } from "../../link/messages";
import { loadFace, loadTangents, loadWorn } from "./asset_loading";

const manifest = {
  base: "b4se",
  vertices: 2,
  faces: [{ name: "dog", source: "dog", url: "/assets/d0g" }],
} as unknown as Manifest;
const bytesOf = (values: Float32Array | Uint32Array | Int16Array): Uint8Array => new Uint8Array(values.buffer);
const rest = Float32Array.from([0, 0, 0, 1, 1, 1]);

/** A server that has these documents. */
const server = (documents: Readonly<Record<string, unknown>>) => async (address: string) => {
  if (!(address in documents)) throw new RefusedAddress(address);
  return encode(documents[address]);
};

it("loads faces of the manifest, and drafts by their content", async () => {
  const face = { name: "draft" };
  const positions = bytesOf(rest);
  const read = server({ "/assets/d0g": { positions }, "/contents/abc": { positions, face } });
  expect((await loadFace(manifest, "dog", read)).document.name).toBe("dog");
  expect(await loadFace(manifest, "#abc", read)).toEqual({ document: face, positions: rest });
});

it("refuses a face of another cast", async () => {
  const read = server({ "/assets/d0g": { positions: bytesOf(rest.slice(3)) } });
  await expect(loadFace(manifest, "dog", read)).rejects.toThrow("1 vertices, expected 2");
});

it("adds a compound to the face, by the sources of both", async () => {
  const deltas = Int16Array.from([100, -200, 0]);
  const compound = { scale: 0.001, indices: bytesOf(Uint32Array.of(1)), deltas: bytesOf(deltas), allowed: null };
  const read = server({ "/compounds/b4se/dog/%23abc": compound });
  const worn = await loadWorn(manifest, "dog", "#abc", rest, read);
  expect([...worn]).toEqual([...Float32Array.from([0, 0, 0, 1.1, 0.8, 1])]);
  expect(await loadWorn(manifest, "dog", "neutral", rest, read)).toEqual(rest);
});

it("knows no tangents of a face that the server does not know", async () => {
  const tangents = bytesOf(Float32Array.of(1, 2, 3));
  const read = server({ "/tangents/b4se/dog": { tangents } });
  expect(await loadTangents(manifest, "dog", read)).toEqual(Float32Array.of(1, 2, 3));
  expect(await loadTangents(manifest, "cat", read)).toBeUndefined();
});
