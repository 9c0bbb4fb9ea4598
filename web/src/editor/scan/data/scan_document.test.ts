import { encode } from "@msgpack/msgpack";
import { describe, expect, it } from "vitest";
import type { ScanPreview } from "../../../link/editing_messages";
import type { Triple } from "../../canvas/math/vectors";
import { normalsOf, placed, quarterTurned, readScan, unplaced } from "./scan_document";

const bytes = (array: Float32Array | Uint32Array): Uint8Array => new Uint8Array(array.buffer);
const CORNERS = Float32Array.from([0, 0, 0, 2, 0, 0, 0, 3, 0]);
const SENT: ScanPreview = {
  token: "t",
  file: "anna.ply",
  placement: [0.5, 0, -1, 0, 1, 0, 0, 0, 0, 1, 10, 20, 30],
  unit: "metres",
  doubts: [],
  notes: [],
  given: {},
  found: { nose_tip: [1, 2, 3] },
  positions: bytes(CORNERS),
  triangles: bytes(Uint32Array.from([0, 1, 2])),
  colours: Uint8Array.from([1, 2, 3, 4, 5, 6, 7, 8, 9]),
  face: bytes(CORNERS),
  residual: bytes(Float32Array.from([0.5, Number.NaN])),
  figures: { median: 0.1, p95: 0.2, seen: 1 },
  shut: null,
  hair_style: "bob",
  hair: "#112233",
};

describe("a scan as it is sent", () => {
  it("becomes typed arrays, whatever the offset of its bytes", () => {
    const { surface, face, hair } = readScan(encode(SENT));
    expect([...surface.positions]).toEqual([...CORNERS]);
    expect([...surface.triangles]).toEqual([0, 1, 2]);
    expect([...surface.normals]).toEqual([0, 0, 1, 0, 0, 1, 0, 0, 1]);
    expect(surface.colours?.[8]).toBe(9);
    expect([...(face?.residual ?? [])]).toEqual([0.5, Number.NaN]);
    expect(hair).toEqual({ style: "bob", colour: "#112233" });
  });

  it("may have neither face nor colours nor surface", () => {
    const bare = {
      ...SENT,
      face: null,
      residual: null,
      figures: null,
      colours: new Uint8Array(),
      triangles: new Uint8Array(),
    };
    const { surface, face } = readScan(encode(bare));
    expect([face, surface.colours, surface.triangles.length]).toEqual([null, null, 0]);
    expect([...surface.normals]).toEqual(new Array(9).fill(0));
  });

  it("leads from its own frame to the face's and back", () => {
    const { placement } = readScan(encode(SENT));
    expect(placed(placement, [2, 4, 6])).toEqual([0.5 * -4 + 10, 0.5 * 2 + 20, 0.5 * 6 + 30]);
    const back: Triple = unplaced(placement, placed(placement, [2, 4, 6]));
    back.forEach((part, axis) => {
      expect(part).toBeCloseTo([2, 4, 6][axis] as number, 12);
    });
  });
});

describe("normals", () => {
  it("are unit, and by the areas of what meets", () => {
    const positions = Float32Array.from([0, 0, 0, 4, 0, 0, 0, 4, 0, 0, 0, 1, 1, 0, 0]);
    const normals = normalsOf(positions, Uint32Array.from([0, 1, 2, 0, 3, 4]));
    const [x, y, z] = [normals[0] as number, normals[1] as number, normals[2] as number];
    expect(Math.hypot(x, y, z)).toBeCloseTo(1, 6);
    expect(z / y).toBeCloseTo(16, 5);
  });
});

describe("a scan that lies", () => {
  it.each(["tip", "roll"] as const)("is turned back by four quarters (%s), and its own points stay on it", (way) => {
    const scan = readScan(encode(SENT));
    let turned = scan;
    for (let quarters = 0; quarters < 4; quarters += 1) {
      const own = unplaced(turned.placement, [...turned.surface.positions.slice(3, 6)] as Triple);
      turned = quarterTurned(turned, way);
      placed(turned.placement, own).forEach((part, axis) => {
        expect(part).toBeCloseTo(turned.surface.positions[3 + axis] as number, 4);
      });
    }
    turned.surface.positions.forEach((part, at) => {
      expect(part).toBeCloseTo(scan.surface.positions[at] as number, 4);
    });
    const [once] = [quarterTurned(scan, way).surface.normals.slice(0, 3)];
    expect([...once].map(Math.round)).toEqual(way === "tip" ? [0, -1, 0] : [0, 0, 1]);
  });
});
