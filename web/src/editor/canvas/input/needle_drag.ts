/** A hand that holds needles of the face under work, from the moment it takes them until it lets go. */

import type { Fans } from "../../../face/anatomy/topology";
import type { Muscle, Net, Vector } from "../../session/control_net";
import type { Camera } from "../math/camera";
import { hit } from "../math/hit_test";
import { add, dot, minus, type Pair, rowOf, size, type Triple, times, unit } from "../math/vectors";
import { answered, answeredPlaces, type DragGroup, type DragOptions, dragGroup, moved } from "../model/drag_vectors";
import type { Figure } from "../model/figure";
import type { Lips } from "../model/lip_coupling";

/** Where the hand reaches: the face, its camera, and what a pointer lands on. */
export interface DragContext {
  figure: Figure;
  net: Net;
  fans: Fans;
  lips: Lips | null;
  land: Uint32Array;
  camera: () => Camera;
  muscles: readonly Muscle[];
}

/** What of the store a hand moves. */
export interface DragStore {
  live: Float64Array;
  readonly livePulls: ReadonlyMap<string, number>;
  begin(points: readonly number[]): void;
  liveChanged(): void;
  letGo(points: readonly number[], targets: readonly Vector[]): void;
  cancel(): void;
}

/** The farthest that a foot may lie under what the pointer lands on and still be dragged at that depth, metres. */
const DEPTH = 0.005;
/** Below this share of a metre's length on the screen an axis points at the camera, and the pointer's height counts. */
const END_ON = 0.35;

/** Where a needle's foot is on the face when the net has these vectors (linearised, like all that is drawn). */
export function standing(
  { figure, net, muscles }: Pick<DragContext, "figure" | "net" | "muscles">,
  pulls: ReadonlyMap<string, number>,
  place: number,
  vectors: Float64Array,
): Triple {
  const row = net.rows[place] as number;
  const foot = rowOf(figure.base, row);
  const { moves } = figure.worn;
  const answer = figure.answer(row);
  if (moves === undefined || answer === undefined || figure.worn.net !== net) return foot;
  const field = minus(rowOf(vectors, place), rowOf(moves.vectors, place));
  for (const muscle of muscles) {
    const more = (pulls.get(muscle.name) ?? 0) - (moves.pulls.get(muscle.name) ?? 0);
    const pulled = rowOf(muscle.field, row);
    for (const axis of [0, 1, 2] as const) field[axis] += more * pulled[axis];
  }
  return answer.reduce((sum, tangent, axis) => add(sum, times(tangent, field[axis] as number)), foot);
}

export class NeedleDrag {
  readonly dragGroup: DragGroup;
  /** Whether anything has moved. */
  used = false;
  private before: Float64Array;
  private written: Float64Array;
  private surface: Float32Array;
  private origin: Pair;
  private depth = 0;
  private pulling = false;
  private target: Triple;

  /** Takes `led` by the needle of `grabbed`, at a pointer's place on the canvas. */
  constructor(
    private readonly store: DragStore,
    private readonly context: DragContext,
    private readonly grabbed: number,
    led: readonly number[],
    pointer: Pair,
    dragOptions: DragOptions,
  ) {
    const { net, figure, fans, lips } = context;
    this.dragGroup = dragGroup(net, led, dragOptions, { fans, lips, positions: figure.live });
    store.begin(answeredPlaces(this.dragGroup));
    [this.before, this.written] = [store.live.slice(), store.live.slice()];
    this.surface = figure.live.slice();
    this.target = this.foot();
    this.origin = pointer;
    this.restart(pointer);
  }

  /** The pointer is here now; `pull`: off the surface. */
  move(pointer: Pair, pull: boolean): void {
    this.catchUp();
    if (pull !== this.pulling) {
      this.pulling = pull;
      if (this.used) this.restart(pointer); // else it begins where it was taken
    }
    this.put(pull ? this.offSurface(pointer) : this.onSurface(pointer));
  }

  /** Moves by metres: to the right and up on the screen along the surface, and off it. */
  nudge(right: number, up: number, off: number): void {
    this.catchUp();
    const camera = this.context.camera();
    const from = this.foot();
    const [x, y] = camera.project(from);
    const metresPerPixel = camera.metresPerPixel(from);
    if (off !== 0) this.put(add(from, times(this.axis(), off)));
    else {
      this.origin = [x, y];
      this.restart(this.origin);
      this.put(this.onSurface([x + right / metresPerPixel, y - up / metresPerPixel]));
    }
  }

  /** Lets go; the server solves it so that the points lie where they are drawn. */
  end(): void {
    this.catchUp();
    if (!this.used) {
      this.store.cancel();
      return;
    }
    const places = answeredPlaces(this.dragGroup);
    this.store.letGo(
      places,
      places.map((place) => this.where(place, this.store.live)),
    );
  }

  cancel(): void {
    this.store.cancel();
  }

  /** Where the grabbed needle's foot is drawn, metres. */
  foot(): Triple {
    return this.where(this.grabbed, this.store.live);
  }

  private where(place: number, vectors: Float64Array): Triple {
    return standing(this.context, this.store.livePulls, place, vectors);
  }

  /** The server answered an earlier drag while this one goes on: what was before the hand has moved with it. */
  private catchUp(): void {
    const { live } = this.store;
    if (live.length !== this.written.length) return;
    this.before = this.before.map((value, at) => value + (live[at] as number) - (this.written[at] as number));
    this.written = live.slice();
  }

  /** Begins again from where everything is. */
  private restart(pointer: Pair): void {
    this.before = this.store.live.slice();
    this.origin = pointer;
    this.target = this.foot();
    const camera = this.context.camera();
    const [x, y] = camera.project(this.target);
    const ray = camera.ray(x, y);
    const met = hit(this.surface, this.context.land, camera.eye, ray);
    const deeper = met === undefined ? 0 : dot(minus(this.target, met.point), ray);
    this.depth = Math.abs(deeper) < DEPTH ? deeper : 0;
    this.grasp = [x - pointer[0], y - pointer[1]];
  }

  /** From the pointer to the foot, CSS pixels: the needle keeps this distance from the pointer. */
  private grasp: Pair = [0, 0];

  private onSurface([x, y]: Pair): Triple {
    const camera = this.context.camera();
    const ray = camera.ray(x + this.grasp[0], y + this.grasp[1]);
    const met = hit(this.surface, this.context.land, camera.eye, ray);
    return met === undefined ? this.target : add(met.point, times(ray, this.depth));
  }

  private offSurface([x, y]: Pair): Triple {
    const camera = this.context.camera();
    const from = this.where(this.grabbed, this.before);
    const axis = this.axis();
    const [ax, ay] = camera.project(from);
    const [bx, by] = camera.project(add(from, times(axis, 0.001)));
    const [ex, ey] = [1000 * (bx - ax), 1000 * (by - ay)]; // pixels a metre
    const [dx, dy] = [x - this.origin[0], y - this.origin[1]];
    const metresPerPixel = camera.metresPerPixel(from);
    const along =
      Math.hypot(ex, ey) * metresPerPixel > END_ON ? (dx * ex + dy * ey) / (ex * ex + ey * ey) : -dy * metresPerPixel;
    return add(from, times(axis, along));
  }

  /** The direction in which R grows at the grabbed point. */
  private axis(): Triple {
    const answer = this.context.figure.answer(this.context.net.rows[this.grabbed] as number);
    return answer === undefined || size(answer[2]) === 0 ? this.context.camera().back : unit(answer[2]);
  }

  /** Moves everything so that the grabbed foot lies at a target. */
  private put(target: Triple): void {
    const { store, context } = this;
    const row = context.net.rows[this.grabbed] as number;
    const move = answered(context.figure.answer(row), this.where(this.grabbed, this.before), target);
    if (move === undefined) return;
    this.target = target;
    store.live.set(moved(this.before, this.dragGroup, move));
    this.written = store.live.slice();
    this.used = true;
    store.liveChanged();
  }
}
