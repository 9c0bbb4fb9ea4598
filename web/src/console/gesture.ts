/** A hand on a control: drags by mouse, pen and several fingers at once, double taps, wheel and keys. */

import { FINE } from "./scale";

export interface Drag {
  /** The pointer comes down at `x`, `y`: 0..1 across the element, from its left and from its bottom. */
  start(x: number, y: number): void;
  /** It moved by `dx`, `dy` (same units, to the right and up), and is at `x`, `y`; `fine`: Shift is down, and the step already is small. */
  move(dx: number, dy: number, x: number, y: number, fine: boolean): void;
  end(): void;
  /** Twice on the same place within a moment. */
  double?(): void;
}

const DOUBLE_TIME = 350;
const DOUBLE_REACH = 24;

/** Listens to one pointer at a time on `element`; other pointers are free for other controls. */
export function onDrag(element: HTMLElement, drag: Drag): void {
  let pointer: number | null = null;
  let [lastX, lastY, tapX, tapY, tapTime] = [0, 0, 0, 0, Number.NEGATIVE_INFINITY];
  const place = (event: PointerEvent): [number, number] => {
    const box = element.getBoundingClientRect();
    return [(event.clientX - box.left) / box.width, (box.bottom - event.clientY) / box.height];
  };
  const down = (event: PointerEvent): void => {
    if (pointer !== null || event.button !== 0) return;
    pointer = event.pointerId;
    element.setPointerCapture(pointer);
    element.focus({ preventScroll: true });
    event.preventDefault();
    const twice =
      event.timeStamp - tapTime < DOUBLE_TIME && Math.hypot(event.clientX - tapX, event.clientY - tapY) < DOUBLE_REACH;
    [tapX, tapY, tapTime] = [event.clientX, event.clientY, twice ? Number.NEGATIVE_INFINITY : event.timeStamp];
    [lastX, lastY] = place(event);
    drag.start(lastX, lastY);
    if (twice) drag.double?.();
  };
  const move = (event: PointerEvent): void => {
    if (event.pointerId !== pointer) return;
    const [x, y] = place(event);
    const gain = event.shiftKey ? FINE : 1;
    drag.move((x - lastX) * gain, (y - lastY) * gain, x, y, event.shiftKey);
    [lastX, lastY] = [x, y];
  };
  const up = (event: PointerEvent): void => {
    if (event.pointerId !== pointer) return;
    pointer = null;
    drag.end();
  };
  element.addEventListener("pointerdown", down);
  element.addEventListener("pointermove", move);
  element.addEventListener("pointerup", up);
  element.addEventListener("pointercancel", up);
  element.addEventListener("lostpointercapture", up);
  element.addEventListener("contextmenu", (event) => event.preventDefault());
}

/** One notch of the wheel over `element`, up = +1, in tenths with Shift (which some systems turn sideways). */
export function onWheel(element: HTMLElement, turn: (steps: number) => void): void {
  element.addEventListener(
    "wheel",
    (event) => {
      const delta = event.deltaY || event.deltaX;
      if (delta === 0 || event.ctrlKey) return;
      event.preventDefault();
      turn(-Math.sign(delta) * (event.shiftKey ? FINE : 1));
    },
    { passive: false },
  );
}

/** Arrow and page keys as steps to the right and up; `rest` for Home and 0. */
export function onArrows(element: HTMLElement, step: (dx: number, dy: number) => void, rest: () => void): void {
  element.addEventListener("keydown", (event) => {
    if (event.ctrlKey || event.altKey || event.metaKey) return;
    const arrow = ARROWS[event.key];
    if (arrow) {
      const gain = event.shiftKey ? FINE : 1;
      step(arrow[0] * gain, arrow[1] * gain);
    } else if (event.key === "Home" || event.key === "0") rest();
    else return;
    event.preventDefault();
    event.stopPropagation();
  });
}

/** Arrow keys move the focus to the nearest element of a group in that direction. */
export function onRoam(group: HTMLElement, selector: string): void {
  group.addEventListener("keydown", (event) => {
    const arrow = event.key.startsWith("Arrow") ? ARROWS[event.key] : undefined;
    const from = (event.target as Element).closest(selector);
    if (arrow === undefined || from === null || event.ctrlKey || event.altKey || event.metaKey) return;
    const middle = (one: Element): [number, number] => {
      const box = one.getBoundingClientRect();
      return [box.left + box.width / 2, -(box.top + box.height / 2)];
    };
    const [x, y] = middle(from);
    const cost = (one: HTMLElement): number => {
      const [dx, dy] = [middle(one)[0] - x, middle(one)[1] - y];
      const [along, aside] = [dx * arrow[0] + dy * arrow[1], Math.abs(dx * arrow[1]) + Math.abs(dy * arrow[0])];
      return along > 1 ? along + 3 * aside : Number.POSITIVE_INFINITY;
    };
    const others = [...group.querySelectorAll<HTMLElement>(selector)].map((one) => [cost(one), one] as const);
    const [distance, nearest] = others.reduce((best, one) => (one[0] < best[0] ? one : best));
    if (distance < Number.POSITIVE_INFINITY) nearest.focus();
    event.preventDefault();
  });
}

const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowRight: [1, 0],
  ArrowLeft: [-1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
  PageUp: [0, 10],
  PageDown: [0, -10],
};
