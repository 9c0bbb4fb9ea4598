/** A tile that is dragged from a palette onto a pad. */

import type { Axis } from "../store/axis";

/** What the drag of a tile carries; browsers tell its type, and not what it says, before it is dropped. */
const TYPE: Readonly<Record<Axis, string>> = {
  face: "application/x-omote-face",
  expression: "application/x-omote-expression",
};

/** Begins the drag of a face or an expression. */
export function carryLook(event: DragEvent, axis: Axis, name: string): void {
  event.dataTransfer?.setData(TYPE[axis], name);
  if (event.dataTransfer !== null) event.dataTransfer.effectAllowed = "copy";
}

/** Whether what is over a pad is of its kind. */
export const carries = (event: DragEvent, axis: Axis): boolean =>
  event.dataTransfer?.types.includes(TYPE[axis]) ?? false;

/** The name of what was dropped; "" for nothing of this kind. */
export const droppedLook = (event: DragEvent, axis: Axis): string => event.dataTransfer?.getData(TYPE[axis]) ?? "";
