/** What tests and curious operators may ask of a stage: `window.omoteStage`. */

import type { PictureBox } from "../face/framing";
import type { Pose } from "../face/pose/pose";
import { restPose } from "../face/pose/pose";
import { alone, type CharacterPose, FRONT, type ScenePose } from "../face/pose/scene_pose";
import type { Level } from "../face/quality/quality_levels";
import { ALL } from "../link/constants";
import { drawPictureGrid, type PictureGrid, SheetComposer } from "./picture_grid";
import type { Counters, Stage } from "./stage";
import type { SoundReport } from "./stage_sound";

/** A scene of which parts may be left out. */
export interface PartialScene {
  characters: Record<string, Partial<CharacterPose>>;
  framing?: ScenePose["framing"];
  black?: number;
}

/** What tests and curious operators may ask of a stage: `window.omoteStage`. */
export interface StageProbe {
  /** Shows exactly this pose (missing parts at rest) until `hold(null)`; resolves when it is drawn in full. */
  hold(pose: Partial<Pose> | null): Promise<void>;
  /** Like `hold`, for an animation: does not wait, and holds back what is not loaded. */
  set(pose: Partial<Pose>): void;
  /** Like `hold`, for several characters: what they leave out is at rest, in front, present. */
  holdScene(scene: PartialScene | null): Promise<void>;
  /** Like `set`, for several characters. */
  setScene(scene: PartialScene): void;
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
  /** The blended positions (vertices x 3, metres) of a character, by default the first, read back from the GPU. */
  readPositions(character?: string): number[];
  /** The rows of a character's figure, by default the first's: skin, then body (rows x 3, metres), read back from the GPU. */
  readFigure(character?: string): number[];
  /** How far the skin of a character is pressed (vertices x 3: level, mixed, upright), read back from the GPU. */
  readStrains(character?: string): number[];
  /** Where vertices of the first character's skin lie in the picture last drawn: right, down as shares of it, and depth, metres. */
  places(rows: readonly number[]): number[][];
  counters(): Counters;
  /** The pose last drawn, of the first character. */
  pose(): Pose | undefined;
  /** The scene last drawn. */
  scene(): ScenePose | undefined;
  /** Where heads lie in the picture last drawn, by name: left, top, right and bottom in parts of it. */
  heads(): Record<string, PictureBox>;
  /** What is heard. */
  sound(): SoundReport;
  /** Whether all of the pose shows in full: nothing is being fetched or caught up with, and the stage has come up. */
  settled(): boolean;
}

declare global {
  interface Window {
    omoteStage?: StageProbe;
  }
}

/** Puts the probe on the page. */
export function exposeProbe(stage: Stage): void {
  const show = async (scene: ScenePose | undefined): Promise<void> => {
    stage.hold(scene);
    if (scene !== undefined) await stage.view.presentScene(scene);
  };
  window.omoteStage = {
    hold: async (pose) => {
      await show(pose === null ? undefined : alone({ ...restPose("generic"), ...pose }));
    },
    set: (pose) => {
      stage.hold(alone({ ...restPose("generic"), ...pose }));
    },
    holdScene: async (scene) => {
      await show(scene === null ? undefined : wholeScene(scene));
    },
    setScene: (scene) => {
      stage.hold(wholeScene(scene));
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
    readPositions: (character) => Array.from(stage.view.readPositions(character)),
    readFigure: (character) => Array.from(stage.view.readFigure(character)),
    readStrains: (character) => Array.from(stage.view.readStrains(character)),
    places: (rows) => stage.view.placesOf(rows),
    counters: () => stage.counters(),
    pose: () => stage.pose,
    scene: () => stage.shown,
    heads: () => Object.fromEntries(stage.view.heads),
    sound: () => stage.sound.report(),
    settled: () => stage.settled,
  };
}

/** A scene with all that it leaves out: characters at rest, in front, present; a framing of all. */
function wholeScene({ characters, framing = { [ALL]: 1 }, black = 0 }: PartialScene): ScenePose {
  const whole = Object.entries(characters).map(([name, character]) => {
    return [
      name,
      { ...restPose("generic"), presence: 1, ...character, place: { ...FRONT, ...character.place } },
    ] as const;
  });
  return { characters: Object.fromEntries(whole), framing, black };
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
