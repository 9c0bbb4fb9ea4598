/** Mouse, touch, pen and keys on the canvas: from events to drags, selections and views. */

import { ownerOf } from "../../../ui/key_presses";
import type { Pair } from "../math/vectors";
import type { Needle } from "../model/needles";
import { withoutPlace } from "../model/net_edits";
import type { FaceScene } from "../scene/face_scene";
import type { FramePacing } from "../scene/frame_pacing";
import { CameraControl } from "./camera_control";
import type { NeedleDrag } from "./needle_drag";
import { NeedlePicker, type NeedlePlacing, type PickerCanvas } from "./needle_picker";
import { nudgeOf, stepOf } from "./nudge_keys";

/** Pixels that a pointer may tremble before a press becomes a drag. */
const TREMBLE = { mouse: 3, touch: 8 } as const;

type Press =
  | { kind: "needle"; needle: Needle; fresh: boolean }
  | { kind: "ground" | "beside"; over: number }
  | { kind: "orbit" | "pan" | "band" | "handle" };

/** What mouse, touch, pen and keys act on. */
export interface InputCanvas extends PickerCanvas {
  readonly canvas: HTMLCanvasElement;
  readonly pacing: FramePacing;
  readonly faceScene: FaceScene | undefined;
  redraw(): void;
}

export class CanvasInput {
  /** The place of the needle under the pointer, and the face (0: the work); -1: none. */
  hovered = -1;
  over = -1;
  needleDrag: NeedleDrag | undefined;
  placing: NeedlePlacing | undefined;
  /** The corners of the rubber band, CSS pixels. */
  band: [number, number, number, number] | undefined;
  readonly picker: NeedlePicker;
  /** Where the pointers are that are held down, by their ids. */
  readonly pointers = new Map<number, Pair>();
  private press: { what: Press; from: Pair; last: Pair; moved: boolean } | undefined;
  private readonly cameraControl: CameraControl;
  private nudging = false;
  private readonly ending = new AbortController();

  constructor(private readonly stage: InputCanvas) {
    const { canvas } = stage;
    this.cameraControl = new CameraControl(stage);
    this.picker = new NeedlePicker(stage, this.cameraControl);
    const options = { signal: this.ending.signal };
    canvas.style.touchAction = "none";
    canvas.tabIndex = 0;
    canvas.addEventListener("pointerdown", (event) => this.down(event), options);
    canvas.addEventListener("pointermove", (event) => this.move(event), options);
    canvas.addEventListener("pointerup", (event) => this.up(event), options);
    canvas.addEventListener("pointercancel", (event) => this.lose(event), options);
    canvas.addEventListener("pointerleave", () => this.hover(-1, -1), options);
    canvas.addEventListener("contextmenu", (event) => event.preventDefault(), options);
    canvas.addEventListener("dblclick", (event) => this.doubled(event), options);
    canvas.addEventListener("wheel", (event) => this.cameraControl.wheel(event), { ...options, passive: false });
    addEventListener("keydown", (event) => this.key(event), options);
    addEventListener("keyup", () => this.endNudge(), options);
    addEventListener("blur", () => this.endNudge(), options);
  }

  dispose(): void {
    this.ending.abort();
  }

  // --- pointers -------------------------------------------------------------------------------------------------------

  private down(event: PointerEvent): void {
    const at = placeOf(event);
    const { canvas, viewports } = this.stage;
    canvas.focus({ preventScroll: true });
    canvas.setPointerCapture(event.pointerId);
    this.pointers.set(event.pointerId, at);
    this.endNudge();
    if (this.pointers.size > 1) {
      this.abandon();
      this.cameraControl.pinch([...this.pointers.values()]);
      return;
    }
    const over = viewports.at(...at);
    this.press = { what: this.pressed(event, at, over), from: at, last: at, moved: false };
  }

  private pressed(event: PointerEvent, at: Pair, over: number): Press {
    if (event.button === 1) return { kind: "pan" };
    if (over > 0) return { kind: "beside", over };
    if (this.stage.editsFace && this.stage.handles?.press(at, event)) return { kind: "handle" };
    const takes = (event.button === 0 || event.pointerType === "pen") && !this.stage.editsFace;
    const needle = takes ? this.picker.pick(event, at) : undefined;
    if (needle !== undefined) return { kind: "needle", needle, fresh: this.choose(needle.place, event) };
    if (event.button === 2) return { kind: "orbit" };
    return event.shiftKey ? { kind: "band" } : { kind: "ground", over };
  }

  /** Selects the needle that is pressed; whether it was new to the selection. */
  private choose(place: number, event: PointerEvent): boolean {
    const { store } = this.stage;
    const fresh = !store.selection.has(place);
    if (event.shiftKey || event.ctrlKey || event.metaKey) store.select([...store.selection, place]);
    else if (fresh) store.select([place]);
    return fresh;
  }

  private move(event: PointerEvent): void {
    const at = placeOf(event);
    if (!this.pointers.has(event.pointerId)) {
      this.hoverAt(event, at);
      return;
    }
    this.pointers.set(event.pointerId, at);
    if (this.cameraControl.pinching) {
      this.cameraControl.pinch([...this.pointers.values()]);
      return;
    }
    const { press } = this;
    if (press === undefined) return;
    const far = Math.hypot(at[0] - press.from[0], at[1] - press.from[1]);
    if (!press.moved && far < TREMBLE[event.pointerType === "touch" ? "touch" : "mouse"]) return;
    if (!press.moved) this.beginDrag(press.what, press.from);
    press.moved = true;
    this.drag(press.what, event, press.last, at);
    press.last = at;
  }

  private beginDrag(what: Press, from: Pair): void {
    if (what.kind !== "needle") return;
    this.stage.redraw(); // needles that are taken look otherwise
    const { tool } = this.stage.store.options;
    if (tool === "place") this.placing = { place: what.needle.place, row: this.picker.rowOf(what.needle.place) };
    else if (tool === "drag" || tool === "pull") this.needleDrag = this.picker.grab(what.needle.place, from);
  }

  private drag(what: Press, event: PointerEvent, from: Pair, to: Pair): void {
    const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    if (what.kind === "needle") this.dragNeedle(event, to);
    else if (what.kind === "handle") this.dragHandle(event, to);
    else if (what.kind === "band") this.stretch(to);
    else if (what.kind === "pan") this.cameraControl.pan(dx, dy);
    else this.cameraControl.orbit(dx, dy);
    if (what.kind !== "needle" || this.placing !== undefined) this.stage.redraw(); // else only what the hand leads
  }

  private dragNeedle(event: PointerEvent, to: Pair): void {
    if (this.placing !== undefined) {
      const row = this.picker.rowUnder(to);
      if (row !== undefined) this.placing = { ...this.placing, row };
      return;
    }
    if (this.needleDrag === undefined) return;
    if (!this.stage.store.dragging) {
      this.dropGrip();
      return;
    } // the net changed under the hand
    this.stage.pacing.moved(event.timeStamp);
    this.needleDrag.move(to, this.pulls(event));
  }

  private dragHandle(event: PointerEvent, to: Pair): void {
    this.stage.pacing.moved(event.timeStamp);
    this.stage.handles?.drag(to, event);
  }

  private pulls(event: PointerEvent): boolean {
    const barrel = event.pointerType === "pen" && (event.buttons & 2) !== 0;
    return (this.stage.store.options.tool === "pull") !== (event.altKey || barrel);
  }

  private up(event: PointerEvent): void {
    const { press } = this;
    this.pointers.delete(event.pointerId);
    if (this.cameraControl.pinching) {
      if (this.pointers.size < 2) this.cameraControl.release();
      return;
    }
    this.press = undefined;
    if (press === undefined) return;
    if (press.moved) this.endDrag(press.what);
    else this.click(press.what, press.from, event);
    this.stage.redraw();
  }

  private endDrag(what: Press): void {
    const { store } = this.stage;
    if (this.band !== undefined) this.picker.selectWithin(this.band);
    this.band = undefined;
    if (what.kind === "handle") this.stage.handles?.release();
    if (this.placing !== undefined) this.picker.setDown(this.placing);
    this.placing = undefined;
    if (store.dragging) this.needleDrag?.end();
    this.dropGrip();
  }

  private click(what: Press, at: Pair, event: PointerEvent): void {
    const { store } = this.stage;
    const { tool } = store.options;
    if (what.kind === "handle") this.stage.handles?.release();
    else if (what.kind === "beside" && this.stage.editsFace) this.stage.faceScene?.front(what.over);
    else if (what.kind === "beside") store.setWork(store.neighbours[what.over - 1] as string);
    else if (what.kind === "needle" && tool === "remove")
      this.picker.reweave((net) => withoutPlace(net, what.needle.place));
    else if (what.kind === "needle" && (event.shiftKey || event.ctrlKey || event.metaKey) && !what.fresh)
      store.select([...store.selection].filter((place) => place !== what.needle.place));
    else if (what.kind === "needle" && !event.shiftKey && !event.ctrlKey && !event.metaKey)
      store.select([what.needle.place]);
    else if (what.kind === "ground" && tool === "add" && !this.stage.editsFace) this.picker.add(at);
    else if (what.kind === "ground") store.select([]);
  }

  /** The system took the pointer: nothing was meant. */
  private lose(event: PointerEvent): void {
    this.pointers.delete(event.pointerId);
    this.cameraControl.release();
    this.abandon();
  }

  /** What was under way is as if it had not been. */
  private abandon(): void {
    this.needleDrag?.cancel();
    this.stage.handles?.cancel();
    this.dropGrip();
    [this.placing, this.band, this.press, this.nudging] = [undefined, undefined, undefined, false];
    this.stage.redraw();
  }

  private dropGrip(): void {
    this.needleDrag = undefined;
    this.stage.redraw();
  }

  private doubled(event: MouseEvent): void {
    const at = placeOf(event);
    if (this.stage.viewports.at(...at) !== 0 || this.picker.pick(event, at) !== undefined) return;
    this.cameraControl.reset();
  }

  private hoverAt(event: PointerEvent, at: Pair): void {
    const over = this.stage.viewports.at(...at);
    const needle = over === 0 ? this.picker.pick(event, at) : undefined;
    if (this.stage.handles !== undefined) this.stage.handles.hovered = needle?.place ?? -1;
    this.hover(over, needle?.place ?? -1);
  }

  private hover(over: number, place: number): void {
    if (over === this.over && place === this.hovered) return;
    [this.over, this.hovered] = [over, place];
    this.stage.canvas.style.cursor = over > 0 ? "pointer" : place >= 0 ? "grab" : "default";
    this.stage.redraw();
  }

  // --- needles --------------------------------------------------------------------------------------------------------

  private stretch(to: Pair): void {
    const from = this.press?.from ?? to;
    this.band = [
      Math.min(from[0], to[0]),
      Math.min(from[1], to[1]),
      Math.max(from[0], to[0]),
      Math.max(from[1], to[1]),
    ];
  }

  private key(event: KeyboardEvent): void {
    const { canvas, pacing } = this.stage;
    if (ownerOf(event) !== "page") return;
    if (event.key === "Escape") this.abandon();
    const focused = (canvas.getRootNode() as Document | ShadowRoot).activeElement === canvas;
    if (!focused || event.ctrlKey || event.metaKey) return;
    const [by, step] = [stepOf(event), nudgeOf(event)];
    if (by !== undefined) this.picker.step(by);
    if (step === undefined) return;
    if (this.stage.editsFace ? !this.stage.handles?.nudge(...step) : !this.beginNudge()) return;
    event.preventDefault();
    pacing.moved(event.timeStamp);
    this.needleDrag?.nudge(...step);
  }

  private beginNudge(): boolean {
    const first = [...this.stage.store.selection][0];
    if (this.needleDrag === undefined && first !== undefined) {
      this.needleDrag = this.picker.grab(first, [0, 0]);
      this.nudging = this.needleDrag !== undefined;
    }
    return this.nudging;
  }

  private endNudge(): void {
    this.stage.handles?.endNudge();
    if (!this.nudging) return;
    this.nudging = false;
    if (this.stage.store.dragging) this.needleDrag?.end();
    this.dropGrip();
  }
}

const placeOf = (event: MouseEvent): Pair => [event.offsetX, event.offsetY];
