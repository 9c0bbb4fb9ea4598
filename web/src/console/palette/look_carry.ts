/** A tile that a finger carries onto a pad: browsers drag what they can for a mouse, and not all of them for a finger. */

import type { LookKind } from "../store/axis";

/** Milliseconds after which a finger that stays on a tile takes it along; before that it scrolls. */
const PICK_UP = 250;
const REACH = 10;

/** What a finger carries, and where it is in the page. */
export interface CarriedLook {
  readonly kind: LookKind;
  readonly name: string;
  readonly x: number;
  readonly y: number;
}

/** Told to the pad under the finger: that it is over it, that it has left, that it let go there. */
export const CARRIED = { over: "look-over", out: "look-out", drop: "look-drop" } as const;

/** Carries the tiles of a list by touch and pen while `may` says so; they are dropped on what has this tag. */
export class LookCarry {
  #waiting: ReturnType<typeof setTimeout> | undefined;
  #from = { x: 0, y: 0 };
  #pointer: number | null = null;
  #ghost: HTMLElement | null = null;
  #name = "";
  #over: Element | null = null;
  #swallows = false;

  constructor(
    list: HTMLElement,
    private readonly kind: () => LookKind,
    private readonly tag: string,
    private readonly may: () => boolean,
  ) {
    list.addEventListener("pointerdown", (event) => this.#down(event));
    list.addEventListener("pointermove", (event) => this.#move(event));
    list.addEventListener("pointerup", (event) => this.#up(event, true));
    list.addEventListener("pointercancel", (event) => this.#up(event, false));
    list.addEventListener("touchmove", (event) => this.carries && event.preventDefault(), { passive: false });
    list.addEventListener("dragstart", (event) => this.carries && event.preventDefault());
    list.addEventListener("click", (event) => this.#swallows && swallow(event), { capture: true });
  }

  /** Whether a finger has a tile now. */
  get carries(): boolean {
    return this.#ghost !== null;
  }

  #down(event: PointerEvent): void {
    this.#swallows = false;
    const tile = (event.target as Element).closest<HTMLElement>(".tile");
    if (tile === null || event.pointerType === "mouse" || this.#pointer !== null || !this.may()) return;
    this.#pointer = event.pointerId;
    this.#from = { x: event.clientX, y: event.clientY };
    this.#waiting = setTimeout(() => this.#pickUp(tile), PICK_UP);
  }

  #pickUp(tile: HTMLElement): void {
    this.#name = tile.dataset.name ?? "";
    const ghost = document.createElement("span");
    ghost.textContent = tile.querySelector(".name")?.textContent ?? this.#name;
    ghost.style.cssText = GHOST;
    this.#ghost = document.body.appendChild(ghost);
    this.#swallows = true;
    this.#show(this.#from.x, this.#from.y);
  }

  #move({ pointerId, clientX: x, clientY: y }: PointerEvent): void {
    if (pointerId !== this.#pointer) return;
    if (this.#ghost === null) {
      if (Math.hypot(x - this.#from.x, y - this.#from.y) > REACH) this.#end();
      return;
    }
    this.#show(x, y);
    const under = elementAt(x, y, this.tag);
    if (this.#over !== under) this.#over?.dispatchEvent(new CustomEvent(CARRIED.out));
    this.#over = under;
    this.#tell(CARRIED.over, x, y);
  }

  #up({ pointerId, clientX: x, clientY: y }: PointerEvent, lets: boolean): void {
    if (pointerId !== this.#pointer) return;
    if (this.#ghost !== null) this.#tell(lets ? CARRIED.drop : CARRIED.out, x, y);
    this.#end();
  }

  #tell(what: string, x: number, y: number): void {
    const detail: CarriedLook = { kind: this.kind(), name: this.#name, x, y };
    this.#over?.dispatchEvent(new CustomEvent<CarriedLook>(what, { detail }));
  }

  #show(x: number, y: number): void {
    if (this.#ghost !== null) this.#ghost.style.transform = `translate(${x}px, ${y}px) translate(-50%, -130%)`;
  }

  #end(): void {
    clearTimeout(this.#waiting);
    this.#ghost?.remove();
    [this.#ghost, this.#over, this.#pointer] = [null, null, null];
  }
}

/** Above the finger, which would hide it. */
const GHOST =
  "position:fixed;z-index:20;left:0;top:0;padding:6px 12px;border-radius:6px;font-weight:700;color:#000;background:#86b9ff;pointer-events:none";

/** The element of a tag under a place of the page, in whatever element it stands. */
function elementAt(x: number, y: number, tag: string): Element | null {
  let found = document.elementFromPoint(x, y);
  while (found !== null && found.localName !== tag) {
    const inner: Element | null = found.shadowRoot?.elementFromPoint(x, y) ?? null;
    if (inner === null || inner === found) return null;
    found = inner;
  }
  return found;
}

/** A tile that was carried is not called. */
function swallow(event: Event): void {
  event.preventDefault();
  event.stopPropagation();
}
