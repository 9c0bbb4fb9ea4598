/** The figure of one character: the bodies that it wears, its bones in a frame, and what the GPU draws of them. */

import type { Library } from "../../link/assets";
import { LIMBS, SHAPES } from "../../link/constants";
import { type Body, CORRECTED } from "../../link/figures";
import type { FigureMix, Idle } from "../pose/pose";
import { trackedKey } from "../pose/tracked_mix";
import { bodySum, mixedBodies, type NeckPlaces, neckPlaces, type Parts, restingBones } from "./body_mix";
import { hingeBends, writeCalls } from "./corrective_calls";
import { type FigureJob, type FigurePass, type FigureTarget, limbNumbers } from "./figure_pass";
import { BONE_TEXELS } from "./figure_shaders";
import { type PosedBones, poseFigure, type RestingBones, turnHead } from "./kinematics";
import { limbWeights, writeLimbAxes, writeLimbFields } from "./limb_mix";
import { blankPose, type MixedPose, mixFigurePoses } from "./pose_mix";
import {
  IDENTITY,
  minus,
  ORIGIN,
  plus,
  product,
  quaternionOf,
  type Rotation,
  rotationOf,
  turnedBy,
  type Vector,
  vectorOf,
} from "./rotations";
import type { SharedFigures } from "./shared_figures";
import { placeOf, type Skeleton } from "./skeleton";
import { putTracked, trunkShare } from "./tracked_pose";

/** What a frame asks of a figure: its mix, the turn of the head (yaw, pitch, roll), the faces on air by name and by source, what they wear. */
export interface FigureCall {
  readonly mix: FigureMix;
  readonly idle: Idle;
  readonly head: readonly [number, number, number];
  readonly faces: Readonly<Record<string, number>>;
  readonly sources: Readonly<Record<string, number>>;
  /** How much of each expression and channel is on air: of those that play limb fields. */
  readonly worn: Readonly<Record<string, number>>;
}

/** The head's turn as the stage has it: yaw, then pitch, then roll. */
const turnOf = ([yaw, pitch, roll]: FigureCall["head"]): Rotation =>
  product(rotationOf([0, yaw, 0]), product(rotationOf([-pitch, 0, 0]), rotationOf([0, 0, -roll])));

/** The figure of one character. */
export class Figure {
  private readonly asked = new Map<string, Promise<unknown>>();
  private readonly bodies = new Map<string, Body>();
  private readonly lowest = new Map<string, number>();
  private readonly necks = new Map<string, NeckPlaces>();
  private readonly mixed: MixedPose;
  private readonly bones: Float32Array;
  private readonly bodyEdge: Float32Array;
  private readonly calls = new Float32Array(SHAPES * CORRECTED);
  private readonly limbAxes = new Float32Array(9 * LIMBS.length);
  private readonly limbFields: Float32Array;
  private limbWorn: ReadonlyMap<string, number> = new Map();
  private limbsFresh = false;
  private readonly place: Readonly<Record<"head" | "foot", number>>;
  private worn: Parts<string> = [];
  private resting: RestingBones | undefined;
  private posed: PosedBones | undefined;
  private restKey = "";
  private poseKey = "";
  private poses: Library["poses"] | undefined;
  private changed = false;
  private missing = 0;
  private target!: FigureTarget;
  private pass!: FigurePass;

  constructor(
    private readonly library: Library,
    private readonly shared: SharedFigures,
  ) {
    const { skeleton, space } = shared;
    this.mixed = blankPose(skeleton);
    this.bones = new Float32Array(4 * BONE_TEXELS * skeleton.names.length);
    this.limbFields = new Float32Array(limbNumbers(space));
    this.bodyEdge = new Float32Array(4 * space.edge.length);
    this.place = { head: placeOf(skeleton, "head"), foot: placeOf(skeleton, "foot.L") };
  }

  /** Makes its part of the GPU's memory, on a new graphics context too. */
  build(pass: FigurePass): FigureTarget {
    this.pass = pass;
    this.target = pass.createTarget();
    this.changed = true;
    this.limbsFresh = true;
    return this.target;
  }

  /** Fetches what these calls will wear. */
  want({ mix, faces, sources }: Pick<FigureCall, "mix" | "faces" | "sources">): void {
    for (const name of mixedBodies(mix.bodies, faces, [...this.shared.bodies.keys()]).keys())
      this.ask(`body ${name}`, async () => {
        const body = await this.library.body(name);
        this.bodies.set(name, body);
        this.lowest.set(
          name,
          body.positions.reduce((low, y, at) => (at % 3 === 1 ? Math.min(low, y) : low), 0),
        );
      });
    for (const source of Object.keys(sources))
      if (this.library.hasFace(source))
        this.ask(`face ${source}`, async () => {
          this.necks.set(source, neckPlaces(this.shared.space, await this.library.positions(source)));
        });
  }

  /** Whether all that was wanted has come, or was refused. */
  get here(): boolean {
    return this.missing === 0;
  }

  /** Waits for that. */
  async complete(): Promise<void> {
    await Promise.all(this.asked.values());
  }

  /** Finds where its bones are; nothing where none of its bodies or faces is here. */
  move({ mix, idle, head, faces, sources, worn: called }: FigureCall): void {
    const wanted = [...mixedBodies(mix.bodies, faces, [...this.shared.bodies.keys()])];
    const worn = shown(wanted, this.bodies);
    const carried = shown(Object.entries(sources), this.necks);
    if (worn.length === 0 || carried.length === 0) return;
    const restKey = JSON.stringify([worn, carried]);
    if (restKey !== this.restKey) this.rest(worn, carried);
    if (this.library.poses !== this.poses) this.poseKey = ""; // a pose may have come
    this.poses = this.library.poses;
    const tracked = mix.tracked ?? undefined;
    const played = [...this.shared.space.limbFields.keys()].map((name) => called[name] ?? 0);
    const poseKey = JSON.stringify([mix.poses, mix.regions, idle, head, played, trackedKey(tracked)]);
    if (restKey === this.restKey && poseKey === this.poseKey) return;
    [this.restKey, this.poseKey] = [restKey, poseKey];
    const { skeleton } = this.shared;
    mixFigurePoses(this.library.poses, mix, idle, skeleton, this.mixed);
    if (tracked !== undefined) putTracked(tracked, skeleton, this.mixed);
    turnHead(skeleton, this.mixed, vectorOf(turnOf(head)), trunkShare(tracked));
    const resting = this.resting as RestingBones;
    this.posed = poseFigure(skeleton, resting, this.mixed);
    writeBones(resting, this.posed, this.bones);
    writeCalls(skeleton, this.posed, this.calls);
    const bends = hingeBends(skeleton, this.posed.joints);
    this.wearLimbs(limbWeights(this.shared.space.limbFields, called, bends, idle[0]));
    this.changed = true;
  }

  /** What is to be drawn of it anew, where it or its head (`touched`) has changed. */
  job(head: WebGLTexture, touched: boolean): FigureJob | undefined {
    if (this.posed === undefined || !(this.changed || touched)) return undefined;
    this.changed = false;
    const bodies = this.worn.map(([name, weight]) => {
      return [this.pass.layerOf(name, this.bodies.get(name) as Body), weight] as const;
    });
    const { bones, bodyEdge, calls, target, limbFields, limbAxes, limbsFresh } = this;
    const limbs = this.limbWorn.size === 0 ? undefined : { fields: limbFields, fresh: limbsFresh, axes: limbAxes };
    this.limbsFresh = false;
    return { bones, bodies, bodyEdge, calls, limbs, head, target };
  }

  /** How the head is turned, about which joint as modelled, and where that is. */
  get head(): { turn: Rotation; pivot: Vector; place: Vector } {
    const { head } = this.place;
    return {
      turn: this.posed?.turns[head] ?? IDENTITY,
      pivot: this.resting?.joints[head] ?? ORIGIN,
      place: this.posed?.joints[head] ?? ORIGIN,
    };
  }

  /** Where its bones begin, metres, by their names; undefined while it is not here. */
  joint(name: string): Vector | undefined {
    return this.posed?.joints[placeOf(this.shared.skeleton, name)];
  }

  /** Its bones. */
  get skeleton(): Skeleton {
    return this.shared.skeleton;
  }

  /** A point that goes with a bone, `offset` metres from where it begins, in its pose; undefined while it is not here. */
  pointOf(bone: string, offset: Vector): Vector | undefined {
    return this.posed && this.pointAmong(this.posed, bone, offset);
  }

  /** As `pointOf`, in another pose. */
  pointIn(pose: MixedPose, bone: string, offset: Vector): Vector | undefined {
    return this.resting && this.pointAmong(poseFigure(this.skeleton, this.resting, pose), bone, offset);
  }

  private pointAmong({ joints, frames }: PosedBones, bone: string, offset: Vector): Vector {
    const place = placeOf(this.skeleton, bone);
    return plus(joints[place] as Vector, turnedBy(frames[place] as Rotation, offset));
  }

  /** As `joint`, while it stands. */
  standing(name: string): Vector | undefined {
    return this.resting?.standing[placeOf(this.shared.skeleton, name)];
  }

  /** The height of its soles while it stands, metres. */
  get soles(): number {
    const { resting, worn, lowest, bodies, place } = this;
    if (resting === undefined) return -1.5;
    const lift = worn.reduce((sum, [name, weight]) => {
      const body = bodies.get(name) as Body;
      return sum + weight * ((lowest.get(name) as number) - (body.joints[3 * place.foot + 1] as number));
    }, 0);
    return (resting.standing[place.foot] as Vector)[1] + lift;
  }

  /** By how much it is drawn larger than its person is. */
  get size(): number {
    const sum = this.worn.reduce((whole, [name, weight]) => whole + weight * (this.shared.bodies.get(name) ?? 1), 0);
    return this.worn.length === 0 ? 1 : sum;
  }

  /** Its rows, read back from the GPU. */
  readPositions(): Float32Array {
    return this.pass.readPositions(this.target);
  }

  dispose(): void {
    this.pass.drop(this.target);
  }

  /** Sums the limb fields that it wears from now on, where they are others. */
  private wearLimbs(worn: ReadonlyMap<string, number>): void {
    if (JSON.stringify([...worn]) === JSON.stringify([...this.limbWorn])) return;
    this.limbWorn = worn;
    this.limbsFresh = worn.size > 0;
    writeLimbFields(this.shared.space.limbFields, worn, this.limbFields);
  }

  private rest(worn: Parts<string>, carried: Parts<string>): void {
    const { space, skeleton } = this.shared;
    const bodies = worn.map(([name, weight]) => [this.bodies.get(name) as Body, weight] as const);
    const necks = carried.map(([source, weight]) => [this.necks.get(source) as NeckPlaces, weight] as const);
    this.worn = worn;
    this.resting = restingBones(space, skeleton, bodies, necks);
    for (let place = 0; place < space.edge.length; place++)
      this.bodyEdge.set(bodySum(bodies, "edge", place), 4 * place);
    writeLimbAxes(skeleton, this.resting.joints, this.limbAxes);
    this.poseKey = "";
  }

  private ask(key: string, read: () => Promise<void>): void {
    if (this.asked.has(key)) return;
    this.missing += 1;
    const came = read()
      .catch((error: unknown) => console.warn(String(error)))
      .finally(() => {
        this.missing -= 1;
      });
    this.asked.set(key, came);
  }
}

/** Those of a mix that are here, with weights that sum to one. */
function shown(mix: readonly (readonly [string, number])[], here: ReadonlyMap<string, unknown>): Parts<string> {
  const held = mix.filter(([name, weight]) => weight !== 0 && here.has(name));
  const sum = held.reduce((whole, [, weight]) => whole + weight, 0);
  return Math.abs(sum) < 1e-6 ? [] : held.map(([name, weight]) => [name, weight / sum] as const);
}

/** Writes bones as the shader reads them (`BONE_TEXELS`). */
function writeBones(resting: RestingBones, { turns, joints }: PosedBones, into: Float32Array): void {
  turns.forEach((turn, bone) => {
    const shift = minus(joints[bone] as Vector, turnedBy(turn, resting.joints[bone] as Vector));
    const [x, y, z, w] = quaternionOf(turn);
    const [a, b, c] = shift;
    into.set(
      [
        ...[turn[0], turn[1], turn[2], a, turn[3], turn[4], turn[5], b, turn[6], turn[7], turn[8], c],
        ...[x, y, z, w],
        ...[0.5 * (a * w + b * z - c * y), 0.5 * (b * w + c * x - a * z)],
        ...[0.5 * (c * w + a * y - b * x), 0.5 * (-a * x - b * y - c * z)],
      ],
      4 * BONE_TEXELS * bone,
    );
  });
}
