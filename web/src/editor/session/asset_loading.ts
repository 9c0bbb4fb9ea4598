/** What the canvas fetches: faces, how they answer to a field, and compounds. */

import { decode } from "@msgpack/msgpack";
import { aligned } from "../../link/arrays";
import {
  decodePicture,
  type Fetch,
  fetchBytes,
  fetchWithRetry,
  KEY,
  RefusedAddress,
  readCompound,
} from "../../link/assets";
import type { FaceDocument, Manifest } from "../../link/messages";
import { Backoff } from "../../link/reconnecting_socket";

/** A face as a document and its positions, (rows, 3) metres. */
export interface LoadedFace {
  document: FaceDocument;
  positions: Float32Array;
}

const key = (source: string): string => encodeURIComponent(source);

/** How often a draft's content is asked for in vain: a server that has just taken over has it once the draft is open. */
const TRIES = 12;

/** The bytes behind an address that names a draft's content. */
async function fetchContent(address: string, read: Fetch): Promise<Uint8Array> {
  const backoff = new Backoff();
  for (let left = TRIES; ; left--) {
    try {
      return await fetchWithRetry(address, read);
    } catch (error) {
      if (!(error instanceof RefusedAddress) || left <= 1) throw error;
      await new Promise((resolve) => setTimeout(resolve, backoff.next() * 1000));
    }
  }
}

/** A face of the manifest, or a draft's by its content (`#` and a key). */
export async function loadFace(manifest: Manifest, source: string, read: Fetch = fetchBytes): Promise<LoadedFace> {
  const listed = manifest.faces.find((face) => face.source === source);
  const address = listed?.url ?? `/contents/${source.replace(/^#/, "")}`;
  const fetched = listed === undefined ? fetchContent(address, read) : fetchWithRetry(address, read);
  const asset = decode(await fetched) as { positions: Uint8Array; face?: FaceDocument };
  const document = listed ?? asset.face;
  const positions = new Float32Array(aligned(asset.positions));
  if (document === undefined || positions.length !== 3 * manifest.vertices)
    throw new Error(`The face ${source} has ${positions.length / 3} vertices, expected ${manifest.vertices}.`);
  return { document, positions };
}

/** The picture on the skin of a face that has one. */
export async function loadPicture({ albedo, source }: FaceDocument, read: Fetch = fetchBytes): Promise<ImageBitmap> {
  return decodePicture(await fetchContent(`/albedos/${albedo}/${key(source)}`, read));
}

/** How a face answers to a field, (3, V, 3); undefined where the server knows no such face. */
export async function loadTangents(
  manifest: Manifest,
  source: string,
  read: Fetch = fetchBytes,
): Promise<Float32Array | undefined> {
  try {
    const bytes = await fetchWithRetry(`/tangents/${key(manifest.base)}/${key(source)}`, read);
    return new Float32Array(aligned((decode(bytes) as { tangents: Uint8Array }).tangents));
  } catch (error) {
    if (error instanceof RefusedAddress) return undefined;
    throw error;
  }
}

/** A face (rest: (rows, 3) metres) wearing an expression, both by source; as positions. */
export async function loadWorn(
  manifest: Manifest,
  face: string,
  expression: string,
  rest: Float32Array,
  read: Fetch = fetchBytes,
): Promise<Float32Array> {
  const out = rest.slice();
  if (expression === "neutral") return out;
  const address = `/compounds/${key(manifest.base)}/${key(face)}/${key(expression)}`;
  const drafted = expression.startsWith(KEY) || face.startsWith(KEY);
  const bytes = await (drafted ? fetchContent : fetchWithRetry)(address, read);
  const { scale, indices, deltas } = readCompound(bytes, manifest.vertices);
  indices.forEach((row, n) => {
    for (let axis = 0; axis < 3; axis++)
      out[3 * row + axis] = (out[3 * row + axis] as number) + (deltas[3 * n + axis] as number) * scale;
  });
  return out;
}
