/** The keys of the clip page as one table: what each does, and how the help shows it. */

import { CLIP_PARTS } from "../../link/constants";
import type { KeyPress } from "../../ui/gestures";

export type ClipCommand =
  | {
      do:
        | "play"
        | "record"
        | "keep"
        | "discard"
        | "count_in"
        | "slow"
        | "loop"
        | "mute"
        | "again"
        | "new"
        | "help"
        | "search";
    }
  | { do: "mark"; end: "from" | "to" }
  | { do: "step"; seconds: number }
  | { do: "shift"; seconds: number }
  | { do: "go"; end: "start" | "stop" }
  | { do: "lane"; way: -1 | 1 }
  | { do: "zoom"; way: -1 | 0 | 1 }
  | { do: "arm"; part: (typeof CLIP_PARTS)[number]; how: "only" | "beside" }
  | { do: "arm_all" }
  /** A key that is the page's own, but means nothing now: held down. */
  | { do: "nothing" };

const PLAIN: Readonly<Record<string, ClipCommand>> = {
  Space: { do: "play" },
  KeyR: { do: "record" },
  KeyK: { do: "keep" },
  Escape: { do: "discard" },
  KeyA: { do: "arm_all" },
  KeyC: { do: "count_in" },
  KeyS: { do: "slow" },
  KeyL: { do: "loop" },
  KeyM: { do: "mute" },
  KeyG: { do: "again" },
  KeyN: { do: "new" },
  KeyI: { do: "mark", end: "from" },
  KeyO: { do: "mark", end: "to" },
  Home: { do: "go", end: "start" },
  End: { do: "go", end: "stop" },
  Minus: { do: "zoom", way: -1 },
  Equal: { do: "zoom", way: 1 },
  Digit0: { do: "zoom", way: 0 },
};
/** Those that go on while they are held down. */
const HELD: Readonly<Record<string, (shift: boolean, alt: boolean) => ClipCommand>> = {
  ArrowLeft: (shift, alt) => sideways(-1, shift, alt),
  ArrowRight: (shift, alt) => sideways(1, shift, alt),
  ArrowUp: () => ({ do: "lane", way: -1 }),
  ArrowDown: () => ({ do: "lane", way: 1 }),
};

const sideways = (way: -1 | 1, shift: boolean, alt: boolean): ClipCommand =>
  alt ? { do: "shift", seconds: way * (shift ? 0.1 : 0.01) } : { do: "step", seconds: way * (shift ? 1 / 60 : 0.1) };

/** The lines of the help: keys, and what they do. */
export const CLIP_KEYS: readonly (readonly [string, string])[] = [
  ["Space", "Plays from the place that is marked, and stops; ends a pass that is recorded, and keeps it"],
  ["R", "Records a pass of the parts that are armed, from the place that is marked; again: ends and keeps it"],
  ["1 – 7", `Arms one part alone: ${CLIP_PARTS.join(", ")}`],
  ["Shift 1 – 7", "Arms it beside the others, or not"],
  ["A", "Arms all parts"],
  ["C", "Three seconds are counted in before a pass begins, or not"],
  ["S", "Passes are recorded at half speed, or at full speed; no sound is heard at half"],
  ["K", "Keeps the pass that is recorded"],
  ["Esc", "Discards the pass that is recorded; else no span is selected. Out of a field"],
  ["↑ ↓", "Another lane"],
  ["← →", "The place that is marked by a tenth of a second, with Shift by a frame"],
  ["Home End", "To the start, to the end of the clip"],
  ["Alt ← →", "The lane that is chosen 10 ms earlier, later; with Shift 100 ms"],
  ["M", "The lane that is chosen is mute, or heard again"],
  ["I O", "A span begins here, ends here"],
  ["G", "Records the lane that is chosen again, over the span, from two seconds before it"],
  ["L", "The clip begins again at its end, or not"],
  ["−  =  0", "Farther, nearer, all of it"],
  ["N", "A new clip"],
  ["F2, Del", "While the list has the focus: names, deletes the clip"],
  ["Ctrl Z, Ctrl Y", "Takes the last change made here back; does it again"],
  ["/", "Search"],
  ["Shift ⌫", "Panic of all characters"],
  ["Enter", "Presses the button in focus: Space never does"],
  ["?", "This page"],
];

/** What a key press means, or null. `inField`: the focus is in a field, whose keys are its own. */
export function clipCommandOf(press: KeyPress, inField: boolean): ClipCommand | null {
  const { key, code, shiftKey, altKey, ctrlKey, metaKey, repeat } = press;
  if (inField || ctrlKey || metaKey) return null;
  const held = HELD[code];
  if (held !== undefined) return held(shiftKey, altKey);
  if (altKey) return null;
  const part = CLIP_PARTS.find((_, place) => code === `Digit${place + 1}`);
  if (part !== undefined && !repeat) return { do: "arm", part, how: shiftKey ? "beside" : "only" };
  if (key === "?") return { do: "help" };
  if (key === "/") return { do: "search" };
  if (shiftKey) return null;
  const command = PLAIN[code];
  return (command !== undefined || part !== undefined) && repeat ? { do: "nothing" } : (command ?? null);
}
