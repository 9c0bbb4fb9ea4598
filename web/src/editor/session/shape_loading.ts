/** Shapes of any source, own drafts and old revisions too, as the server computes them. */

import { decode } from "@msgpack/msgpack";
import { aligned } from "../../link/arrays";
import { insist } from "../../link/assets";
import type { ContentAsset } from "../../link/messages";
import type { Workbench } from "./draft_store";

/** The positions of a face by its source, (vertices, 3) metres. */
async function facePositions({ library }: Workbench, source: string): Promise<Float32Array> {
  if (library === null) throw new Error("The cast is not here yet; wait a moment.");
  if (library.hasFace(source)) return library.positions(source);
  const asset = decode(await insist(`/contents/${source.slice(1)}`)) as ContentAsset;
  return new Float32Array(aligned(asset.positions));
}

/** A face (a source) that wears an expression (a source), (vertices, 3) metres. */
export async function wearing(bench: Workbench, face: string, expression: string): Promise<Float32Array> {
  const rest = await facePositions(bench, face);
  if (expression === "neutral" || bench.library === null) return rest;
  const { scale, indices, deltas } = await bench.library.compound(face, expression);
  const worn = rest.slice();
  indices.forEach((row, at) => {
    for (let axis = 0; axis < 3; axis += 1)
      worn[3 * row + axis] = (worn[3 * row + axis] as number) + scale * (deltas[3 * at + axis] as number);
  });
  return worn;
}
