import { encode } from "@msgpack/msgpack";
import { expect, it, vi } from "vitest";
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

it("asks again for a draft's content that a server has not yet which has just taken over", async () => {
  vi.useFakeTimers();
  try {
    const positions = bytesOf(rest);
    const documents: Record<string, unknown> = {};
    const face = loadFace(manifest, "#abc", server(documents));
    const worn = loadWorn(manifest, "dog", "#def", rest, server(documents));
    await vi.advanceTimersByTimeAsync(100);
    const compound = { scale: 1, indices: new Uint8Array(), deltas: new Uint8Array(), allowed: null };
    Object.assign(documents, { "/contents/abc": { positions, face: { name: "draft" } } });
    Object.assign(documents, { "/compounds/b4se/dog/%23def": compound });
    await vi.advanceTimersByTimeAsync(2000);
    expect((await face).positions).toEqual(rest);
    expect(await worn).toEqual(rest);
  } finally {
    vi.useRealTimers();
  }
});

it("gives up a draft's content that never comes, and what the cast has not at once", async () => {
  vi.useFakeTimers();
  try {
    const failed = vi.fn();
    loadWorn(manifest, "dog", "#gone", rest, server({})).catch(failed);
    await vi.advanceTimersByTimeAsync(60_000);
    expect(failed).toHaveBeenCalledWith(expect.any(RefusedAddress));
    await expect(loadWorn(manifest, "dog", "gone", rest, server({}))).rejects.toThrow(RefusedAddress);
  } finally {
    vi.useRealTimers();
  }
});
