/** The keys of the cue page as one table: what each does, and how the help shows it. */

import type { KeyPress } from "../../ui/gestures";

export type CueCommand =
  | "go"
  | "back"
  | "earlier"
  | "later"
  | "move_up"
  | "move_down"
  | "edit_before"
  | "edit_behind"
  | "pause"
  | "assert"
  | "edit"
  | "update"
  | "bus"
  | "search"
  | "help"
  /** A key that is the page's own, but means nothing now: held down. */
  | "nothing";

const PLAIN: Readonly<Record<string, CueCommand>> = {
  Space: "go",
  ArrowUp: "earlier",
  ArrowDown: "later",
  PageUp: "edit_before",
  PageDown: "edit_behind",
  KeyP: "pause",
  KeyA: "assert",
  KeyE: "edit",
  KeyU: "update",
  KeyV: "bus",
};
const ALT: Readonly<Record<string, CueCommand>> = { ArrowUp: "move_up", ArrowDown: "move_down" };

/** The lines of the help: keys, and what they do. */
export const CUE_KEYS: readonly (readonly [string, string])[] = [
  ["Space", "GO: the cue that stands by; goes on where cues are paused. Not while a field has the focus"],
  ["Shift Space", "Back: what stood before the last cue"],
  ["↑ ↓", "Another cue stands by; nothing moves on air"],
  ["P", "Pause, and go on"],
  ["A", "Assert: all that the cues have left standing, again"],
  ["E", "Editing, and back to playing"],
  ["U", "While editing: Update, which writes what shows into the cue that is edited"],
  ["V", "Preview, and back to what is on air: what is recorded and updated is what this page looks at"],
  ["Shift Enter", "In preview: take, in the seconds beside that button"],
  ["PgUp PgDn", "While editing: the cue before, the cue behind"],
  ["Alt ↑ ↓", "While editing: the cue one place up, down"],
  ["Ctrl Z, Ctrl Y", "Take the last edit of cues back, whoever made it; do it again"],
  ["/", "Search"],
  ["Esc", "Out of a field, out of the search, closes a form"],
  ["Shift ⌫", "Panic of all characters"],
  ["Enter", "Presses the button in focus: Space never does"],
  ["?", "This page"],
];

/** What a key press means, or null. `inField`: the focus is in a field, whose keys are its own. */
export function cueCommandOf(press: KeyPress, inField: boolean): CueCommand | null {
  if (inField || press.ctrlKey || press.metaKey) return null;
  const command = commandOf(press);
  return command !== null && press.repeat ? "nothing" : command;
}

function commandOf({ key, code, shiftKey, altKey }: KeyPress): CueCommand | null {
  if (altKey) return ALT[code] ?? null;
  if (key === "?") return "help";
  if (key === "/") return "search";
  if (shiftKey) return code === "Space" ? "back" : null;
  return PLAIN[code] ?? null;
}
