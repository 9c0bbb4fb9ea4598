/** A macro learned by touch: its name, the control that moves, and what is touched meanwhile; the faders play all the time. */

import { css, html, nothing } from "lit";
import { customElement, property } from "lit/decorators.js";
import { MOST_TARGETS } from "../../link/constants";
import type { MacroMapping } from "../../link/messages";
import { base, flow } from "../../ui/theme";
import { hearWhileShown, whileShown } from "../../ui/topic_element";
import { narrow } from "../controls/screen_sizes";
import { characterOf, macroTarget, targetKey } from "../devices/binding_target";
import type { Topic } from "../store/page_store";
import { reading, targetLabel } from "./macro_targets";
import { MappingsElement } from "./mappings_element";

const style = css`
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
  }
  p {
    flex: 1 1 220px;
    min-width: 0;
    overflow-wrap: anywhere;
  }
  b {
    color: var(--focus);
  }
  .wanted {
    color: var(--attention);
  }
  @media (max-width: 899px) {
    .bar {
      inset: 62px 96px auto;
    }
    p {
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

/** Tells `close`. */
@customElement("omote-mapping-learning")
export class MappingLearning extends MappingsElement {
  @property() name = "";
  /** What was there under the name. */
  #before: MacroMapping | null = null;
  #began = false;

  static override styles = [base, style];
  protected override readonly topics: readonly Topic[] = ["mapping_learned", "binding_list", "link", "manifest"];

  constructor() {
    super();
    hearWhileShown<KeyboardEvent>(this, window, ["keydown"], (event) => event.key === "Escape" && this.#end(true));
    whileShown(this, () => () => this.context.devices.stopLearning());
  }

  override firstUpdated(): void {
    const { store, mappings, name } = this;
    this.#before = mappings.list.find((mapping) => mapping.name === name) ?? null;
    const { character } = mappings;
    store.play([character]); // who is taught has the faders
    store.ask({ type: "learn_mapping", character, name }, { refused: () => this.close() });
    this.context.devices.learn(macroTarget(character, name));
    this.renderRoot.querySelector<HTMLElement>(".done")?.focus();
  }

  /** It ends by itself where nothing is touched for a minute, or where the link is lost. */
  protected override changed(topic: Topic): void {
    if (topic === "link" && !this.store.online) this.close();
    else if (topic === "mapping_learned") this.#follow();
    super.changed(topic);
  }

  #follow(): void {
    const learned = this.#own;
    if (learned !== null) this.#began = true;
    else if (this.#began) this.close();
  }

  get #own() {
    const { learned } = this.mappings;
    return learned !== null && learned.name === this.name && learned.by === this.store.name ? learned : null;
  }

  override render() {
    const targets = this.#own?.targets ?? [];
    return html`<div class="bar" role="region" aria-label="Learn a macro">
      <p role="status"><b>LEARN ${this.name}</b> ${this.#control()} ${
        targets.length === 0
          ? html`<span class="wanted">Touch what it shall play: faders of channels, head, gaze.</span>`
          : html`${targets.map(({ to, high }) => html`<span data-touched=${to}>${targetLabel(to, (name) => this.store.label("expression", name))} ${reading(to, high)}</span>, `)}
            ${targets.length >= MOST_TARGETS ? "which is as many as a macro plays." : html`<span class="wanted">${targets.length} of ${MOST_TARGETS}: touch more, or Done.</span>`}`
      }</p>
      <button class="done" title="Keeps it (Escape)" @click=${() => this.#end(true)}>Done</button>
      <button data-discard @click=${() => this.#end(false)}>Discard</button>
    </div>`;
  }

  /** Which control of a device plays it, or that one is waited for. */
  #control() {
    const { learning, bindings, devices } = this.context.devices;
    const target = macroTarget(this.mappings.character, this.name);
    const bound = bindings.filter(
      ({ to }) => to.endsWith(`/macro/${this.name}`) && characterOf(to) === characterOf(target.to),
    );
    if (bound.length > 0)
      return html`<span data-control>by ${bound.map(({ device, control }) => `${device} ${control}`).join(", ")}.</span>`;
    if (learning === null || targetKey(learning) !== targetKey(target) || !devices.some(({ plugged }) => plugged))
      return nothing;
    return html`<span class="wanted" data-control>Move the dial or stick that shall play it.</span>`;
  }

  #end(keep: boolean): void {
    const targets = this.#own?.targets ?? [];
    this.store.ask({ type: "finish_mapping", keep });
    if (keep && targets.length > 0) this.mappings.noteLearned({ name: this.name, targets, when: null }, this.#before);
    else
      this.store.say(keep ? `Nothing was touched: ${this.name} is as before.` : `${this.name} is not learned.`, "done");
    this.close();
  }
}
