/** What this browser remembers of its microphone. */

import { type BrowserStorage, keep, readKept, readRecord } from "../ui/browser_storage";

/** How it hears: `open` always, `push` while a key or the button is held. */
export type Mode = "open" | "push";

/** The speaker as measured by a sentence. */
export interface Speaker {
  readonly bands: readonly number[];
  readonly level: number;
}

/** `cleaning`: what the browser does to the sound. `speakers`: by device. */
export interface MicrophoneSettings {
  readonly name: string;
  readonly device: string;
  readonly mode: Mode;
  readonly cleaning: Readonly<Record<Cleaning, boolean>>;
  readonly speakers: Readonly<Record<string, Speaker>>;
}

export const CLEANINGS = ["echoCancellation", "noiseSuppression", "autoGainControl"] as const;
export type Cleaning = (typeof CLEANINGS)[number];

const KEY = "omote.microphone";
export const LONGEST_NAME = 60;
const MOST_SPEAKERS = 16;
export const FIRST: MicrophoneSettings = {
  name: "Microphone",
  device: "",
  mode: "open",
  cleaning: { echoCancellation: false, noiseSuppression: false, autoGainControl: false },
  speakers: {},
};

/** What was kept; what cannot be read is as it is at first. */
export function readSettings(store: BrowserStorage): MicrophoneSettings {
  return checked(readRecord(readKept(store, KEY)) as Partial<MicrophoneSettings>);
}

/** Keeps the settings, where the browser lets it. */
export const keepSettings = (store: BrowserStorage, settings: MicrophoneSettings): void =>
  keep(store, KEY, JSON.stringify(settings));

/** The settings with another speaker of the chosen device; null forgets it. */
export function withSpeaker(settings: MicrophoneSettings, speaker: Speaker | null): MicrophoneSettings {
  const others = Object.entries(settings.speakers).filter(([device]) => device !== settings.device);
  const mine: [string, Speaker][] = speaker === null ? [] : [[settings.device, speaker]];
  return { ...settings, speakers: Object.fromEntries([...others, ...mine].slice(-MOST_SPEAKERS)) };
}

function checked(stored: Partial<MicrophoneSettings>): MicrophoneSettings {
  const { name, device, mode, cleaning, speakers } = stored;
  return {
    name: typeof name === "string" && name.trim() !== "" ? name.slice(0, LONGEST_NAME) : FIRST.name,
    device: typeof device === "string" ? device : "",
    mode: mode === "push" ? "push" : "open",
    cleaning: { ...FIRST.cleaning, ...picked(cleaning) },
    speakers: Object.fromEntries(Object.entries(speakers ?? {}).filter(([, speaker]) => isSpeaker(speaker))),
  };
}

const picked = (cleaning: unknown): Partial<Record<Cleaning, boolean>> =>
  Object.fromEntries(
    CLEANINGS.flatMap((name) => {
      const on: unknown = (cleaning as Record<string, unknown> | undefined)?.[name];
      return typeof on === "boolean" ? [[name, on]] : [];
    }),
  );

const isSpeaker = (value: unknown): value is Speaker =>
  typeof value === "object" &&
  value !== null &&
  Array.isArray((value as Speaker).bands) &&
  (value as Speaker).bands.every((band) => typeof band === "number") &&
  typeof (value as Speaker).level === "number";
