/** What plays a macro: the controls of devices that are bound to it, the next one that moves, and how each plays. */

import { css, html, nothing } from "lit";
import { customElement, property } from "lit/decorators.js";
import type { BindingDocument } from "../../link/messages";
import { base, flow } from "../../ui/theme";
import { characterOf, macroTarget, targetKey } from "../devices/binding_target";
import type { Topic } from "../store/page_store";
import { MappingsElement } from "./mappings_element";
import type { NumberTyped } from "./number_field";
import "./number_field";

/** Of the way of a stick, to either side of its middle. */
const WIDEST_DEAD_ZONE = 0.45;

const style = css`
  :host {
    display: grid;
    gap: 4px;
  }
  .row {
    ${flow}
    gap: 4px 8px;
    align-items: end;
  }
  .row b {
    flex: 0 1 auto;
    padding-bottom: 6px;
    font-weight: 600;
    overflow-wrap: anywhere;
  }
  omote-number-field {
    width: 92px;
  }
  .wanted {
    color: var(--attention);
  }
`;

@customElement("omote-macro-bindings")
export class MacroBindings extends MappingsElement {
  @property() name = "";

  static override styles = [base, style];
  protected override readonly topics: readonly Topic[] = ["binding_list", "characters", "link"];

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    if (this.#waits) this.context.devices.stopLearning();
  }

  /** Whether the next control that moves becomes one of it. */
  get #waits(): boolean {
    const { learning } = this.context.devices;
    return learning !== null && targetKey(learning) === targetKey(this.#target);
  }

  get #target() {
    return macroTarget(this.mappings.character, this.name);
  }

  override render() {
    const bound = this.context.devices.bindings.filter(({ to }) => this.#plays(to));
    const waits = this.#waits;
    return html`${bound.map((binding) => this.#row(binding))}
      <div class="row"><button data-bind aria-pressed=${waits} @click=${this.#learn}>${waits ? "Do not bind" : "Bind a control"}</button>
        ${waits ? html`<span class="wanted" role="status">Move a dial, fader or stick of a device.</span>` : nothing}</div>`;
  }

  #plays(to: string): boolean {
    const who = characterOf(to);
    return to.endsWith(`/macro/${this.name}`) && (who === "*" || who === this.mappings.character);
  }

  #row(binding: BindingDocument) {
    const { device, control, button, relative } = binding;
    const [low, high] = [binding.low ?? 0, binding.high ?? 1];
    const says = binding.button === "" && relative === "" ? "" : ` (${button || "encoder, relative"})`;
    if (this.context.devices.isFixed(binding))
      return html`<div class="row"><b>${device} ${control}${says}</b> from a file</div>`;
    return html`<div class="row" data-binding=${`${device}|${control}`}><b>${device} ${control}${says}</b>
      ${this.#field("from", low, (value) => this.#change(binding, { low: value, high }))}
      ${this.#field("to", high, (value) => this.#change(binding, { low, high: value }))}
      ${button !== "" || relative !== "" ? nothing : this.#deadZone(binding)}
      <button title="The control the other way round" @click=${() => this.#change(binding, { low: high, high: low })}>Mirror</button>
      <button @click=${() => this.context.devices.unbind(binding)}>Unbind</button></div>`;
  }

  #field(label: string, value: number, typed: (value: number) => void) {
    return html`<omote-number-field .label=${label} .scale=${100} .low=${-1} .high=${1} .value=${value}
      @typed=${({ detail }: NumberTyped) => typed(detail)}></omote-number-field>`;
  }

  #deadZone(binding: BindingDocument) {
    return html`<omote-number-field label="dead zone" unit="%" title="How far from its middle a stick counts as there" .scale=${100} .digits=${1} .high=${WIDEST_DEAD_ZONE} .value=${binding.dead_zone}
      @typed=${({ detail }: NumberTyped) => this.#change(binding, { dead_zone: detail })}></omote-number-field>`;
  }

  #change(binding: BindingDocument, change: Partial<BindingDocument>): void {
    this.context.devices.bind({ ...binding, ...change }, binding);
  }

  readonly #learn = (): void => {
    if (this.#waits) this.context.devices.stopLearning();
    else this.context.devices.learn(this.#target);
  };
}
