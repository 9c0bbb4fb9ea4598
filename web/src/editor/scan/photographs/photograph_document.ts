/** A face made of photographs as the server shows it, in typed arrays. */

import { decode } from "@msgpack/msgpack";
import { aligned } from "../../../link/arrays";
import type { PhotographPreview } from "../../../link/editing_messages";
import { normalsOf, type SeenScan } from "../data/scan_document";

/** What is looked at as a scan is: its surface is the skin as photographed, its residual 0 where a photograph shows it. */
export interface SeenPhotographs extends Pick<SeenScan, "token" | "hair" | "surface" | "placement"> {
  readonly doubts: readonly { readonly sentence: string }[];
  /** Of what was left out, sentences. */
  readonly notes: readonly string[];
  readonly found: Record<string, never>;
  readonly bare: true;
  readonly face: { readonly positions: Float32Array; readonly residual: Float32Array };
  /** How far the landmarks of each lie from the face, pixels. */
  readonly off: readonly number[];
  /** How far the face may lie from the person's, millimetres. */
  readonly spread: number;
  /** Which share of the skin a photograph shows. */
  readonly seen: number;
}

const STILL = { scale: 1, rotation: [1, 0, 0, 0, 1, 0, 0, 0, 1], shift: [0, 0, 0] } as const;

export function readPhotographs(bytes: Uint8Array): SeenPhotographs {
  const sent = decode(bytes) as PhotographPreview;
  const [positions, triangles] = [new Float32Array(aligned(sent.positions)), new Uint32Array(aligned(sent.triangles))];
  return {
    token: sent.token,
    doubts: sent.doubts.map((sentence) => ({ sentence })),
    notes: [],
    hair: { style: sent.hair_style, colour: sent.hair },
    surface: { positions, triangles, normals: normalsOf(positions, triangles), colours: sent.colours.slice() },
    placement: { ...STILL, shift: [...STILL.shift] },
    found: {},
    bare: true,
    face: {
      positions: new Float32Array(aligned(sent.face)),
      residual: Float32Array.from(sent.shown, (shown) => (shown > 0 ? 0 : Number.NaN)),
    },
    off: sent.off,
    spread: sent.spread,
    seen: sent.seen,
  };
}
