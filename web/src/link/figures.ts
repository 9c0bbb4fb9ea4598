/** Reads figures: what all bodies share, each body, and the poses. */

import { aligned } from "./arrays";
import { FINGERS, HINGES, HIPS, LIMBS, SHAPES, SHOULDERS } from "./constants";
import type { BodyAsset, FigureAsset, LimbFieldAsset, PoseDocument } from "./messages";

/** What all bodies share (`model.body.figure_space`): V rows of the head's skin, then B of the body, a skirt's the last. */
export interface FigureSpace {
  /** Names of the bones; a parent stands before its children, -1 before the first. */
  readonly bones: readonly string[];
  readonly parents: Int32Array;
  readonly headRows: number;
  readonly bodyRows: number;
  /** (V + B, 8): the bones that move a row, and how much each, of 65535, which they sum to. */
  readonly rowBones: Uint8Array;
  readonly rowWeights: Uint16Array;
  /** (V + B,): how much of a row's move dual quaternions make, 255 is all. */
  readonly shares: Uint8Array;
  /** Of the body, as rows. */
  readonly triangles: Uint32Array;
  /** Rows of the head at which it meets the body, the first `rim` of them the rim. */
  readonly edge: Uint32Array;
  readonly rim: number;
  /** Rows of the body (0 is its first) that follow the head's edge, and by which shares (joined, edge). */
  readonly joined: Uint32Array;
  readonly join: Float32Array;
  /** Rows whose mean, moved by an offset in metres, is the joint that the head turns on. */
  readonly headJoint: Uint32Array;
  readonly headJointOffset: readonly [number, number, number];
  /** Triangles of the skirt, as rows, and the first of these. */
  readonly skirt: Uint32Array;
  readonly firstOfSkirt: number;
  /** Rows that have correctives (c,), and which joint calls them. */
  readonly bending: Uint32Array;
  readonly bendingHinges: Uint8Array;
  /** By name: cover, thick, trim and hidden of each row (V + B, 4), metres (`model.body.garment`). */
  readonly garments: ReadonlyMap<string, Float32Array>;
  /** Rows that lie on limbs (l,), on which of `LIMBS`, and how far along it. */
  readonly limbRows: Uint32Array;
  readonly limbs: Uint8Array;
  readonly limbWays: Float32Array;
  readonly limbFields: ReadonlyMap<string, LimbField>;
}

/** A limb field: what drives it; which of the rows on limbs it moves, and how (k, 3): out, round, along. */
export interface LimbField {
  readonly driver: string;
  readonly places: Uint32Array;
  readonly values: Float32Array;
}

/** Joints that have correctives: elbows and knees, fingers, hips, shoulders (`model.body.correctives`). */
export const CORRECTED = HINGES.length + FINGERS.length + HIPS.length + SHOULDERS.length;

/** A body, metres: its rows (B, 3), where it has the head's edge, where bones begin and end (bones, 3), and
 * its correctives (4 c, 3): of the rows that bend the first of their joints, then the second, third and fourth. */
export interface Body {
  readonly positions: Float32Array;
  readonly edge: Float32Array;
  readonly joints: Float32Array;
  readonly ends: Float32Array;
  readonly correctives: Float32Array;
}

/** A pose (`model.body.pose`): rotation vectors (bones, 3), radians; hips and feet (2, 3), leg lengths. */
export interface FigurePose {
  readonly turns: Float32Array;
  readonly travel: Float32Array;
  readonly feet: Float32Array;
  readonly feetTurns: Float32Array;
}

/** Bones that move one row. */
export const ROW_BONES = 8;

/**
 * What all bodies share as typed arrays; an Error when it does not fit a head of `skin` rows, or itself; `garments`: their
 * names, in the asset's order.
 */
export function readFigureSpace(asset: FigureAsset, skin: number, garments: readonly string[]): FigureSpace {
  const rowBones = new Uint8Array(aligned(asset.row_bones));
  const rows = rowBones.length / ROW_BONES;
  const edge = new Uint32Array(aligned(asset.edge));
  const joined = new Uint32Array(aligned(asset.joined));
  const skirt = new Uint32Array(aligned(asset.skirt));
  const worn = new Float32Array(aligned(asset.garments));
  const space: FigureSpace = {
    bones: asset.bones,
    parents: new Int32Array(aligned(asset.parents)),
    headRows: asset.head_rows,
    bodyRows: rows - asset.head_rows,
    rowBones,
    rowWeights: summedUp(new Uint16Array(aligned(asset.row_weights))),
    shares: new Uint8Array(aligned(asset.shares)),
    triangles: new Uint32Array(aligned(asset.triangles)),
    edge,
    rim: asset.rim,
    joined,
    join: new Float32Array(aligned(asset.join)),
    headJoint: new Uint32Array(aligned(asset.head_joint)),
    headJointOffset: asset.head_joint_offset,
    skirt,
    bending: new Uint32Array(aligned(asset.bending)),
    bendingHinges: new Uint8Array(aligned(asset.bending_hinges)),
    firstOfSkirt: skirt.reduce((least, row) => Math.min(least, row), rows),
    limbRows: new Uint32Array(aligned(asset.limb_rows)),
    limbs: new Uint8Array(aligned(asset.limbs)),
    limbWays: new Float32Array(aligned(asset.limb_ways)),
    limbFields: new Map(asset.limb_fields.map((field) => [field.name, readLimbField(field)])),
    garments: new Map(garments.map((name, place) => [name, worn.subarray(4 * rows * place, 4 * rows * (place + 1))])),
  };
  const fits =
    asset.head_rows === skin &&
    space.rowWeights.length === rowBones.length &&
    space.shares.length === rows &&
    space.parents.length === asset.bones.length &&
    space.join.length === joined.length * edge.length &&
    worn.length === 4 * rows * garments.length &&
    [space.triangles, skirt].every((corners) => corners.every((row) => row < rows)) &&
    rowBones.every((bone) => bone < asset.bones.length) &&
    [edge, space.headJoint].every((named) => named.every((row) => row < skin)) &&
    space.bendingHinges.length === space.bending.length &&
    space.bending.every((row) => row >= skin && row < rows) &&
    space.bendingHinges.every((joint) => joint < CORRECTED) &&
    joined.every((row) => row < space.bodyRows) &&
    limbsFit(space);
  if (!fits) throw new Error(`The figures of ${rows} rows do not fit a head of ${skin}; bake the cast again.`);
  return space;
}

const readLimbField = ({ driver, places, values }: LimbFieldAsset): LimbField => ({
  driver,
  places: new Uint32Array(aligned(places)),
  values: new Float32Array(aligned(values)),
});

const limbsFit = ({ limbRows, limbs, limbWays, limbFields, headRows, bodyRows }: FigureSpace): boolean =>
  limbs.length === limbRows.length &&
  limbWays.length === limbRows.length &&
  limbs.every((limb) => limb < LIMBS.length) &&
  limbRows.every((row) => row >= headRows && row < headRows + bodyRows) &&
  [...limbFields.values()].every(
    ({ places, values }) => values.length === 3 * places.length && places.every((place) => place < limbRows.length),
  );

/** Weights that sum to 65535 row by row: rounding is the first bone's, which weighs most. */
function summedUp(weights: Uint16Array): Uint16Array {
  for (let first = 0; first < weights.length; first += ROW_BONES) {
    const sum = weights.subarray(first, first + ROW_BONES).reduce((whole, weight) => whole + weight, 0);
    weights[first] = (weights[first] as number) + 65535 - sum;
  }
  return weights;
}

/** A body as typed arrays; an Error when it does not fit the space. */
export function readBody(asset: BodyAsset, space: FigureSpace): Body {
  const read = (bytes: Uint8Array): Float32Array => new Float32Array(aligned(bytes));
  const [positions, edge, correctives] = [read(asset.positions), read(asset.edge), read(asset.correctives)];
  const [joints, ends] = [read(asset.joints), read(asset.ends)];
  const bones = 3 * space.bones.length;
  if (
    positions.length !== 3 * space.bodyRows ||
    edge.length !== 3 * space.edge.length ||
    joints.length !== bones ||
    ends.length !== bones ||
    correctives.length !== 3 * SHAPES * space.bending.length
  )
    throw new Error(`A body of ${positions.length / 3} rows does not fit figures of ${space.bodyRows}.`);
  return { positions, edge, joints, ends, correctives };
}

/** A pose as typed arrays. */
export const readFigurePose = (pose: PoseDocument): FigurePose => ({
  turns: new Float32Array(aligned(pose.turns)),
  travel: Float32Array.from(pose.travel),
  feet: new Float32Array(aligned(pose.feet)),
  feetTurns: new Float32Array(aligned(pose.feet_turns)),
});
