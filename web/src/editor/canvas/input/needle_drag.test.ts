import { beforeEach, describe, expect, it } from "vitest";
import type { Vector } from "../../session/control_net";
import { Camera, FIRST_VIEW } from "../math/camera";
import type { Pair } from "../math/vectors";
import type { DragOptions } from "../model/drag_vectors";
import { Figure } from "../model/figure";
import { patch, still } from "../model/skin_patch";
import { type DragContext, type DragStore, NeedleDrag, standing } from "./needle_drag";

const { positions, triangles, fans, net, tangents } = patch();
const REINS: DragOptions = { falloff: 0, mirror: false, mask: null };
const NO_PULLS = new Map<string, number>();
const view = (yaw = 0, pitch = 0) =>
  new Camera(
    { ...FIRST_VIEW, yaw, pitch },
    { left: 0, top: 0, width: 400, height: 400 },
    { centre: [0, 0, 0.09], radius: 0.06 },
  );

/** A store that remembers what it is told. */
class Told implements DragStore {
  live = still();
  readonly livePulls = NO_PULLS;
  gone: { points: readonly number[]; targets: readonly Vector[] } | undefined;
  cancelled = false;
  begun: readonly number[] = [];
  begin(points: readonly number[]): void {
    this.begun = points;
  }
  liveChanged(): void {}
  letGo(points: readonly number[], targets: readonly Vector[]): void {
    this.gone = { points, targets };
  }
  cancel(): void {
    this.cancelled = true;
  }
}

describe("NeedleDrag", () => {
  let store: Told;
  let context: DragContext;
  let camera: Camera;
  const take = (place: number, pointer: Pair, dragOptions: Partial<DragOptions> = {}) =>
    new NeedleDrag(store, context, place, [place], pointer, { ...REINS, ...dragOptions });
  const footOn = (place: number): Pair => {
    const [x, y] = camera.project(standing(context, NO_PULLS, place, store.live));
    return [x, y];
  };

  beforeEach(() => {
    store = new Told();
    camera = view();
    const figure = new Figure("round", positions, tangents);
    figure.worn = { source: "#1", moves: { vectors: still(), pulls: NO_PULLS }, net };
    context = { figure, net, fans, lips: null, land: triangles, camera: () => camera, muscles: [] };
  });

  it("keeps the needle as far from the pointer as it was taken, and on the surface", () => {
    const [x, y] = footOn(0);
    const needleDrag = take(0, [x + 3, y - 4]);
    for (const [dx, dy] of [
      [20, 0],
      [35, -30],
      [-12, 44],
    ] as Pair[]) {
      needleDrag.move([x + 3 + dx, y - 4 + dy], false);
      const [fx, fy] = footOn(0);
      expect(fx).toBeCloseTo(x + dx, 2);
      expect(fy).toBeCloseTo(y + dy, 2);
      const [px, , pz] = needleDrag.foot();
      expect(Math.hypot(px, pz)).toBeGreaterThan(0.0985);
      expect(Math.hypot(px, pz)).toBeLessThan(0.1005);
    }
  });

  it("stays where it last was when the pointer leaves the head", () => {
    const [x, y] = footOn(0);
    const needleDrag = take(0, [x, y]);
    needleDrag.move([x + 10, y], false);
    const before = footOn(0);
    needleDrag.move([-500, -500], false);
    expect(footOn(0)).toEqual(before);
  });

  it("pulls along the radius: by the pointer's way aside, by its height from the front", () => {
    camera = view(Math.PI / 4);
    const [x, y] = footOn(0);
    take(0, [x, y]).move([x - 30, y], true); // outwards, as one sees it from the left side
    expect(store.live[2]).toBeGreaterThan(1.01);
    expect([store.live[0], store.live[1]]).toEqual([0, 0].map((zero) => expect.closeTo(zero, 9)));
    store.live = still();
    camera = view();
    take(0, [x, y]).move([x, y - 20], true);
    expect(store.live[2]).toBeGreaterThan(1.01);
  });

  it("lets go of all it answers for where they are drawn", () => {
    const [x, y] = footOn(1);
    const needleDrag = take(1, [x, y], { mirror: true });
    expect(store.begun).toEqual([1, 2]);
    needleDrag.move([x + 9, y - 9], false);
    needleDrag.end();
    expect(store.gone?.points).toEqual([1, 2]);
    const [own, image] = (store.gone?.targets ?? []) as [Vector, Vector];
    expect(own).toEqual(standing(context, NO_PULLS, 1, store.live));
    expect(Math.hypot(own[0] + image[0], own[1] - image[1], own[2] - image[2])).toBeLessThan(1e-6);
  });

  it("was nothing when nothing moved", () => {
    take(0, footOn(0)).end();
    expect(store.cancelled).toBe(true);
    expect(store.gone).toBeUndefined();
  });

  it("goes on from what the server answered meanwhile", () => {
    const [x, y] = footOn(0);
    const needleDrag = take(0, [x, y]);
    needleDrag.move([x + 10, y], false);
    store.live = store.live.map((value, at) => (at === 9 ? value + 0.05 : value)); // an earlier drag, of point 3
    needleDrag.move([x + 12, y], false);
    expect(store.live[9]).toBeCloseTo(0.05, 12);
    expect(footOn(0)[0]).toBeCloseTo(x + 12, 2);
  });

  it("nudges by metres on the screen, and off the surface", () => {
    const needleDrag = take(0, [0, 0]);
    const before = needleDrag.foot();
    needleDrag.nudge(0.0005, 0, 0);
    expect(needleDrag.foot()[0] - before[0]).toBeCloseTo(0.0005, 5);
    const [bx, , bz] = needleDrag.foot();
    needleDrag.nudge(0, 0, 0.0005);
    const [x, , z] = needleDrag.foot();
    expect(Math.hypot(x, z) - Math.hypot(bx, bz)).toBeCloseTo(0.0005, 7);
  });
});
