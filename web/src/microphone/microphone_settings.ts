/** What this browser remembers of its microphone. */

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

type Store = Pick<Storage, "getItem" | "setItem">;

/** What was kept; what cannot be read is as it is at first. */
export function readSettings(store: () => Store): MicrophoneSettings {
  try {
    return checked(JSON.parse(store().getItem(KEY) ?? "{}"));
  } catch {
    return FIRST;
  }
}

/** Keeps the settings, where the browser lets it. */
export function keepSettings(store: () => Store, settings: MicrophoneSettings): void {
  try {
    store().setItem(KEY, JSON.stringify(settings));
  } catch {
    // a private window keeps nothing
  }
}

/** The settings with another speaker of the chosen device; null forgets it. */
export function withSpeaker(settings: MicrophoneSettings, speaker: Speaker | null): MicrophoneSettings {
  const others = Object.entries(settings.speakers).filter(([device]) => device !== settings.device);
  const mine: [string, Speaker][] = speaker === null ? [] : [[settings.device, speaker]];
  return { ...settings, speakers: Object.fromEntries([...others, ...mine].slice(-MOST_SPEAKERS)) };
}

function checked(found: Partial<MicrophoneSettings>): MicrophoneSettings {
  const { name, device, mode, cleaning, speakers } = found;
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
    CLEANINGS.flatMap((one) => {
      const on: unknown = (cleaning as Record<string, unknown> | undefined)?.[one];
      return typeof on === "boolean" ? [[one, on]] : [];
    }),
  );

const isSpeaker = (found: unknown): found is Speaker =>
  typeof found === "object" &&
  found !== null &&
  Array.isArray((found as Speaker).bands) &&
  (found as Speaker).bands.every((band) => typeof band === "number") &&
  typeof (found as Speaker).level === "number";
