/** The keyboard as one table: what each key does, and how the help shows it. */

import type { KeyPress } from "../../ui/gestures";
import type { Axis } from "./axis";

export type FocusPlace = "face" | "expression" | "head" | "gaze" | "search" | "light" | "characters";

export type Command =
  | { do: "help" }
  | { do: "call"; axis: Axis; index: number }
  | { do: "timing"; axis: Axis; direction: -1 | 1 }
  | { do: "hand"; axis: Axis }
  | { do: "release"; axis: Axis }
  | { do: "keep"; axis: Axis }
  | { do: "focus"; place: FocusPlace }
  | { do: "centre" }
  | { do: "still" }
  | { do: "memory"; name: string }
  | { do: "keep_memory" }
  | { do: "learn" }
  | { do: "clear" }
  | { do: "leases" }
  | { do: "take_over" }
  | { do: "black"; seconds: 0 | null }
  | { do: "scene" }
  | { do: "layers" }
  | { do: "blend_pads" }
  | { do: "go" }
  | { do: "mark" }
  | { do: "moments" }
  | { do: "bus" }
  | { do: "region"; direction: -1 | 1 };

/** Physical keys, so that they lie in two rows on every layout. */
export const FACE_KEYS = ["1", "2", "3", "4", "5", "6", "7", "8", "9"].map((digit) => `Digit${digit}`);
export const EXPRESSION_KEYS = [..."QWERTYUIO"].map((letter) => `Key${letter}`);

const COMMANDS: Readonly<Record<string, Command>> = {
  BracketLeft: { do: "timing", axis: "face", direction: -1 },
  BracketRight: { do: "timing", axis: "face", direction: 1 },
  Minus: { do: "timing", axis: "expression", direction: -1 },
  Equal: { do: "timing", axis: "expression", direction: 1 },
  KeyA: { do: "hand", axis: "face" },
  KeyS: { do: "hand", axis: "expression" },
  KeyF: { do: "focus", place: "face" },
  KeyG: { do: "focus", place: "expression" },
  KeyH: { do: "focus", place: "head" },
  KeyJ: { do: "focus", place: "gaze" },
  KeyK: { do: "focus", place: "characters" },
  KeyL: { do: "focus", place: "light" },
  KeyV: { do: "release", axis: "face" },
  KeyB: { do: "release", axis: "expression" },
  KeyN: { do: "keep", axis: "face" },
  KeyM: { do: "keep", axis: "expression" },
  KeyC: { do: "centre" },
  KeyP: { do: "scene" },
  Semicolon: { do: "layers" },
  Quote: { do: "still" },
  Backslash: { do: "keep_memory" },
  KeyX: { do: "clear" },
  Comma: { do: "leases" },
  Period: { do: "take_over" },
  KeyZ: { do: "learn" },
  Backquote: { do: "go" },
};

/** With Shift: two keys on purpose; in the time of a face's call where no seconds are given. */
const SHIFTED: Readonly<Record<string, Command>> = {
  KeyV: { do: "black", seconds: 0 },
  KeyB: { do: "black", seconds: null },
  KeyP: { do: "bus" },
  KeyH: { do: "blend_pads" },
  KeyM: { do: "mark" },
  KeyK: { do: "moments" },
};

/** The lines of the help: keys, and what they do. */
export const HELP: readonly (readonly [string, string])[] = [
  [
    "Shift ⌫",
    "Panic: the characters played here go neutral and hold still; again: the home face. Everywhere but in a field",
  ],
  ["Ctrl Shift ⌫", "Panic of all characters, also of those that this console does not play"],
  ["Esc", "Closes what is open, leaves a field; nothing else"],
  ["1 – 9", "Call one of the first nine faces"],
  ["Shift 1 – 9", "Call a memory: the whole look that was kept there, in the seconds of a face call"],
  ["\\", "Keep: the next memory pressed keeps the whole look that shows; again: not"],
  ["Q – O", "Call one of the first nine expressions shown; of clips: play it, again: end it"],
  ["D", "Expressions are called on the whole face, the brows, the eyes, the mouth, the rest alone; Shift D: back"],
  ["[  ]", "Shorter, longer: seconds of a face call"],
  ["-  =", "Shorter, longer: seconds of an expression call"],
  ["A  S", "By hand, and back to the seconds of before: face, expression"],
  ["F  G", "To the T-bar of the face, of the expression; then arrows"],
  ["V  B", "Let go of the T-bar of the face, of the expression"],
  ["N  M", "Keep what is on air as a new face, as a new expression"],
  ["H  J", "To the head pad, to the gaze pad; then arrows"],
  [
    "K",
    "While you record a clip of a character played here: keeps the pass. Else to the characters beside the picture; then Tab and Enter, with Shift beside those played",
  ],
  ["P", "Places, framing and names of the characters, and back to faders and pads"],
  [";", "Layers of the character as a mixer, and back to faders and pads"],
  [
    "Shift H",
    "Pads: mixtures of looks under one point, and back to faders and head; their tiles are dragged onto one while it is edited",
  ],
  ["'", "The characters played here hold still; again: they blink, breathe and look about as people do"],
  ["L", "To the lights; then Tab and Enter"],
  ["Shift B", "Fade all stages to black in the seconds of a face call; again: up"],
  ["Shift V", "Blackout: all stages black at once; again: up at once. Panic leaves it as it is"],
  ["Shift M", "Mark this moment of the recording"],
  ["Shift K", "Mark with a word; keep the last minutes of the recording, or the last seconds of a character as a clip"],
  ["`", "GO of the cues, the key left of 1: the cue that stands by, as the bar names it"],
  ["Shift P", "Preview: what is built up there shows nowhere until it is taken; again: back to what is on air"],
  ["Shift Enter", "In preview: take, in the seconds beside that button"],
  ["C", "Head and gaze to the centre"],
  ["X", "All channels to zero"],
  [",", "Leases: who holds what"],
  [".", "Take over what you touched and another holds"],
  ["Z", "Learn: touch a control, move a dial, key or stick of a device; Z or Esc ends it"],
  [
    "Ctrl Z",
    "Take back the last change made here: keep, name, delete, clear, layouts, home face, characters and places; again: the one before",
  ],
  ["Ctrl Y", "Do it again; Ctrl Shift Z too"],
  ["F2, Del", "Name, delete the own picture in focus"],
  ["/", "Search expressions"],
  ["Tab", "Next control"],
  [
    "Arrows",
    "Move the control in focus, with Shift ten times finer, with the Page keys ten times coarser; in a palette: to the next picture",
  ],
  ["Home, 0", "The control in focus to its rest"],
  ["?", "This page"],
];

/** Shift and Backspace: at the edge of every keyboard, two keys on purpose, and nothing else is on them. */
export const isPanic = ({ code, shiftKey }: KeyPress): boolean => shiftKey && code === "Backspace";

/** What a key press means, or null. `typing`: the focus is in a field, whose keys are its own. */
export function commandOf(press: KeyPress, typing: boolean): Command | null {
  if (typing || press.repeat || press.altKey) return null;
  if (press.ctrlKey || press.metaKey) return null;
  if (press.key === "?") return { do: "help" };
  if (press.key === "/") return { do: "focus", place: "search" };
  const face = FACE_KEYS.indexOf(press.code);
  if (face >= 0 && press.shiftKey) return { do: "memory", name: String(face + 1) };
  if (face >= 0) return { do: "call", axis: "face", index: face };
  const expression = EXPRESSION_KEYS.indexOf(press.code);
  if (expression >= 0) return { do: "call", axis: "expression", index: expression };
  if (press.shiftKey && press.code in SHIFTED) return SHIFTED[press.code] ?? null;
  if (press.code === "KeyD") return { do: "region", direction: press.shiftKey ? -1 : 1 };
  return COMMANDS[press.code] ?? null;
}

/** The step that a chord takes, with Ctrl, or Command on a Mac; null for another. */
export function stepOf({ key, shiftKey, ctrlKey, metaKey, altKey }: KeyPress): "undo" | "redo" | null {
  if (altKey || !(ctrlKey || metaKey)) return null;
  const letter = key.toLowerCase();
  if (letter === "z") return shiftKey ? "redo" : "undo";
  return letter === "y" ? "redo" : null;
}

/** The label of the hot key at an index of a palette, or null beyond the ninth. */
export function keyLabel(axis: Axis, index: number): string | null {
  const code = (axis === "face" ? FACE_KEYS : EXPRESSION_KEYS)[index];
  return code === undefined ? null : code.replace(/^(Digit|Key)/, "");
}
