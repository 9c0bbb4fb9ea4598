/** Marks over the controls that a device plays: the name of its control, and where that waits to be picked up. */

import { css, html } from "lit";
import { customElement, property, query } from "lit/decorators.js";
import type { BindingDocument } from "../../link/messages";
import { base } from "../../ui/theme";
import { AnimatedElement } from "../controls/console_element";
import { shortControls, targetKey } from "../devices/binding_target";
import type { ConsoleDevices } from "../devices/console_devices";
import type { Topic } from "../store/page_store";
import {
  type BindableControl,
  bindingsShown,
  findControls,
  findPanic,
  markHeight,
  type PageBox,
  seenBox,
} from "./bindable_controls";

/** Milliseconds after which the page is searched again for its controls. */
const SEARCH = 400;

interface Mark {
  readonly control: BindableControl;
  readonly bindings: readonly BindingDocument[];
  readonly chip: HTMLElement;
  readonly waiting: HTMLElement;
}

const style = css`
  .marks {
    position: fixed;
    inset: 0;
    z-index: 2;
    overflow: hidden;
    pointer-events: none;
  }
  .chip,
  .waiting {
    position: absolute;
    left: 0;
    top: 0;
    pointer-events: none;
  }
  .chip {
    padding: 0 3px;
    border-radius: 3px;
    font-size: 10px;
    font-weight: 600;
    line-height: 13px;
    white-space: nowrap;
    color: #000;
    background: var(--focus);
  }
  .chip.gone {
    color: var(--dim);
    background: var(--edge);
  }
  .waiting {
    height: 4px;
    margin-top: -2px;
    border-radius: 2px;
    background: var(--attention);
    box-shadow: 0 0 0 1px #000;
  }
`;

/** Lies over the panels, below every dialog, and takes no touch. */
@customElement("omote-binding-marks")
export class BindingMarks extends AnimatedElement {
  /** Where the controls are. */
  @property({ attribute: false }) page!: ParentNode;
  @query(".marks") private layer!: HTMLElement;
  #marks: readonly Mark[] = [];
  #searched = Number.NEGATIVE_INFINITY;

  private get devices(): ConsoleDevices {
    return this.context.devices;
  }

  static override styles = [base, style];

  protected override readonly topics: readonly Topic[] = ["binding_list", "characters"];

  /** The page is searched again. */
  protected override changed(): void {
    this.#searched = Number.NEGATIVE_INFINITY;
  }

  override render() {
    return html`<div class="marks" aria-hidden="true"></div>`;
  }

  paint(now: number): void {
    if (this.devices.bindings.length === 0 && this.#marks.length === 0) return;
    if (now - this.#searched > SEARCH) this.#search(now);
    for (const mark of this.#marks) this.#place(mark);
  }

  #search(now: number): void {
    this.#searched = now;
    const of = bindingsShown(this.devices.bindings, this.store);
    const controls = [...findControls(this.page, this.store), ...findPanic(this.page, this.store)];
    const boundControls = controls.flatMap((control) => {
      const bindings = control.targets.flatMap((target) => of.get(targetKey(target)) ?? []);
      return bindings.length === 0 ? [] : [{ control, bindings }];
    });
    for (const { chip, waiting } of this.#marks) {
      chip.remove();
      waiting.remove();
    }
    this.#marks = boundControls.map((bound) => ({
      ...bound,
      chip: this.#make("chip"),
      waiting: this.#make("waiting"),
    }));
  }

  #make(kind: string): HTMLElement {
    const element = document.createElement("span");
    element.className = kind;
    return this.layer.appendChild(element);
  }

  #place({ control, bindings, chip, waiting }: Mark): void {
    const box = seenBox(control.element);
    chip.hidden = box === null;
    waiting.hidden = true;
    if (box === null) return;
    const there = bindings.filter(({ device }) => this.devices.device(device)?.plugged === true);
    const text = shortControls(
      bindings,
      this.devices.bindings.map(({ device }) => device),
    );
    if (chip.textContent !== text) chip.textContent = text;
    chip.classList.toggle("gone", there.length === 0);
    const place = placeOf(control.element, box);
    if (chip.style.transform !== place) chip.style.transform = place;
    const whole = control.element.getBoundingClientRect();
    const height = control.travel === null ? null : this.#waits(there, control.travel);
    if (height === null || whole.height > box.bottom - box.top + 1) return;
    waiting.hidden = false;
    waiting.style.width = `${whole.width}px`;
    waiting.style.transform = `translate(${whole.left}px, ${whole.bottom - height * whole.height}px)`;
  }

  /** Where the control of a fader stands that waits to be picked up; null where none waits. */
  #waits(bindings: readonly BindingDocument[], travel: NonNullable<BindableControl["travel"]>): number | null {
    for (const { device, control, low, high, curve } of bindings) {
      const state = this.devices.device(device);
      const position = state?.values[control];
      if (state?.waiting[control] === undefined || position === undefined) continue;
      const [from, to] = [low ?? 0, high ?? 1];
      return markHeight(from + (to - from) * position ** curve, travel);
    }
    return null;
  }
}

/** Where the name of a control's device stands, so that it covers nothing that is read: as a style. */
function placeOf(element: Element, { left, top, right, bottom }: PageBox): string {
  const [x, y] = [Math.round(right - 1), Math.round(bottom - 14)];
  if (element.matches(".tile")) return `translate(calc(${x}px - 100%), ${Math.round(top + 1)}px)`; // name below, key left
  if (element.matches(".field")) return `translate(calc(${x}px - 100%), ${y}px)`; // its degrees stand at the left
  return `translate(${Math.round(left + 1)}px, ${y}px)`;
}
