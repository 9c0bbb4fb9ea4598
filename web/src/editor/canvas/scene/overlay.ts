/** What lies over the faces: needles, the mesh's edges, muscles; and, as elements of the page, names and the rubber band. */

import * as THREE from "three";
import { rowTriangles } from "../../../face/anatomy/topology";
import type { DraftStore } from "../../session/draft_store";
import { type Handles, namesOf } from "../../session/face_handles";
import { showsMuscles } from "../../session/view_settings";
import type { DrawnFace, ShownFace } from "../draw/drawn_face";
import { HEAD, NeedleMesh, type NeedleState, skinLines, type UnderUniforms } from "../draw/overlay_meshes";
import type { Box } from "../math/boxes";
import type { Camera } from "../math/camera";
import type { Triple } from "../math/vectors";
import type { DragGroup } from "../model/drag_vectors";
import { type Needle, STUD, spacing } from "../model/needles";
import type { Viewports } from "./viewports";

const EDGE = [1, 1, 1, 0.16];
const MUSCLE = [0.93, 0.36, 0.3, 0.9];
const SLACK = [0.93, 0.5, 0.42, 0.45];
/** The smallest a needle's head becomes. */
const LEAST = 0.42;
/** Metres that lines lie off the skin. */
const EDGE_LIFT = 0.0002;
const MUSCLE_LIFT = 0.0012;

/** What the overlay reads of the canvas. */
export interface OverlaidCanvas {
  readonly canvas: HTMLCanvasElement;
  readonly store: DraftStore;
  readonly viewports: Pick<Viewports, "ratio">;
  readonly work: Pick<ShownFace, "figure"> | undefined;
  readonly editsFace: boolean;
  readonly input: ShownNeedles;
  readonly handles: ShownHandles | undefined;
}

/** The needles of an expression, and what the hand does to them. */
interface ShownNeedles {
  readonly picker: { readonly armed: boolean; readonly needleLength: number; directions(): Triple[] };
  readonly hovered: number;
  readonly placing: { readonly place: number; readonly row: number } | undefined;
  readonly band: readonly [number, number, number, number] | undefined;
  readonly needleDrag: { readonly dragGroup: DragGroup } | undefined;
}

/** The handles of a face. */
interface ShownHandles {
  readonly hovered: number;
  readonly handles: Handles | undefined;
  studs(): Needle[];
  states(): NeedleState[];
}

export class Overlay {
  private readonly layer: HTMLElement;
  private readonly names: HTMLElement[] = [];
  private readonly rubber: HTMLElement;
  /** The name of the handle under the pointer. */
  private readonly tip: HTMLElement;
  /** All that is drawn over the face under work. */
  readonly object = new THREE.Group();
  private readonly under: UnderUniforms = {
    positions: { value: new THREE.Texture() },
    normals: { value: new THREE.Texture() },
  };
  private readonly needles = new NeedleMesh(this.under);
  private wires: THREE.LineSegments | undefined;
  private muscles: THREE.LineSegments | undefined;
  private pulled = "";
  private placed = "";
  private spaced: { rows: readonly number[]; far: number[] } | undefined;

  constructor(private readonly stage: OverlaidCanvas) {
    const { canvas } = stage;
    this.object.renderOrder = 1; // after the face
    this.object.add(this.needles.mesh);
    this.layer = document.createElement("div");
    Object.assign(this.layer.style, { position: "absolute", pointerEvents: "none", overflow: "hidden" });
    this.rubber = this.layer.appendChild(document.createElement("div"));
    Object.assign(this.rubber.style, {
      position: "absolute",
      border: "1px solid #ffc66d",
      background: "#ffc66d22",
      display: "none",
    });
    this.tip = this.layer.appendChild(document.createElement("div"));
    Object.assign(this.tip.style, {
      position: "absolute",
      padding: "1px 7px",
      borderRadius: "4px",
      font: "400 12px/18px system-ui, sans-serif",
      color: "#f4f6f8",
      background: "#000c",
      whiteSpace: "nowrap",
      display: "none",
    });
    canvas.after(this.layer);
  }

  dispose(): void {
    this.layer.remove();
  }

  /** Something of the store changed. */
  hear(): void {
    const { store } = this.stage;
    const pulled = JSON.stringify([store.options.muscles, [...store.livePulls], store.muscles.length]);
    if (pulled === this.pulled) return;
    this.pulled = pulled;
    this.muscles?.removeFromParent();
    this.muscles?.geometry.dispose();
    this.muscles = undefined;
  }

  /** Lays what is shown now over the face under work. */
  draw({ uniforms: { shared } }: DrawnFace, camera: Camera): void {
    const { store } = this.stage;
    this.under.positions.value = shared.positions.value;
    this.under.normals.value = shared.normals.value;
    if (store.options.wireframe) this.wires ??= this.buildWires();
    if (showsMuscles(store)) this.muscles ??= this.buildMuscles();
    if (this.wires !== undefined) this.wires.visible = store.options.wireframe;
    if (this.muscles !== undefined) this.muscles.visible = showsMuscles(store);
    this.needles.mesh.visible = this.drawHandles(camera) || this.drawNeedles(camera);
  }

  /** The needles of an expression under work; whether there are any. */
  private drawNeedles(camera: Camera): boolean {
    const { store, input } = this.stage;
    const { picker, placing } = input;
    if (store.net === null || !picker.armed) return false;
    const rows = store.net.rows.map((row, place) => (placing?.place === place ? placing.row : row));
    const shown = { rows, states: this.states(), scales: this.scales(camera), outward: picker.directions() };
    this.show({ ...shown, length: picker.needleLength }, camera);
    return true;
  }

  private show(needles: Parameters<NeedleMesh["show"]>[0], { box, back }: Camera): void {
    const { ratio } = this.stage.viewports;
    this.needles.show(needles, [box.width * ratio, box.height * ratio], ratio, back);
  }

  /** How large the needles' heads are: as they stand close, so that what they are on is seen between them. */
  private scales(camera: Camera): number[] {
    const { store, work } = this.stage;
    const rows = store.net?.rows ?? [];
    if (this.spaced?.rows !== rows && work !== undefined) this.spaced = { rows, far: spacing(rows, work.figure.rest) };
    const headSize = HEAD * camera.metresPerPixel(camera.middle);
    return (this.spaced?.far ?? []).map((far) => Math.min(1, Math.max(LEAST, (0.36 * far) / headSize)));
  }

  /** The handles of a face under work; whether there are any. */
  private drawHandles(camera: Camera): boolean {
    const { handles, editsFace } = this.stage;
    const shown = editsFace ? handles?.handles : undefined;
    if (handles === undefined || shown === undefined) {
      this.tell(undefined, "");
      return false;
    }
    const studs = handles.studs();
    const outward = studs.map((stud) => stud.outward);
    this.show({ rows: shown.rows, states: handles.states(), outward, length: STUD }, camera);
    const under = studs[handles.hovered];
    this.tell(under && camera.project(under.head), under === undefined ? "" : namesOf(shown, [handles.hovered]));
    return true;
  }

  /** Puts a name beside a place of the canvas, pixels; nothing: no name. */
  private tell(at: Readonly<Triple> | undefined, name: string): void {
    const { style } = this.tip;
    if (name === "" || at === undefined) {
      if (style.display !== "none") style.display = "none";
      return;
    }
    this.tip.textContent = name;
    Object.assign(style, { display: "block", left: `${at[0] + 12}px`, top: `${at[1] - 26}px` });
  }

  /** Puts names and rubber band where they belong. */
  place(names: readonly string[], boxes: readonly Box[]): void {
    this.stretch();
    const { offsetLeft: left, offsetTop: top, clientWidth: width, clientHeight: height } = this.stage.canvas;
    const asked = JSON.stringify([names, boxes, left, top, width, height]);
    if (asked === this.placed) return; // writing styles costs a layout
    this.placed = asked;
    const sides = { left: `${left}px`, top: `${top}px`, width: `${width}px`, height: `${height}px` };
    Object.assign(this.layer.style, sides);
    names.forEach((text, n) => {
      const [name, box] = [this.name(n), boxes[n] as Box];
      name.textContent = text;
      Object.assign(name.style, { left: `${box.left + 8}px`, top: `${box.top + box.height - 24}px` });
    });
    for (const name of this.names.splice(names.length)) name.remove();
  }

  private stretch(): void {
    const { band } = this.stage.input;
    if (band === undefined && this.rubber.style.display === "none") return;
    this.rubber.style.display = band === undefined ? "none" : "block";
    if (band === undefined) return;
    const [left, top, right, bottom] = band;
    const rect = { left: `${left}px`, top: `${top}px`, width: `${right - left}px`, height: `${bottom - top}px` };
    Object.assign(this.rubber.style, rect);
  }

  private name(n: number): HTMLElement {
    const existing = this.names[n];
    if (existing !== undefined) return existing;
    const label = this.layer.appendChild(document.createElement("span"));
    const font = n === 0 ? "500 13px/18px system-ui, sans-serif" : "400 11px/18px system-ui, sans-serif";
    Object.assign(label.style, { position: "absolute", font, color: "#d8d2c8", textShadow: "0 1px 2px #000" });
    this.names[n] = label;
    return label;
  }

  private states(): NeedleState[] {
    const { store, input } = this.stage;
    const mask = store.options.region === null ? undefined : store.masks[store.regions.indexOf(store.options.region)];
    const images = new Set(input.needleDrag?.dragGroup.mirrored.values());
    return (store.net?.rows ?? []).map((row, place): NeedleState => {
      if (store.selection.has(place)) return "selected";
      if (input.needleDrag?.dragGroup.shares.has(place) || images.has(place)) return "taken";
      if (place === input.hovered) return "hovered";
      return mask !== undefined && (mask[row] as number) === 0 ? "barred" : "still";
    });
  }

  private buildWires(): THREE.LineSegments {
    const skin = this.stage.store.library?.meshes.find(({ name }) => name === "skin");
    const corners = skin === undefined ? new Uint32Array() : rowTriangles(skin);
    const rows: number[] = [];
    for (let at = 0; at < corners.length; at++) {
      const [a, b] = [corners[at] as number, corners[at - (at % 3) + ((at + 1) % 3)] as number];
      if (a < b) rows.push(a, b); // each edge once: its other triangle walks it the other way
    }
    return this.lines(
      rows,
      rows.flatMap((_, n) => (n % 2 === 0 ? EDGE : [])),
      EDGE_LIFT,
    );
  }

  private buildMuscles(): THREE.LineSegments {
    const { store } = this.stage;
    const [rows, colours]: [number[], number[]] = [[], []];
    for (const muscle of store.muscles) {
      const ring = muscle.kind === "sphincter" ? [...muscle.line, muscle.line[0] as number] : muscle.line;
      for (let n = 0; n + 1 < ring.length; n++) {
        rows.push(ring[n] as number, ring[n + 1] as number);
        colours.push(...((store.livePulls.get(muscle.name) ?? 0) > 0 ? MUSCLE : SLACK));
      }
    }
    return this.lines(rows, colours, MUSCLE_LIFT);
  }

  private lines(rows: readonly number[], colours: readonly number[], lift: number): THREE.LineSegments {
    const lines = skinLines(rows, colours, lift, this.under);
    this.object.add(lines);
    return lines;
  }
}
