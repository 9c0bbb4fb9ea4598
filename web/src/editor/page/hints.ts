/** The one line under the faces: what the hand does now, in words for the hand that there is. */

import type { DraftStore } from "../session/draft_store";
import type { Options, Tool } from "../session/editor_store";

/** For each tool what a mouse does, and what a finger does. */
const TOOLS: Readonly<Record<Tool, readonly [string, string]>> = {
  drag: [
    "Drag a white pin (a needle): the skin and all other faces follow. Shift and click: several. Alt: off the skin. Arrow keys: nudge.",
    "Drag a white pin (a needle): the skin under it follows, and so do all other faces. Pull takes it off the skin.",
  ],
  pull: [
    "Drag a needle to pull the skin out or push it in: along the needle, or, where it points at you, up for out and down for in.",
    "Drag a needle to pull the skin out or push it in: along the needle, or, where it points at you, up for out and down for in.",
  ],
  add: [
    "Click on the face to set another needle there. The expression stays as it is.",
    "Tap the face to set another needle there. The expression stays as it is.",
  ],
  remove: [
    "Click a needle to take it away. The expression stays as it is.",
    "Tap a needle to take it away. The expression stays as it is.",
  ],
  place: [
    "Drag a needle along the face at rest to where you want to hold it. The expression stays as it is.",
    "Drag a needle along the face at rest to where you want to hold it. The expression stays as it is.",
  ],
};
const CLOSED = [
  "Drag beside the face to turn it; the wheel brings it closer.",
  "Drag beside the face to turn it; two fingers bring it closer.",
] as const;
const FACES = [
  "Drag a white knob (a handle): the face follows. Its mix, parts of others and caricature stand under Recipe.",
  "Drag a white knob (a handle): the face follows. Its mix, parts of others and caricature stand under Recipe.",
] as const;

const POSES = [
  "Drag a white knob (a grip): the joints follow, on every body. Drag beside them to turn the figures. Joints, one by one, on the right.",
  "Drag a white knob (a grip): the joints follow, on every body. Drag beside them to turn the figures. Joints, one by one, below.",
] as const;

type HintedState = Pick<DraftStore, "draft" | "net"> &
  Partial<Pick<DraftStore, "pose">> & { readonly options: Pick<Options, "tool"> };

export function hintOf({ draft, net, pose, options }: HintedState, fingers: boolean): string {
  const [mouse, finger] = draft === null ? CLOSED : pose ? POSES : net === null ? FACES : TOOLS[options.tool];
  return fingers ? finger : mouse;
}
