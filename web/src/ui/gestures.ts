/** A hand on a control: drags by mouse, pen and several fingers at once, double taps, wheel and keys. */

import { FINE, type Range, within } from "./travel";

export interface Drag {
  /** The pointer comes down at `x`, `y`: 0..1 across the element, from its left and from its bottom. */
  start(x: number, y: number): void;
  /** It moved by `dx`, `dy` (same units, to the right and up); a tenth of it while Shift is down. */
  move(dx: number, dy: number): void;
  end(): void;
  /** Twice on the same place within a moment. */
  double?(): void;
}

const DOUBLE_TIME = 350;
const DOUBLE_REACH = 24;

/** Listens to one pointer at a time on `element`; other pointers are free for other controls. */
export function onDrag(element: HTMLElement, drag: Drag): void {
  const hand = new Hand(element, drag);
  element.addEventListener("pointerdown", (event) => hand.down(event));
  element.addEventListener("pointermove", (event) => hand.move(event));
  for (const end of ["pointerup", "pointercancel", "lostpointercapture"] as const)
    element.addEventListener(end, (event) => hand.up(event));
  element.addEventListener("contextmenu", (event) => event.preventDefault());
}

/** One pointer on one control, from its way down to its end. */
class Hand {
  #pointer: number | null = null;
  #last: [number, number] = [0, 0];
  #tap = { x: 0, y: 0, time: Number.NEGATIVE_INFINITY };

  constructor(
    private readonly element: HTMLElement,
    private readonly drag: Drag,
  ) {}

  down(event: PointerEvent): void {
    if (this.#pointer !== null || event.button !== 0) return;
    this.#pointer = event.pointerId;
    this.element.setPointerCapture(this.#pointer);
    this.element.focus({ preventScroll: true });
    event.preventDefault();
    const twice = this.#isSecond(event);
    this.#last = this.#place(event);
    this.drag.start(...this.#last);
    if (twice) this.drag.double?.();
  }

  move(event: PointerEvent): void {
    if (event.pointerId !== this.#pointer) return;
    const [x, y] = this.#place(event);
    const gain = event.shiftKey ? FINE : 1;
    this.drag.move((x - this.#last[0]) * gain, (y - this.#last[1]) * gain);
    this.#last = [x, y];
  }

  up(event: PointerEvent): void {
    if (event.pointerId !== this.#pointer) return;
    this.#pointer = null;
    this.drag.end();
  }

  #place(event: PointerEvent): [number, number] {
    return placeIn(this.element.getBoundingClientRect(), event.clientX, event.clientY, this.#last);
  }

  /** Whether this tap follows one on the same place; a third one then starts anew. */
  #isSecond({ clientX: x, clientY: y, timeStamp: time }: PointerEvent): boolean {
    const near = Math.hypot(x - this.#tap.x, y - this.#tap.y) < DOUBLE_REACH;
    const twice = near && time - this.#tap.time < DOUBLE_TIME;
    this.#tap = { x, y, time: twice ? Number.NEGATIVE_INFINITY : time };
    return twice;
  }
}

/**
 * Where a pointer is across a box: 0..1 from its left and from its bottom. A side without a length has no places: the
 * pointer stays at its last one, so a control that is folded away, or is folded away under a hand, never moves.
 */
export function placeIn(
  box: Pick<DOMRect, "left" | "bottom" | "width" | "height">,
  x: number,
  y: number,
  last: readonly [number, number],
): [number, number] {
  return [
    box.width > 0 ? (x - box.left) / box.width : last[0],
    box.height > 0 ? (box.bottom - y) / box.height : last[1],
  ];
}

/** Milliseconds after which a finger that stays holds. */
const HOLD_TIME = 500;
const HOLD_REACH = 10;

/** A finger that stays on an element of a group: `held` is called, and lifting it is no click. A mouse never holds. */
export function onHold(group: HTMLElement, selector: string, held: (element: HTMLElement) => void): void {
  let [waiting, swallow]: [ReturnType<typeof setTimeout> | undefined, boolean] = [undefined, false];
  let from = { x: 0, y: 0 };
  const end = (): void => clearTimeout(waiting);
  group.addEventListener("pointerdown", (event) => {
    end();
    swallow = false;
    const element = (event.target as Element).closest<HTMLElement>(selector);
    if (element === null || event.pointerType === "mouse") return;
    from = { x: event.clientX, y: event.clientY };
    waiting = setTimeout(() => {
      swallow = true;
      held(element);
    }, HOLD_TIME);
  });
  group.addEventListener("pointermove", ({ clientX: x, clientY: y }) => {
    if (Math.hypot(x - from.x, y - from.y) > HOLD_REACH) end();
  });
  for (const over of ["pointerup", "pointercancel"] as const) group.addEventListener(over, end);
  group.addEventListener("contextmenu", (event) => swallow && event.preventDefault());
  group.addEventListener("click", (event) => swallow && stopClick(event), { capture: true });
}

function stopClick(event: Event): void {
  event.preventDefault();
  event.stopPropagation();
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
    const arrow = ARROWS[event.key] ?? PAGES[event.key];
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
    const arrow = ARROWS[event.key];
    const from = (event.target as Element).closest(selector);
    if (arrow === undefined || from === null || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    const others = [...group.querySelectorAll<HTMLElement>(selector)].map(
      (element) => [way(from, element, arrow), element] as const,
    );
    const [distance, nearest] = others.reduce((best, candidate) => (candidate[0] < best[0] ? candidate : best));
    if (distance < Number.POSITIVE_INFINITY) nearest.focus();
  });
}

/** How far it is from one element to another in a direction; steps aside count three times, back is infinitely far. */
function way(from: Element, to: Element, [right, up]: readonly [number, number]): number {
  const [dx, dy] = [middle(to)[0] - middle(from)[0], middle(from)[1] - middle(to)[1]];
  const [along, aside] = [dx * right + dy * up, Math.abs(dx * up) + Math.abs(dy * right)];
  return along > 1 ? along + 3 * aside : Number.POSITIVE_INFINITY;
}

function middle(element: Element): [number, number] {
  const box = element.getBoundingClientRect();
  return [box.left + box.width / 2, box.top + box.height / 2];
}

/** The arrow keys, as steps to the right and up. */
export const ARROWS: Readonly<Record<string, readonly [number, number]>> = {
  ArrowRight: [1, 0],
  ArrowLeft: [-1, 0],
  ArrowUp: [0, 1],
  ArrowDown: [0, -1],
};
const PAGES: typeof ARROWS = { PageUp: [0, 10], PageDown: [0, -10] };

/** What of a keyboard event the tables of keys read. */
export interface KeyPress {
  readonly key: string;
  readonly code: string;
  readonly ctrlKey: boolean;
  readonly altKey: boolean;
  readonly metaKey: boolean;
  readonly shiftKey: boolean;
  readonly repeat: boolean;
}

/** Hears clicks before others: a double click's second does nothing where something else has come into the first's place. */
export function strayClickStopper(): (
  event: Pick<MouseEvent, "detail" | "composedPath" | "stopPropagation" | "preventDefault">,
) => void {
  let clicked: EventTarget | undefined;
  return (event) => {
    const [target] = event.composedPath();
    if (event.detail < 2) clicked = target;
    else if (target !== clicked) {
      event.stopPropagation();
      event.preventDefault();
    }
  };
}

/** A value that one hand at a time has. */
export interface Gripped {
  value(now: number): number;
  gripped(): boolean;
  grip(value: number): void;
  leave(): void;
}

/** What a drag asks of its fader; what a name or a property says now is asked anew each time. */
export interface DraggedFader {
  readonly knob: () => Gripped;
  /** Rises with each panic (`ConsoleStore.era`). */
  readonly era: () => number;
  /** The way of the handle from end to end. */
  readonly range: Range;
  /** Where on that way a value stands, and the value there; the same where a fader has no rests. */
  readonly travelOf?: (value: number) => number;
  readonly valueAt?: (travel: number) => number;
  /** Twice in the same place: the value of rest. */
  readonly rest: () => void;
}

const same = (value: number): number => value;

/** The drag of an upright fader: from what is on air, under one hand, until a panic takes it off. */
export function faderDrag({ knob, era, range, travelOf = same, valueAt = same, rest }: DraggedFader): Drag {
  let [travel, begun] = [0, 0];
  const read = (): void => {
    travel = travelOf(knob().value(performance.now()));
  };
  return {
    start: () => {
      begun = era();
      read();
    },
    move: (_dx, dy) => {
      if (begun !== era() || dy === 0) return;
      if (!knob().gripped()) read(); // no hand is on it yet, or no more (a lost link, another's hand): from what is on air
      travel = within(travel + dy * (range.high - range.low), range);
      knob().grip(valueAt(travel));
    },
    end: () => knob().leave(),
    double: () => {
      rest();
      read();
    },
  };
}

/** A press that plays counts as the finger comes down; by the keyboard as a click. */
export const pressed = (act: () => void) => ({
  down: (event: PointerEvent): void => {
    if (event.button === 0) act();
  },
  click: (event: MouseEvent): void => {
    if (event.detail === 0) act();
  },
});
