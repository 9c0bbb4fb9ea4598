/** The keyboard of the editor as one table: what each key does, and how the help shows it. */

import type { KeyPress } from "../../ui/gestures";
import type { Tool } from "../session/editor_store";

export type ViewKey = "front" | "left" | "right" | "three-quarter" | "whole";

export type EditorCommand =
  | { do: "undo" | "redo" | "save" | "help" | "search" | "leave" | "mirror" | "wireframe" | "needles" | "muscles" }
  | { do: "tool"; tool: Tool }
  | { do: "view"; view: ViewKey };

/** Tools in the order of the tool bar: name, key, what it does. */
export const TOOLS: readonly (readonly [Tool, string, string, string])[] = [
  ["drag", "Drag", "D", "Drag needles along the skin"],
  ["pull", "Pull", "P", "Pull the skin out or push it in"],
  ["add", "Add", "A", "Set another needle"],
  ["remove", "Remove", "R", "Take a needle away"],
  ["place", "Move", "M", "Put a needle elsewhere"],
];

export const VIEWS: readonly (readonly [ViewKey, string, string])[] = [
  ["front", "Front", "1"],
  ["left", "Left", "2"],
  ["right", "Right", "3"],
  ["three-quarter", "¾", "4"],
  ["whole", "Whole", "0"],
];

const LETTERS: Readonly<Record<string, EditorCommand>> = {
  ...Object.fromEntries(TOOLS.map(([tool, , key]) => [`Key${key}`, { do: "tool", tool } as const])),
  ...Object.fromEntries(VIEWS.map(([view, , key]) => [`Digit${key}`, { do: "view", view } as const])),
  KeyX: { do: "mirror" },
  KeyW: { do: "wireframe" },
  KeyN: { do: "needles" },
  KeyU: { do: "muscles" },
};

/** The lines of the help: keys, and what they do. */
export const HELP: readonly (readonly [string, string])[] = [
  ["Ctrl S", "Save: what is on the page plays from now on"],
  ["Ctrl Z, Ctrl Shift Z", "Undo, redo"],
  ["D  P", "Tools: drag along the skin, pull off it"],
  ["A  R  M", "The needles themselves: add, remove, move"],
  ["X", "Mirror: what you do on one side is done on the other"],
  ["Arrows", "On the face: nudge the selected needles, with Shift finer, with Alt off the skin"],
  [",  .", "On the face: the needle before, the next one, from the crown down"],
  ["1 – 4", "Front, left side, right side, three-quarter view"],
  ["0", "The whole face again, after zoom and shift; so does a double click beside it"],
  ["N  W  U", "Show needles, wireframe, muscles"],
  ["Esc", "Lets go of a drag as if it had not been, else of the selection, else back to your draft"],
  ["/", "Search"],
  ["Alt arrows", "In the list: puts an own item further up or down"],
  ["?", "This page"],
];

/** What a key press means, or null. `typing`: the focus is in a field for text, where only saving is heard. */
export function commandOf(press: KeyPress, typing: boolean): EditorCommand | null {
  if (press.ctrlKey || press.metaKey) return press.altKey ? null : withControl(press, typing);
  if (typing || press.altKey || press.repeat) return null;
  if (press.key === "Escape") return { do: "leave" };
  if (press.key === "?") return { do: "help" };
  if (press.key === "/") return { do: "search" };
  return press.shiftKey ? null : (LETTERS[press.code] ?? null);
}

/** By the letter, as every program does, not by its place on the keyboard. */
function withControl({ key, shiftKey }: { key: string; shiftKey: boolean }, typing: boolean): EditorCommand | null {
  const letter = key.toLowerCase();
  if (letter === "s") return { do: "save" };
  if (typing) return null; // a field has an undo of its own
  if (letter === "z") return { do: shiftKey ? "redo" : "undo" };
  return letter === "y" ? { do: "redo" } : null;
}
