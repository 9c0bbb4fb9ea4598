/** What tests, benchmarks and curious users may ask of the canvas: `window.omoteEditor`. */

import type { EditorCanvas } from "./editor_canvas";
import type { CanvasCounters } from "./scene/frame_pacing";

export interface EditorProbe {
  /** Whether all faces wear the draft, and nothing eases. */
  settled(): boolean;
  /** Whether all faces are drawn as well as can be, with smooth edges and hair where their skin has it. */
  refined(): boolean;
  counters(): CanvasCounters;
  /** The needles, or a face's handles, on the canvas: place, row, a handle's name, where the head and the foot are (CSS pixels), whether it can be seen. */
  needles(): { place: number; row: number; label: string; head: [number, number]; foot: [number, number] }[];
  /** The positions of a face as the GPU has them, (rows, 3) metres. */
  readPositions(face: string): number[];
  /** The positions of a face as the page computes them, (rows, 3) metres, when nothing eases. */
  positions(face: string): number[];
  /** The view: yaw, pitch, zoom, pan. */
  view(): { yaw: number; pitch: number; zoom: number; pan: [number, number] };
  /** The faces' boxes, CSS pixels, the work's first. */
  faces(): string[];
  /** Vectors as the hand has them, (n, 3). */
  vectors(): number[];
}

declare global {
  interface Window {
    omoteEditor?: EditorProbe;
  }
}

/** Puts the probe on the page. */
export function exposeProbe(stage: EditorCanvas): void {
  const { store } = stage;
  const memberOf = (face: string) => {
    const picture = stage.editsFace ? stage.faceScene?.all.find(({ label }) => label === face) : undefined;
    if (picture !== undefined) return picture;
    const member = stage.expressionScene?.member(store.sourceOf(face));
    if (member?.drawn === undefined) throw new Error(`The face "${face}" is not shown.`);
    return member;
  };
  window.omoteEditor = {
    settled: () => stage.settled(),
    refined: () => stage.refined(),
    counters: () => countersOf(stage),
    needles: () => needlesOf(stage),
    readPositions: (face) => Array.from(memberOf(face).drawn?.read() ?? []),
    positions: (face) => {
      const member = memberOf(face);
      return Array.from(stage.editsFace ? member.figure.base : (stage.expressionScene?.positions(member) ?? []));
    },
    view: () => stage.viewports.view,
    faces: () =>
      stage.editsFace ? (stage.faceScene?.all ?? []).map(({ label }) => label) : [store.work, ...store.neighbours],
    vectors: () => [...store.live],
  };
}

const countersOf = ({ pacing, editsFace, faceScene, expressionScene }: EditorCanvas): CanvasCounters => ({
  drawn: pacing.drawn,
  intervals: [...pacing.intervals],
  waits: [...pacing.waits],
  differences: Object.fromEntries((editsFace ? faceScene?.differences : expressionScene?.differences) ?? []),
  arrived: expressionScene?.arrived ?? 0,
  fps: pacing.fps,
});

function needlesOf({ input, editsFace, handles }: EditorCanvas): ReturnType<EditorProbe["needles"]> {
  const { picker } = input;
  const camera = picker.camera();
  if (camera === undefined) return [];
  return picker.needles().map(({ place, head, foot }) => {
    const [a, b] = [camera.project(head), camera.project(foot)];
    const label = (editsFace ? handles?.handles?.labels[place] : undefined) ?? "";
    return { place, row: picker.rowOf(place), label, head: [a[0], a[1]], foot: [b[0], b[1]] };
  });
}
