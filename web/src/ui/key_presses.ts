/**
 * The one place that decides whom a key press is for: the dialog, menu or form that is open, the field that is typed in,
 * or the page. Escape closes what is open, that alone, and nothing behind it hears it.
 */

import type { ReactiveControllerHost } from "lit";

/** `dialog` and `menu` take every key while they are open, `form` those pressed inside it; a dialog keeps the focus. */
export interface Layer {
  readonly element: HTMLElement;
  readonly kind: "dialog" | "menu" | "form";
  close(): void;
}

export type KeyOwner = "layer" | "field" | "page";

/** What a page does with keys. */
export interface KeyUse {
  /** A key that is heard everywhere but in a field that is typed in; true where it was that key. */
  everywhere?(event: KeyboardEvent): boolean;
  /** A key that no open layer has; `typing`: it was pressed in a field. */
  page(event: KeyboardEvent, typing: boolean): void;
}

const layers: Layer[] = [];
const MARKED = "data-above-layers";

/** Puts a layer over those that are open; gives what takes it away again. */
export function openLayer(layer: Layer): () => void {
  layers.push(layer);
  return () => {
    const at = layers.indexOf(layer);
    if (at >= 0) layers.splice(at, 1);
  };
}

/** Makes an element a layer for as long as it is on the page. */
export function layerWhileShown(
  host: HTMLElement & ReactiveControllerHost,
  kind: Layer["kind"],
  close: () => void,
): void {
  let takeAway = (): void => undefined;
  host.addController({
    hostConnected: () => {
      takeAway = openLayer({ element: host, kind, close });
    },
    hostDisconnected: () => takeAway(),
  });
}

/** True while a key press belongs to a field for text, numbers or a choice. */
export function isTyping(event: Event): boolean {
  const chord = event instanceof KeyboardEvent && (event.ctrlKey || event.metaKey);
  return event.composedPath().some((target) => target instanceof HTMLElement && isField(target, chord));
}

/** A choice has letters, digits and arrows of its own, but nothing to undo. */
function isField(element: HTMLElement, chord: boolean): boolean {
  if (element instanceof HTMLInputElement)
    return !["range", "checkbox", "radio", "button", "submit"].includes(element.type);
  if (element instanceof HTMLSelectElement) return !chord;
  return element instanceof HTMLTextAreaElement || element.isContentEditable;
}

/** Whom a press is for. */
export function ownerOf(event: Event): KeyOwner {
  if (layerOf(event) !== undefined) return "layer";
  return isTyping(event) ? "field" : "page";
}

/** The topmost layer that a press is for. */
function layerOf(event: Event): Layer | undefined {
  return layers.findLast(({ kind, element }) => kind !== "form" || event.composedPath().includes(element));
}

/** Hears all keys of a page; gives what ends it. */
export function listenToKeys(use: KeyUse): () => void {
  const ending = new AbortController();
  const { signal } = ending;
  window.addEventListener("keydown", (event) => claim(event, use), { signal, capture: true });
  window.addEventListener("keydown", (event) => pass(event, use), { signal });
  window.addEventListener("focusin", keepFocus, { signal });
  return () => ending.abort();
}

/** Before any control hears it. */
function claim(event: KeyboardEvent, use: KeyUse): void {
  if (event.isComposing) return;
  if (!isTyping(event) && use.everywhere?.(event) === true) {
    stop(event);
    return;
  }
  const layer = layerOf(event);
  if (layer === undefined) return;
  if (event.key === "Escape") {
    stop(event);
    layer.close();
  } else if (!event.composedPath().includes(layer.element)) withhold(event, layer);
}

/** A key pressed behind an open dialog or menu does nothing there; the browser's own keys stay the browser's. */
function withhold(event: KeyboardEvent, layer: Layer): void {
  event.stopImmediatePropagation();
  if (event.ctrlKey || event.altKey || event.metaKey || /^F\d+$/.test(event.key)) return;
  event.preventDefault();
  if (event.key === "Tab") focusFirst(layer);
}

/** After all controls: what is left is the page's. */
function pass(event: KeyboardEvent, use: KeyUse): void {
  const owner = ownerOf(event);
  if (event.isComposing || owner === "layer") return;
  if (owner === "field" && event.key === "Escape") leaveField(event);
  else use.page(event, owner === "field");
}

/** Out of a field, which is as it was before it was typed in; a search is cleared by the browser. */
function leaveField(event: KeyboardEvent): void {
  const [field] = event.composedPath();
  if (!(field instanceof HTMLElement)) return;
  if (field instanceof HTMLInputElement && field.type !== "search") field.value = entered.get(field) ?? field.value;
  field.blur();
}

/** What fields held when they were entered. */
const entered = new WeakMap<EventTarget, string>();

function keepFocus(event: FocusEvent): void {
  const path = event.composedPath();
  const [target] = path;
  if (target instanceof HTMLInputElement) entered.set(target, target.value);
  const top = layers.findLast(({ kind }) => kind === "dialog");
  if (top === undefined || path.includes(top.element)) return;
  if (!path.some((one) => one instanceof HTMLElement && one.hasAttribute(MARKED))) focusFirst(top);
}

function focusFirst({ element }: Layer): void {
  const root = element.shadowRoot ?? element;
  root.querySelector<HTMLElement>("button, input, select, a[href]")?.focus();
}

function stop(event: KeyboardEvent): void {
  event.preventDefault();
  event.stopImmediatePropagation();
}
