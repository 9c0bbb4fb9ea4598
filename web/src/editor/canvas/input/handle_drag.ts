/** Hands on the handles of a face: which one a pointer means, and where it takes it. */

import type { Fans } from "../../../face/anatomy/topology";
import { flat } from "../../session/control_net";
import type { DraftStore } from "../../session/draft_store";
import { type Handles, movedBy, namesOf, withMoves } from "../../session/face_handles";
import type { NeedleState } from "../draw/overlay_meshes";
import type { Camera } from "../math/camera";
import { add, type Pair, type Triple, times } from "../math/vectors";
import { type Needle, needlesOn, picked, REACH, STUD } from "../model/needles";
import type { FaceScene } from "../scene/face_scene";

/** What hands must know of the canvas. */
export interface HandleDragContext {
  readonly store: DraftStore;
  readonly faceScene: FaceScene;
  readonly fans: Fans;
  readonly skin: Uint32Array;
  camera(): Camera | undefined;
  redraw(): void;
}

interface Hold {
  places: readonly number[];
  /** Where the pointer was last, whether it went along the view then, and the moves at that time. */
  from: Pair;
  along: boolean;
  moves: Float64Array;
  foot: Triple;
  used: boolean;
  /** The moves when the hand took hold. */
  first: Float64Array;
}

export class HandleDrag {
  hovered = -1;
  private hold: Hold | undefined;
  private nudged: readonly number[] | undefined;
  /** The moves as the hand has them now; undefined: as the recipe has them. */
  private now: Float64Array | undefined;

  constructor(private readonly place: HandleDragContext) {}

  get dragging(): boolean {
    return this.hold !== undefined;
  }

  /** The handles that can be taken now. */
  get handles(): Handles | undefined {
    const { store, faceScene } = this.place;
    return store.look === null && store.options.needles ? faceScene.handles : undefined;
  }

  /** Handles as they stand on the face at the front. */
  studs(): Needle[] {
    const { faceScene, fans } = this.place;
    const figure = faceScene.all[0]?.figure;
    return figure === undefined || this.handles === undefined
      ? []
      : needlesOn(this.handles.rows, fans, figure.base, STUD);
  }

  states(): NeedleState[] {
    const { selection, options } = this.place.store;
    const { handles, hold } = this;
    const images = new Set(options.mirror ? [...selection].map((place) => handles?.mirror[place]) : []);
    return (handles?.rows ?? []).map((_, place): NeedleState => {
      if (selection.has(place)) return "selected";
      if (hold !== undefined && images.has(place)) return "taken";
      return place === this.hovered ? "hovered" : "still";
    });
  }

  /** A pointer goes down; whether it took a handle. */
  press(at: Pair, event: PointerEvent): boolean {
    const stud = event.button === 0 ? this.pick(at, event.pointerType === "touch") : undefined;
    if (stud === undefined) return false;
    const { store } = this.place;
    const more = event.shiftKey || event.ctrlKey || event.metaKey;
    if (more) store.select([...store.selection, stud.place]);
    else if (!store.selection.has(stud.place)) store.select([stud.place]);
    this.take([...store.selection], stud.foot, at, event.altKey);
    return true;
  }

  drag(at: Pair, event: PointerEvent): void {
    const { hold } = this;
    const camera = this.place.camera();
    if (hold === undefined || camera === undefined) return;
    if (hold.along !== event.altKey) Object.assign(hold, { from: at, along: event.altKey, moves: this.moves });
    this.put(hold, strokeOf(camera, hold.foot, hold.from, at, hold.along));
  }

  release(_event?: PointerEvent): void {
    const { hold, handles } = this;
    this.hold = undefined;
    if (hold?.used && handles !== undefined) this.send(handles, hold.places);
    this.place.redraw();
  }

  /** The hand never meant it. */
  cancel(): void {
    const { hold } = this;
    this.hold = undefined;
    if (hold === undefined) return;
    this.show(hold.first);
  }

  /** Moves what is chosen by metres on the screen (right, up) or along the view (towards), until `endNudge`. */
  nudge(right: number, up: number, towards: number): boolean {
    const { store } = this.place;
    const [camera, handles] = [this.place.camera(), this.handles];
    const places = [...store.selection].filter((place) => place < (handles?.rows.length ?? 0));
    if (camera === undefined || handles === undefined || places.length === 0) return false;
    const by = add(add(times(camera.right, right), times(camera.up, up)), times(camera.back, towards));
    this.show(movedBy(this.moves, handles, places, by, store.options.mirror));
    this.nudged = places;
    return true;
  }

  /** The key is up: the server is asked. */
  endNudge(): void {
    const { nudged, handles } = this;
    this.nudged = undefined;
    if (nudged !== undefined && handles !== undefined) this.send(handles, nudged);
  }

  /** What is chosen goes back to where the mix of faces has it. */
  reset(): void {
    const { store } = this.place;
    const { handles } = this;
    if (handles === undefined || store.selection.size === 0) return;
    const chosen = new Set(
      [...store.selection].flatMap((place) => (store.options.mirror ? [place, handles.mirror[place] ?? -1] : [place])),
    );
    this.show(this.moves.map((move, at) => (chosen.has(Math.floor(at / 3)) ? 0 : move)));
    this.send(handles, [...store.selection], "back at rest");
  }

  /** Whether the hand is ahead of what the server has answered. */
  get ahead(): boolean {
    return this.hold !== undefined || this.nudged !== undefined || this.place.store.waiting;
  }

  /** The server has answered, or refused: the hand begins from what it has now, unless it is ahead. */
  takeAnswer(): void {
    if (this.ahead || this.now === undefined) return;
    this.now = undefined;
    this.place.faceScene.move(this.moves);
    this.place.redraw();
  }

  private get moves(): Float64Array {
    const { store, faceScene } = this.place;
    if (this.now !== undefined) return this.now;
    const moves = store.face === null ? [] : flat(store.face.moves);
    return moves.length === 3 * (faceScene.handles?.rows.length ?? 0)
      ? Float64Array.from(moves)
      : new Float64Array(3 * (faceScene.handles?.rows.length ?? 0));
  }

  private take(places: readonly number[], foot: Triple, from: Pair, along: boolean): void {
    const moves = this.moves;
    this.hold = { places, foot, from, along, moves, used: false, first: moves };
  }

  private put(hold: Hold, by: Triple): void {
    const { handles } = this;
    if (handles === undefined) return;
    hold.used = true;
    this.show(movedBy(hold.moves, handles, hold.places, by, this.place.store.options.mirror));
  }

  private show(moves: Float64Array): void {
    this.now = moves;
    this.place.faceScene.move(moves);
    this.place.redraw();
  }

  private send(handles: Handles, places: readonly number[], what = "moved"): void {
    const moves = this.moves.slice();
    this.place.store.setFace((face) => withMoves(face, handles, moves), `${namesOf(handles, places)} ${what}`);
  }

  private pick(at: Pair, touch: boolean): Needle | undefined {
    const { faceScene, skin } = this.place;
    const [camera, figure] = [this.place.camera(), faceScene.all[0]?.figure];
    if (camera === undefined || figure === undefined) return undefined;
    return picked(
      this.studs(),
      camera,
      { positions: figure.base, triangles: skin },
      at,
      touch ? REACH.touch : REACH.mouse,
    );
  }
}

/** Metres by which a pointer that goes from one place of the canvas to another moves what lies at `point`: in the plane
 * of the screen, or along the view (down: nearer). */
export function strokeOf(camera: Camera, point: Readonly<Triple>, from: Pair, to: Pair, along: boolean): Triple {
  const metresPerPixel = camera.metresPerPixel(point);
  const [right, down] = [(to[0] - from[0]) * metresPerPixel, (to[1] - from[1]) * metresPerPixel];
  return along ? times(camera.back, down) : add(times(camera.right, right), times(camera.up, -down));
}
