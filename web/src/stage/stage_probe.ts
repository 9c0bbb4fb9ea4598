/** What tests and curious operators may ask of a stage: `window.omoteStage`. */

import type { Pose } from "../face/pose/pose";
import { restPose } from "../face/pose/pose";
import type { Level } from "../face/quality/quality_levels";
import { drawPictureGrid, type PictureGrid, SheetComposer } from "./picture_grid";
import type { Counters, Stage } from "./stage";

/** What tests and curious operators may ask of a stage: `window.omoteStage`. */
export interface StageProbe {
  /** Shows exactly this pose (missing parts at rest) until `hold(null)`; resolves when it is drawn in full. */
  hold(pose: Partial<Pose> | null): Promise<void>;
  /** Like `hold`, for an animation: does not wait, and holds back what is not loaded. */
  set(pose: Partial<Pose>): void;
  /** Draws nothing of its own from now on: every frame would delay a picture. */
  rest(): void;
  /**
   * Draws a sheet of pictures, each of the page's size, as a file in base64; what the `next` pose needs is fetched
   * meanwhile. The stage rests from then on.
   */
  sheet(sheet: PictureGrid, next?: Partial<Pose>): Promise<string>;
  /** Begins a sheet that files of pictures are pasted into. */
  beginSheet(sheet: PictureGrid): void;
  /** Pastes a picture, an image file in base64, into the sheet that was begun. */
  pastePicture(file: string, row: number, column: number): Promise<void>;
  /** The sheet that was begun, as a file in base64. */
  finishSheet(): Promise<string>;
  /** Draws at a level of quality, from when its shaders are ready on; with `?quality=auto` the stage may choose again. */
  change(level: Level): Promise<void>;
  /** The blended positions (vertices x 3, metres), read back from the GPU. */
  readPositions(): number[];
  counters(): Counters;
  /** The pose last drawn. */
  pose(): Pose | undefined;
  /** Whether all of the pose shows in full: nothing is being fetched or caught up with. */
  settled(): boolean;
}

declare global {
  interface Window {
    omoteStage?: StageProbe;
  }
}

/** Puts the probe on the page. */
export function exposeProbe(stage: Stage): void {
  window.omoteStage = {
    hold: async (pose) => {
      stage.held = pose === null ? undefined : { ...restPose("generic"), ...pose };
      if (stage.held !== undefined) await stage.view.present(stage.held);
    },
    set: (pose) => {
      stage.held = { ...restPose("generic"), ...pose };
    },
    rest: () => {
      stage.resting = true;
    },
    sheet: async (sheet, next) => {
      stage.resting = true;
      return base64(await drawPictureGrid(stage.view, sheet, innerWidth, innerHeight, next));
    },
    ...sheetProbe(),
    change: (level) => stage.view.change(level),
    readPositions: () => Array.from(stage.view.readPositions()),
    counters: () => stage.counters(),
    pose: () => stage.shown,
    settled: () => stage.view.settled,
  };
}

/** Composes a sheet from files of pictures. */
function sheetProbe(): Pick<StageProbe, "beginSheet" | "pastePicture" | "finishSheet"> {
  let composer: SheetComposer | undefined;
  return {
    beginSheet: (sheet) => {
      composer = new SheetComposer(sheet, innerWidth, innerHeight);
    },
    pastePicture: async (file, row, column) => {
      const bytes = Uint8Array.from(atob(file), (letter) => letter.charCodeAt(0));
      const picture = await createImageBitmap(new Blob([bytes]), { colorSpaceConversion: "none" });
      composer?.paste(picture, row, column);
      picture.close();
    },
    finishSheet: async () => base64(await (composer as SheetComposer).file()),
  };
}

async function base64(file: Blob): Promise<string> {
  const bytes = new Uint8Array(await file.arrayBuffer());
  let text = "";
  for (let at = 0; at < bytes.length; at += 32768) text += String.fromCharCode(...bytes.subarray(at, at + 32768));
  return btoa(text);
}
