/** A tile that is dragged from a palette onto a pad. */

import type { LookKind } from "../store/axis";

/** What the drag of a tile carries; browsers tell its type, and not what it says, before it is dropped. */
const TYPE: Readonly<Record<LookKind, string>> = {
  face: "application/x-omote-face",
  expression: "application/x-omote-expression",
  pose: "application/x-omote-pose",
};

/** Begins the drag of a face, an expression or a pose. */
export function carryLook(event: DragEvent, kind: LookKind, name: string): void {
  event.dataTransfer?.setData(TYPE[kind], name);
  if (event.dataTransfer !== null) event.dataTransfer.effectAllowed = "copy";
}

/** Whether what is over a pad is of its kind. */
export const carries = (event: DragEvent, kind: LookKind): boolean =>
  event.dataTransfer?.types.includes(TYPE[kind]) ?? false;

/** The name of what was dropped; "" for nothing of this kind. */
export const droppedLook = (event: DragEvent, kind: LookKind): string => event.dataTransfer?.getData(TYPE[kind]) ?? "";
