/**
 * The one place that decides whom a key press is for: the dialog, menu or form that is open, the field that is typed in,
 * or the page. Escape closes what is open, that alone, and nothing behind it hears it.
 */

import type { ReactiveControllerHost } from "lit";
import { whileShown } from "./topic_element";

/** `dialog` and `menu` take every key while they are open, `form` those pressed inside it; a dialog keeps the focus. */
export interface KeyLayer {
  readonly element: HTMLElement;
  readonly kind: "dialog" | "menu" | "form";
  close(): void;
  /** A key that it hears wherever the focus is but in a field; true where it was that key. */
  hears?(event: KeyboardEvent): boolean;
}

export type KeyOwner = "layer" | "field" | "page";

/** What a page does with keys. */
export interface KeyUse {
  /** A key that is heard everywhere but in a field for text; true where it was that key. */
  everywhere?(event: KeyboardEvent): boolean;
  /** A key that no open layer has; `typing`: it was pressed in a field. */
  page(event: KeyboardEvent, typing: boolean): void;
}

const layers: KeyLayer[] = [];

/** Puts a layer over those that are open; gives what takes it away again. */
export function openLayer(layer: KeyLayer): () => void {
  layers.push(layer);
  return () => {
    const at = layers.indexOf(layer);
    if (at >= 0) layers.splice(at, 1);
  };
}

/** Makes an element a layer for as long as it is on the page. */
export function layerWhileShown(
  host: HTMLElement & ReactiveControllerHost,
  kind: KeyLayer["kind"],
  close: () => void,
  hears: KeyLayer["hears"] = () => false,
): void {
  whileShown(host, () => openLayer({ element: host, kind, close, hears }));
}

/** True while a key press belongs to a field for text, numbers or a choice. */
export function isTyping(event: Event): boolean {
  const chord = event instanceof KeyboardEvent && (event.ctrlKey || event.metaKey);
  return event.composedPath().some((target) => target instanceof HTMLElement && isField(target, chord));
}

/** Whether keys go to a field now, also to a box, which takes the space bar. */
export function hasFieldFocus(): boolean {
  const focused = focusedElement();
  return focused !== null && (isField(focused, false) || isBox(focused));
}

/** The element that has the focus, in whatever element it stands. */
export function focusedElement(): HTMLElement | null {
  let focused = document.activeElement;
  while (focused?.shadowRoot?.activeElement) focused = focused.shadowRoot.activeElement;
  return focused instanceof HTMLElement ? focused : null;
}

/** A box that is ticked: the space bar is its own. */
export const isBox = (target: EventTarget): boolean => target instanceof HTMLInputElement && target.type === "checkbox";

/** A choice has letters, digits and arrows of its own, but nothing to undo. */
const isField = (element: HTMLElement, chord: boolean): boolean =>
  element instanceof HTMLSelectElement ? !chord : isTextField(element);

function isTextField(target: EventTarget): boolean {
  if (target instanceof HTMLInputElement)
    return !["range", "checkbox", "radio", "button", "submit"].includes(target.type);
  return target instanceof HTMLTextAreaElement || (target instanceof HTMLElement && target.isContentEditable);
}

/** Whom a press is for. */
export function ownerOf(event: Event): KeyOwner {
  if (layerOf(event) !== undefined) return "layer";
  return isTyping(event) ? "field" : "page";
}

/** The topmost layer that a press is for. */
function layerOf(event: Event): KeyLayer | undefined {
  return layers.findLast(({ kind, element }) => kind !== "form" || event.composedPath().includes(element));
}

/** Hears all keys of a page; gives what ends it. */
export function listenToKeys(use: KeyUse): () => void {
  const ending = new AbortController();
  const { signal } = ending;
  window.addEventListener("keydown", (event) => claim(event, use), { signal, capture: true });
  window.addEventListener("keydown", (event) => pass(event, use), { signal });
  window.addEventListener("pointerdown", forget, { signal, capture: true });
  return () => ending.abort();
}

/** Before any control hears it. */
function claim(event: KeyboardEvent, use: KeyUse): void {
  if (event.isComposing) return;
  remember(event);
  if (!event.composedPath().some(isTextField) && use.everywhere?.(event) === true) {
    stop(event);
    return;
  }
  const layer = layerOf(event);
  if (layer === undefined) return;
  if (event.key === "Escape") {
    stop(event);
    layer.close();
  } else if (!isTyping(event) && layer.hears?.(event) === true) stop(event);
  else if (!event.composedPath().includes(layer.element)) withhold(event, layer);
  else if (event.key === "Tab" && layer.kind === "dialog") goRound(event, layer);
}

/** A key pressed behind an open dialog or menu does nothing there; the browser's own keys stay the browser's. */
function withhold(event: KeyboardEvent, layer: KeyLayer): void {
  event.stopImmediatePropagation();
  if (event.ctrlKey || event.altKey || event.metaKey || /^F\d+$/.test(event.key)) return;
  event.preventDefault();
  if (event.key === "Tab") stopsOf(layer)[0]?.focus();
}

/** After all controls: what is left is the page's. */
function pass(event: KeyboardEvent, use: KeyUse): void {
  const owner = ownerOf(event);
  if (event.isComposing || owner === "layer") return;
  if (owner === "field" && event.key === "Escape") leaveField(event);
  else use.page(event, owner === "field");
}

/** Out of a field, which is as it was before it was typed in. */
function leaveField(event: KeyboardEvent): void {
  const [field] = event.composedPath();
  if (!(field instanceof HTMLElement)) return;
  if (field instanceof HTMLInputElement) restoreField(field);
  edited = null;
  field.blur();
}

/**
 * Gives a field what it held before, a search nothing, and tells whoever follows it. The browser would empty a search
 * only after it has lost the focus, and then without an input event.
 */
function restoreField(field: HTMLInputElement): void {
  const typed = field.value;
  if (field.type === "search") field.value = "";
  else if (field === edited?.field) field.value = edited.before;
  if (field.value !== typed) field.dispatchEvent(new Event("input", { bubbles: true, composed: true }));
}

/** The field that is typed in, and what it held before. */
let edited: { readonly field: EventTarget; readonly before: string } | null = null;

function remember(event: KeyboardEvent): void {
  const [field] = event.composedPath();
  if (field instanceof HTMLInputElement && field !== edited?.field) edited = { field, before: field.value };
  if (event.key === "Enter" || event.key === "Tab" || !(field instanceof HTMLInputElement)) edited = null;
}

/** Whoever goes on elsewhere has left the field as it is. */
function forget(event: Event): void {
  if (event.composedPath()[0] !== edited?.field) edited = null;
}

/** What can have the focus in a layer, in order. */
const stopsOf = ({ element }: KeyLayer): HTMLElement[] =>
  stopsIn(element.shadowRoot ?? element).filter((candidate) => candidate.offsetParent !== null);

/** Also those inside the elements that it is made of. */
function stopsIn(root: ParentNode): HTMLElement[] {
  return [...root.querySelectorAll<HTMLElement>("*")].flatMap((element) => [
    ...(element.matches(STOPS) ? [element] : []),
    ...(element.shadowRoot === null ? [] : stopsIn(element.shadowRoot)),
  ]);
}

const STOPS = "button:enabled, input:enabled, select:enabled, a[href]";

/** Tab goes round in a dialog: it never leads behind it. */
function goRound(event: KeyboardEvent, layer: KeyLayer): void {
  const stops = stopsOf(layer);
  const at = stops.findIndex((candidate) => event.composedPath().includes(candidate));
  const edge = event.shiftKey ? 0 : stops.length - 1;
  if (at >= 0 && at !== edge) return;
  event.preventDefault();
  stops.at(event.shiftKey ? -1 : 0)?.focus();
}

function stop(event: KeyboardEvent): void {
  event.preventDefault();
  event.stopImmediatePropagation();
}
