/** The keys of the page for one person as one table: what each does, and how the help shows it. */

import type { KeyPress } from "../../ui/gestures";
import { EXPRESSION_KEYS, FACE_KEYS } from "../store/keys";

export type SoloCommand =
  | { do: "look"; name: string }
  | { do: "line"; index: number }
  | { do: "go" | "back" | "still" | "centre" | "learn" | "help" }
  | { do: "black"; seconds: 0 | null }
  | { do: "focus"; place: "left" | "right" | "head" }
  /** A key that is the page's own, but means nothing now: held down. */
  | { do: "nothing" };

const PLAIN: Readonly<Record<string, SoloCommand>> = {
  Space: { do: "go" },
  KeyF: { do: "focus", place: "left" },
  KeyJ: { do: "focus", place: "right" },
  KeyH: { do: "focus", place: "head" },
  Quote: { do: "still" },
  KeyC: { do: "centre" },
  KeyZ: { do: "learn" },
};
const SHIFTED: Readonly<Record<string, SoloCommand>> = {
  Space: { do: "back" },
  KeyV: { do: "black", seconds: 0 },
  KeyB: { do: "black", seconds: null },
};

/** The lines of the help: keys, and what they do. */
export const SOLO_KEYS: readonly (readonly [string, string])[] = [
  [
    "Shift ⌫",
    "Panic: the characters played here go neutral and hold still; again: the home face. Everywhere but in a field",
  ],
  ["Ctrl Shift ⌫", "Panic of all characters"],
  ["Space", "GO: the cue that stands by"],
  ["Shift Space", "Back: what stood before the last cue"],
  ["1 – 9", "Calls a look: the memory that was kept there"],
  ["Q – O", "Plays one of the first nine lines (clips); again: ends it"],
  ["F  J", "To the left pad, to the right pad; then arrows, with Shift ten times finer, Home: to the look at rest"],
  ["H", "To the head pad; then arrows"],
  ["C", "Head and gaze to the centre"],
  ["'", "The characters played here hold still; again: they blink, breathe and look about as people do"],
  ["Shift B", "Fade all stages to black in the seconds of a face call; again: up"],
  ["Shift V", "Blackout: all stages black at once; again: up at once"],
  ["Z", "Learn: touch a control, move a dial, key or stick of a device; Z or Esc ends it"],
  ["Ctrl Z", "Take back the last change made here; Ctrl Y: do it again"],
  ["Esc", "Closes what is open; nothing else"],
  ["?", "This page"],
];

/** What a key press means, or null. `typing`: the focus is in a field, whose keys are its own. */
export function soloCommandOf(press: KeyPress, typing: boolean): SoloCommand | null {
  if (typing || press.altKey || press.ctrlKey || press.metaKey) return null;
  const command = meaningOf(press);
  return command !== null && press.repeat ? { do: "nothing" } : command;
}

function meaningOf({ key, code, shiftKey }: KeyPress): SoloCommand | null {
  if (key === "?") return { do: "help" };
  if (shiftKey) return SHIFTED[code] ?? null;
  const [look, line] = [FACE_KEYS.indexOf(code), EXPRESSION_KEYS.indexOf(code)];
  if (look >= 0) return { do: "look", name: String(look + 1) };
  return line >= 0 ? { do: "line", index: line } : (PLAIN[code] ?? null);
}
