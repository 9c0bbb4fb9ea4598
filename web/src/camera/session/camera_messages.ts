// Written by tools/messages.py from src/omote/inputs/performers/camera_messages.py. Do not edit: run `python tools/messages.py`.

export const CAMERA_VERSION = 3;
export const CAMERA_PATH = "/camera/link";

/** Says who performs before this camera: the first message of a link, and again for another performer. */
export type Perform = { type: "perform"; version: number; name: string };

/** Chooses the characters that this performer plays, by name; none: it plays nobody. */
export type PlayCharacters = { type: "play_characters"; characters: string[] };

/**
 * What the page has read of the performer's hand in one picture: weights by channel, and how it turns the head
 * (yaw, pitch and roll, radians), by the calibration that the page keeps. `time`: seconds of the page's clock;
 * `found`: false while no hand is seen. `pad`: the pad whose point the other hand moves on the characters that this
 * one plays, "" for none; `point`: where it is, -1..1 right and up as in a mirror.
 */
export type HandFrame = {
  type: "hand_frame";
  time: number;
  found: boolean;
  weights: Record<string, number>;
  head?: [number, number, number] | null;
  pad?: string;
  point?: [number, number] | null;
};

/** Chooses the characters that this performer's hand plays, and in which regions (none named: all). */
export type PlayHand = {
  type: "play_hand";
  characters: string[];
  regions: ("brows" | "eyes" | "mouth" | "rest" | "head" | "gaze")[];
};

/**
 * Chooses the characters whose figure this performer's body plays: arms, shoulders and trunk, as far as they are
 * seen.
 */
export type PlayBody = { type: "play_body"; characters: string[] };

/** Takes the next two seconds as how the performer's body is at rest. */
export type RestBody = { type: "rest_body" };

/** Begins the guided minute, or with `rest` only a moment of the face at rest. */
export type BeginGuide = { type: "begin_guide"; rest?: boolean };

/** Makes a step of the guided minute again, now or when all are done. */
export type RedoStep = { type: "redo_step"; step: string };

/** Ends the guided minute; the calibration before it stays, and so do the faces that were made. */
export type CancelGuide = { type: "cancel_guide" };

/** Goes on with a guided minute that was ended, at the next face that is missing. */
export type ContinueGuide = { type: "continue_guide" };

/** Reads the performer by the faces that were made, though others are missing. */
export type UseFaces = { type: "use_faces" };

/** Gives this performer another name, calibration included. */
export type RenamePerformer = { type: "rename_performer"; name: string };

/** Forgets the calibration of this performer. */
export type DeletePerformer = { type: "delete_performer" };

/** Takes the last change of the show's performers back. */
export type UndoPerformer = { type: "undo_performer" };

/** A character of the show, and whether this performer plays it. */
export type CharacterChoice = { name: string; label: string; played: boolean };

/**
 * What the performer's hand plays: characters, and regions (none: all). heard: frames of it so far; pads: those of
 * the show with two dimensions or more, which another hand may move.
 */
export type HandChoice = {
  characters: CharacterChoice[];
  regions: ("brows" | "eyes" | "mouth" | "rest" | "head" | "gaze")[];
  heard: number;
  pads: string[];
};

/**
 * What the performer's body plays. known: whether it is known how it is at rest; heard: frames of it so far;
 * shares: how much of each region is tracked now, 0..1.
 */
export type BodyChoice = {
  characters: CharacterChoice[];
  known: boolean;
  heard: number;
  shares: Record<string, number>;
};

/** The step of a guide that is being made. left: seconds of its phase, of `seconds`; done: steps that are made. */
export type GuideStep = {
  step: string;
  advice: string;
  phase: "ready" | "hold";
  left: number;
  seconds: number;
  number: number;
  of: number;
  done: string[];
};

/**
 * All that the page shows of the show: complete, ten times a second. `performers`: those that the show knows;
 * `redoable`, `missing`: steps of the guided minute that were made and were not, both empty before the first;
 * `unrest`: what the face that was taken as at rest does, in a sentence, "" where it rests; `unused`: whether faces
 * were made by which the performer is not read; `heard`: frames so far; `undo`: what an undo takes back, "" for
 * nothing; `weights`: what the face is read as; `hand`, `body`: what the performer's hand and body
 * play.
 */
export type CameraStatus = {
  type: "camera_status";
  performer: string;
  performers: string[];
  calibrated: "no" | "rest" | "guided";
  unrest: string;
  characters: CharacterChoice[];
  guide: GuideStep | null;
  redoable: string[];
  missing: string[];
  unused: boolean;
  fitting: boolean;
  heard: number;
  found: boolean;
  undo: string;
  weights: Record<string, number>;
  hand: HandChoice;
  body: BodyChoice;
};

/** Why something was not done. */
export type CameraRefused = { type: "camera_refused"; reason: string };

/** Another page plays as this performer now; this one has ended. */
export type Displaced = { type: "displaced" };

export type FromCamera =
  | Perform
  | PlayCharacters
  | HandFrame
  | PlayHand
  | PlayBody
  | RestBody
  | BeginGuide
  | RedoStep
  | CancelGuide
  | ContinueGuide
  | UseFaces
  | RenamePerformer
  | DeletePerformer
  | UndoPerformer;

export type ToCamera = CameraStatus | CameraRefused | Displaced;
