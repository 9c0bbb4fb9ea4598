// Written by tools/messages.py from src/omote/inputs/microphone/microphone_messages.py. Do not edit: run `python tools/messages.py`.

export const MICROPHONE_PATH = "/voice";
/** Samples per second. */
export const SAMPLE_RATE = 16000;

/** A microphone: its name at the show, and its speaker as measured before. */
export type Begin = { type: "begin"; name: string; bands?: number[]; level?: number };

/** The speaker begins, or has finished, the sentence that measures the voice. */
export type Sentence = { type: "sentence"; step: "start" | "finish" | "forget" };

/** Through which character the microphone speaks; "" none, "*" all. */
export type Speak = { type: "speak"; character: string };

/**
 * What was heard: `samples` of 16 bits at 16 kHz, mono, little-endian, at most half a second; `sent`: the page's
 * clock when the last was heard, ms.
 */
export type Sound = { type: "sound"; samples: Uint8Array; sent?: number };

/**
 * What is heard now. `level`: dB of full scale; `speaks`: 0..1; `viseme`: the strongest; `characters`: who speaks
 * by it; `there`: who there is, by name and label; `calibrated`, `calibrating`: of the speaker; `sent`: the clock of
 * the newest sound that this is of, ms.
 */
export type Voice = {
  type: "voice";
  level: number;
  speaks: number;
  viseme: string;
  characters: string[];
  there: Record<string, string>;
  calibrated: boolean;
  calibrating: boolean;
  sent: number;
};

/** The speaker, for the page to keep; without bands it was forgotten. */
export type Measured = { type: "measured"; bands: number[]; level: number };

/** What was not obeyed, in words. */
export type Rejected = { type: "rejected"; reason: string };

export type FromMicrophone = Begin | Sentence | Speak | Sound;

export type ToMicrophone = Voice | Measured | Rejected;
