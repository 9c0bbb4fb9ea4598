/** Learn: a control of the page is touched, a control of a device is moved, and the one plays the other. */

import { css, html, nothing } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import type { BindingDocument } from "../../link/messages";
import { base, flow } from "../../ui/theme";
import { hearWhileShown, whileShown } from "../../ui/topic_element";
import { AnimatedElement } from "../controls/console_element";
import { narrow } from "../controls/screen_sizes";
import { GO_TARGET, labelsOf, panicTarget, type Target, targetKey, targetText, whoOf } from "../devices/binding_target";
import type { ConsoleDevices } from "../devices/console_devices";
import type { Topic } from "../store/page_store";
import { type BindableControl, bindingsShown, findControls, seenBox } from "./bindable_controls";

type Bound = ReturnType<typeof bindingsShown>;

/** Milliseconds after which the page is searched again for its controls. */
const SEARCH = 250;

const style = css`
  .spots {
    position: fixed;
    inset: 0;
    z-index: 4;
    overflow: hidden;
    pointer-events: none;
  }
  .spot {
    position: absolute;
    left: 0;
    top: 0;
    min-width: 0;
    min-height: 0;
    padding: 0;
    border: 1.5px dashed var(--focus);
    border-radius: 4px;
    background: #86b9ff1c;
    pointer-events: auto;
    touch-action: none;
  }
  .spot.bound {
    border-style: solid;
  }
  .spot.chosen {
    border: 2px solid var(--attention);
    background: #ffc53d3a;
  }
  .bar {
    position: fixed;
    z-index: 7;
    inset: 6px calc(var(--panic, 252px)) auto 6px;
    min-height: 50px;
    ${flow}
    gap: 4px 8px;
    padding: 4px 10px;
    border: 2px solid var(--focus);
    border-radius: 6px;
    background: #0d1a2b;
    overflow: hidden;
  }
  .bar p {
    flex: 1 1 180px;
    min-width: 0;
  }
  .bar b {
    color: var(--focus);
    letter-spacing: 0.12em;
  }
  .bar .wanted {
    color: var(--attention);
  }
  /* a row of its page, which covers nothing */
  :host([inline]) .bar {
    position: static;
  }
  @media (max-width: 899px) {
    .bar {
      inset: 62px 96px auto;
    }
    :host(:not([inline])) p {
      flex-basis: 100%;
    }
  }
  @media ${narrow} {
    .bar {
      inset: 60px 80px auto;
      padding: 4px 6px;
    }
  }
`;

/** Marks what can be bound, and takes the touches that would play. Tells `close` and `devices`. */
@customElement("omote-learn-mode")
export class LearnMode extends AnimatedElement {
  /** Where the controls are. */
  @property({ attribute: false }) page!: ParentNode;
  /** Whether its bar has a row of the page, which has GO among its controls. */
  @property({ type: Boolean, reflect: true }) inline = false;
  @state() private controls: readonly BindableControl[] = [];
  /** What was touched last, and its axes where it has several. */
  @state() private chosen: readonly Target[] = [];
  @query(".spots") private layer!: HTMLElement;
  #searched = Number.NEGATIVE_INFINITY;

  private get devices(): ConsoleDevices {
    return this.context.devices;
  }

  static override styles = [base, style];

  protected override readonly topics: readonly Topic[] = ["binding_list", "devices", "link"];

  protected override changed(topic: Topic): void {
    if (topic === "link") this.close();
    else super.changed(topic);
  }

  constructor() {
    super();
    hearWhileShown(this, window, ["keydown"], ({ key }: KeyboardEvent) => key === "Escape" && this.close());
    whileShown(this, () => () => this.devices.stopLearning());
  }

  override firstUpdated(): void {
    this.renderRoot.querySelector<HTMLElement>(".close")?.focus();
  }

  override render() {
    const bound = bindingsShown(this.devices.bindings, this.store);
    return html`
      <div class="spots">${this.controls.map((control) => this.#spot(control, bound))}</div>
      <div class="bar" role="region" aria-label="Learn">
        <p role="status">${this.#says()}</p>
        ${this.#axes()} ${this.#deletion()}
        <button data-learn="panic" title="A key of a device that is panic" @click=${() => this.#choose([panicTarget(this.#who)])}>Bind panic</button>
        ${this.inline ? nothing : html`<button data-learn="go" title="A key of a device that is GO of the cues" @click=${() => this.#choose([GO_TARGET])}>Bind GO</button>`}
        <button data-learn="devices" title="All devices and bindings" @click=${() => this.tell("devices")}>Bindings</button>
        <button class="close" @click=${() => this.close()}>Done</button>
      </div>
    `;
  }

  #spot({ targets }: BindableControl, bound: Bound) {
    const of = targets.flatMap((target) => bound.get(targetKey(target)) ?? []);
    const chosen = this.#chosenKey !== "" && targets.some((target) => targetKey(target) === this.#chosenKey);
    const what = this.#text(targets[0] as Target);
    const by = of.length === 0 ? "" : `: ${of.map(({ device, control }) => `${device} ${control}`).join(", ")}`;
    return html`<button class="spot ${of.length > 0 ? "bound" : ""} ${chosen ? "chosen" : ""}" data-to=${(targets[0] as Target).to}
      title="${what}${by}" aria-label="Learn ${what}${by}" @click=${() => this.#choose(targets)}></button>`;
  }

  /** The first target of what was touched is learned; a touch of the same again: the next. */
  #choose(targets: readonly Target[]): void {
    const at = targets.findIndex((target) => targetKey(target) === this.#chosenKey);
    const next = targets[(at + 1) % targets.length] as Target;
    this.chosen = [next, ...targets.filter((target) => target !== next)];
    this.devices.learn(next);
  }

  get #chosenKey(): string {
    return this.chosen[0] === undefined ? "" : targetKey(this.chosen[0]);
  }

  get #who(): string {
    return whoOf(this.store.played.targets);
  }

  #text(target: Target): string {
    return targetText(target, labelsOf(this.store));
  }

  #says() {
    const { learning, devices } = this.devices;
    const [chosen] = this.chosen;
    if (chosen !== undefined && learning !== null && targetKey(learning) === targetKey(chosen))
      return html`<b>LEARN</b> <span class="wanted">${this.#text(chosen)}: move a dial, key or stick.</span>`;
    const of = this.#playing;
    if (chosen !== undefined && of.length > 0) return html`<b>LEARN</b> ${this.#played(chosen, of)}`;
    if (!devices.some(({ plugged }) => plugged))
      return html`<b>LEARN</b> <span class="wanted">No device is plugged in: see Bindings.</span>`;
    return html`<b>LEARN</b> Touch a control, then move a dial, key or stick of a device.`;
  }

  /** The axes of a pad. */
  #axes() {
    if (this.chosen.length < 2) return nothing;
    const axes = [...this.chosen].sort((a, b) => a.axis.localeCompare(b.axis) * -1);
    return axes.map(
      (target) => html`<button data-axis=${target.axis} aria-pressed=${targetKey(target) === this.#chosenKey}
        @click=${() => this.#choose([target, ...this.chosen.filter((other) => other !== target)])}>${target.axis}</button>`,
    );
  }

  /** The bindings of what was touched last. */
  get #playing(): readonly BindingDocument[] {
    return bindingsShown(this.devices.bindings, this.store).get(this.#chosenKey) ?? [];
  }

  /** What else the same controls play. */
  #others(bindings: readonly BindingDocument[]): BindingDocument[] {
    const same = (binding: BindingDocument, other: BindingDocument): boolean =>
      binding.device === other.device && binding.control === other.control && binding.bank === other.bank;
    return this.devices.bindings.filter(
      (binding) => !bindings.includes(binding) && bindings.some((other) => same(binding, other)),
    );
  }

  #played(target: Target, bindings: readonly BindingDocument[]): string {
    const by = bindings.map(({ device, control }) => `${device} ${control}`).join(", ");
    const also = this.#others(bindings).map((binding) => this.#text(binding));
    const plays = also.length === 0 ? "Touch the next." : `That also plays ${also.join(", ")}.`;
    return `${this.#text(target)} is played by ${by}. ${plays}`;
  }

  #deletion() {
    const mayGo = (binding: BindingDocument): boolean => !this.devices.isFixed(binding);
    const [of, others] = [this.#playing.filter(mayGo), this.#others(this.#playing).filter(mayGo)];
    return html`${others.length === 0 ? nothing : html`<button data-learn="alone" title="Takes away what else it plays" @click=${() => this.#unbind(others)}>This alone</button>`}
      ${of.length === 0 ? nothing : html`<button data-learn="unbind" @click=${() => this.#unbind(of)}>Unbind</button>`}`;
  }

  #unbind(bindings: readonly BindingDocument[]): void {
    for (const binding of bindings) this.devices.unbind(binding);
  }

  /** The marks follow what they mark: panels scroll, sizes change. */
  paint(now: number): void {
    if (now - this.#searched > SEARCH) {
      this.#searched = now;
      this.#search();
    }
    const spots = this.layer.children;
    for (const [index, { element }] of this.controls.entries()) {
      const spot = spots[index] as HTMLElement | undefined;
      if (spot === undefined) return; // not rendered yet
      const box = seenBox(element);
      spot.hidden = box === null;
      if (box === null) continue;
      spot.style.transform = `translate(${box.left}px, ${box.top}px)`;
      spot.style.width = `${box.right - box.left}px`;
      spot.style.height = `${box.bottom - box.top}px`;
    }
  }

  #search(): void {
    const controls = findControls(this.page, this.store);
    const same =
      controls.length === this.controls.length &&
      controls.every((control, index) => isSame(control, this.controls[index]));
    if (!same) this.controls = controls;
  }
}

const isSame = (control: BindableControl, other: BindableControl | undefined): boolean =>
  other !== undefined &&
  control.element === other.element &&
  JSON.stringify(control.targets) === JSON.stringify(other.targets);
