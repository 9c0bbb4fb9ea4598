/** The needles of the face under work: which one a pointer means, what skin lies under it, and edits of the net. */

import type { Anatomy } from "../../../face/anatomy/anatomy";
import type { Net } from "../../session/control_net";
import type { DraftStore } from "../../session/draft_store";
import type { ShownFace } from "../draw/drawn_face";
import type { Camera } from "../math/camera";
import { hit } from "../math/hit_test";
import { dot, type Pair, type Triple } from "../math/vectors";
import type { Figure } from "../model/figure";
import { lipsOf } from "../model/lip_coupling";
import { NEEDLE, type Needle, needlesOn, picked, REACH, within } from "../model/needles";
import { freeRow, withPlaceAt, withRow } from "../model/net_edits";
import type { Viewports } from "../scene/viewports";
import type { CameraControl } from "./camera_control";
import type { HandleDrag } from "./handle_drag";
import { type DragContext, NeedleDrag } from "./needle_drag";
import { nextPlace } from "./nudge_keys";

/** What the picker reads of the canvas. */
export interface PickerCanvas {
  readonly store: DraftStore;
  readonly viewports: Viewports;
  /** Whether a face is under work, with handles in place of needles. */
  readonly editsFace: boolean;
  readonly handles: HandleDrag | undefined;
  readonly work: Pick<ShownFace, "figure" | "bounds"> | undefined;
}

/** A needle that is being set down somewhere else on the skin. */
export interface NeedlePlacing {
  place: number;
  row: number;
}

export class NeedlePicker {
  private anatomy: Anatomy | undefined;
  private surface: { skin: Uint32Array; land: Uint32Array } | undefined;

  constructor(
    private readonly stage: PickerCanvas,
    private readonly cameraControl: CameraControl,
  ) {}

  know(anatomy: Anatomy, surface: { skin: Uint32Array; land: Uint32Array }): void {
    [this.anatomy, this.surface] = [anatomy, surface];
  }

  /** The needles of the face under work, where they can be taken; none while there is nothing to take. */
  needles(): Needle[] {
    const { store, handles } = this.stage;
    if (this.stage.editsFace) return handles?.studs() ?? [];
    const figure = this.figure;
    const shown = store.recipe !== null && store.look === null && store.options.needles;
    if (figure === undefined || this.anatomy === undefined || store.net === null || !shown) return [];
    return needlesOn(store.net.rows, this.anatomy.fans, figure.live, this.needleLength);
  }

  /** Where the needles point. */
  directions(): Triple[] {
    return this.needles().map(({ outward }) => outward);
  }

  /** Whether needles are shown. */
  get armed(): boolean {
    const { recipe, look, options } = this.stage.store;
    return recipe !== null && look === null && options.needles;
  }

  /** Metres; shorter when one looks from near, so that they do not hide what they move. */
  get needleLength(): number {
    return NEEDLE / Math.max(1, this.stage.viewports.view.zoom ** 0.75);
  }

  private get figure(): Figure | undefined {
    return this.stage.work?.figure;
  }

  /** The camera of the work. */
  camera(): Camera | undefined {
    return this.cameraControl.camera;
  }

  pick(event: MouseEvent, at: Pair): Needle | undefined {
    const [camera, figure, surface] = [this.camera(), this.figure, this.surface];
    if (camera === undefined || figure === undefined || surface === undefined) return undefined;
    const touch = event instanceof PointerEvent && event.pointerType === "touch";
    const skin = { positions: figure.live, triangles: surface.skin };
    return picked(this.needles(), camera, skin, at, touch ? REACH.touch : REACH.mouse);
  }

  /** Selects the next needle or handle that points this way, from the crown down, or the one before. */
  step(by: -1 | 1): void {
    const { store } = this.stage;
    const back = this.camera()?.back ?? [0, 0, 1];
    const seen = this.needles().filter(({ outward }) => dot(outward, back) > 0);
    const place = nextPlace(seen, [...store.selection].at(-1), by);
    if (place !== undefined && !store.dragging) store.select([place]);
  }

  /** Takes a needle, with all that is selected if it is; undefined where nothing may move. */
  grab(place: number, from: Pair): NeedleDrag | undefined {
    const context = this.groundOf();
    if (context === undefined) return undefined;
    const { store } = this.stage;
    const { falloff, mirror, region } = store.options;
    const mask = region === null ? null : (store.masks[store.regions.indexOf(region)] ?? null);
    const led = store.selection.has(place) ? [...store.selection] : [place];
    const needleDrag = new NeedleDrag(store, context, place, led, from, { falloff, mirror, mask });
    if (needleDrag.dragGroup.led.includes(place)) return needleDrag;
    needleDrag.cancel(); // the region does not move it
    return undefined;
  }

  private groundOf(): DragContext | undefined {
    const { figure, anatomy, surface } = this;
    const { net, muscles } = this.stage.store;
    if (figure?.tangents === undefined || anatomy === undefined || surface === undefined || net === null)
      return undefined;
    const camera = () => this.camera() as Camera;
    const { fans } = anatomy;
    return { figure, net, fans, lips: lipsOf(anatomy), land: surface.land, camera, muscles };
  }

  /** Adds the needles inside a rubber band to the selection. */
  selectWithin(band: readonly [number, number, number, number]): void {
    const [camera, figure, surface, { store }] = [this.camera(), this.figure, this.surface, this.stage];
    if (camera === undefined || figure === undefined || surface === undefined) return;
    const skin = { positions: figure.live, triangles: surface.skin };
    store.select([...store.selection, ...within(this.needles(), camera, skin, band)]);
  }

  /** The row under a place of the net, or under a handle. */
  rowOf(place: number): number {
    const { store, handles, editsFace } = this.stage;
    return (editsFace ? handles?.handles?.rows[place] : store.net?.rows[place]) ?? -1;
  }

  reweave(rows: (net: Net) => readonly number[]): void {
    const { store } = this.stage;
    if (store.net !== null) store.setNet(rows(store.net));
  }

  add(at: Pair): void {
    const row = this.rowUnder(at);
    if (row !== undefined) this.reweave((net) => withRow(net, row));
  }

  setDown({ place, row }: NeedlePlacing): void {
    if (this.rowOf(place) !== row) this.reweave((net) => withPlaceAt(net, place, row));
  }

  /** The vertex of the sheet under the pointer where no needle stands yet. */
  rowUnder([x, y]: Pair): number | undefined {
    const [camera, figure, { net }] = [this.camera(), this.figure, this.stage.store];
    if (camera === undefined || figure === undefined || this.surface === undefined || net === null) return undefined;
    const met = hit(figure.live, this.surface.skin, camera.eye, camera.ray(x, y));
    return met === undefined ? undefined : freeRow(net, met, figure.live);
  }
}
