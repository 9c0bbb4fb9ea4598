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
  | "leave"
  | "update"
  | "bus"
  | "search"
  | "help"
  /** A key that is the page's own, but means nothing now: held down. */
  | "nothing";

/** Where a key is pressed: on a page that plays, one that edits, or in a field, whose keys are its own. */
export type KeyPlace = "playing" | "editing" | "field";

/** What plays. While cues are edited these do nothing until they are let play: a letter that misses its field is no GO. */
const PLAYING: Readonly<Record<string, CueCommand>> = {
  Space: "go",
  ArrowUp: "earlier",
  ArrowDown: "later",
  KeyP: "pause",
  KeyA: "assert",
};
/** What opens something else, while nothing is edited. */
const OPENING: Readonly<Record<string, CueCommand>> = { KeyE: "edit", KeyV: "bus" };
const EDITING: Readonly<Record<string, CueCommand>> = {
  PageUp: "edit_before",
  PageDown: "edit_behind",
  Escape: "leave",
};
const ALT: Readonly<Record<string, CueCommand>> = {
  ArrowUp: "move_up",
  ArrowDown: "move_down",
  KeyU: "update",
  KeyV: "bus",
};

/** The lines of the help: keys, and what they do. */
export const CUE_KEYS: readonly (readonly [string, string])[] = [
  [
    "Space",
    "GO: the cue that stands by; goes on where cues are paused. Not while a field has the focus, nor while editing: there keys play once Keys play is pressed beside GO, until a field is entered",
  ],
  ["Shift Space", "Back: what stood before the last cue"],
  ["↑ ↓", "Another cue stands by; nothing moves on air"],
  ["P", "Pause, and go on"],
  ["A", "Assert: all that the cues have left standing, again"],
  ["E", "Editing; Esc: back to playing"],
  ["Alt U", "While editing: Update, which writes what shows into the cue that is edited"],
  [
    "V",
    "Preview, and back to what is on air: what is recorded and updated is what this page looks at. While editing Alt V",
  ],
  ["Shift Enter", "In preview: take, in the seconds beside that button"],
  ["PgUp PgDn", "While editing: the cue before, the cue behind"],
  ["Alt ↑ ↓", "While editing: the cue one place up, down"],
  ["Ctrl Z, Ctrl Y", "Take the last edit of cues back, whoever made it; do it again"],
  ["/", "Search"],
  ["Esc", "Out of a field, out of the search, closes a form; then out of editing"],
  ["Shift ⌫", "Panic of all characters"],
  ["Enter", "Presses the button in focus: Space never does"],
  ["?", "This page"],
];

/** What a key press means, or null. `armed`: keys play although cues are edited. */
export function cueCommandOf(press: KeyPress, place: KeyPlace, armed = false): CueCommand | null {
  if (place === "field" || press.ctrlKey || press.metaKey) return null;
  const command = commandOf(press, place);
  if (command === null) return null;
  return press.repeat || (place === "editing" && plays(command) && !armed) ? "nothing" : command;
}

const plays = (command: CueCommand): boolean => command === "back" || Object.values(PLAYING).includes(command);

function commandOf({ key, code, shiftKey, altKey }: KeyPress, place: KeyPlace): CueCommand | null {
  if (altKey) return place === "editing" ? (ALT[code] ?? null) : null;
  if (key === "?") return "help";
  if (key === "/") return "search";
  if (shiftKey) return code === "Space" ? "back" : null;
  return PLAYING[code] ?? (place === "editing" ? EDITING : OPENING)[code] ?? null;
}
