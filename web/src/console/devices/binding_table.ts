/** All bindings as a table: which control plays what, and how; to be changed, deleted and made. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import type { BindingDocument } from "../../link/messages";
import { base, entry, flow } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import type { Topic } from "../store/page_store";
import { FIRST_BINDING, modeText, rangeText } from "./binding_fields";
import type { Draft } from "./binding_form";
import { isLevel, labelsOf, targetText } from "./binding_target";
import { DevicesElement, section } from "./devices_element";
import "./binding_form";

const style = css`
  :host {
    display: grid;
    grid-template-rows: auto auto minmax(0, 1fr);
  }
  .head {
    display: flex;
    align-items: center;
    gap: 8px;
    margin-bottom: 6px;
  }
  .head h2 {
    flex: 1;
    margin: 0;
  }
  .scroll {
    overflow: auto;
  }
  table {
    width: 100%;
    border-collapse: collapse;
    font-size: 12.5px;
  }
  th {
    position: sticky;
    top: 0;
    padding: 4px 6px;
    font-size: 11px;
    font-weight: 600;
    text-align: left;
    color: var(--dim);
    background: var(--panel);
  }
  td {
    padding: 3px 6px;
    border-top: 1px solid var(--line);
    overflow-wrap: anywhere;
  }
  td:last-child {
    white-space: nowrap;
    text-align: right;
  }
  tr.waits td {
    color: var(--dim);
  }
  .missing {
    display: block;
    color: var(--attention);
  }
  input {
    ${entry}
    flex: 0 1 160px;
    min-height: 26px;
  }
  @media (max-width: 899px) {
    .scroll {
      max-height: 70vh;
    }
  }
  @media (max-width: 699px) {
    thead,
    td.none {
      display: none;
    }
    tr {
      ${flow}
      padding: 4px 0;
      border-top: 1px solid var(--line);
    }
    td {
      padding: 1px 8px 1px 0;
      border: 0;
    }
    td:first-child {
      flex: 1 1 40%;
      font-weight: 600;
    }
    td:nth-child(2) {
      flex: 1 1 100%;
      order: 2;
    }
    td:nth-child(n + 3):nth-child(-n + 7) {
      order: 3;
      font-size: 11.5px;
      color: var(--dim);
    }
    td:nth-child(n + 3):nth-child(-n + 7)::before {
      content: attr(data-says) " ";
      color: var(--faint);
    }
  }
`;

@customElement("omote-bindings")
export class BindingTable extends DevicesElement {
  @state() private draft: Draft | null = null;
  @state() private filter = "";

  static override styles = [base, section, style];

  protected override readonly topics: readonly Topic[] = ["binding_list", "devices", "manifest", "characters"];

  protected override shape(): unknown {
    return this.devices.devices.map(({ name, plugged }) => [name, plugged]);
  }

  /** Opens the form with a control that is to be bound. */
  begin(device: string, control: string): void {
    this.draft = { binding: { ...FIRST_BINDING, device, control }, replaces: null };
    this.scrollIntoView({ block: "nearest" });
  }

  override render() {
    const { bindings } = this.devices;
    const shown = bindings.filter((binding) => this.#passes(binding));
    return html`<div class="head"><h2>Bindings</h2>
        <input type="search" placeholder="filter" aria-label="Filter the bindings" .value=${this.filter} @input=${this.#narrow} /><button data-add @click=${() => this.begin("", "")}>Add</button></div>
      ${this.draft === null ? html`<span></span>` : html`<omote-binding-form .context=${this.context} .draft=${this.draft} @close=${this.#close}></omote-binding-form>`}
      <div class="scroll">${bindings.length === 0 ? NONE : this.#table(shown)}</div>`;
  }

  #table(bindings: readonly BindingDocument[]) {
    return html`<table>
      <thead><tr><th>Control</th><th>plays</th><th>Range</th><th>Curve</th><th>Pick-up</th><th>Mode</th><th>Bank</th><th></th></tr></thead>
      <tbody>${bindings.map((binding) => this.#row(binding))}</tbody>
    </table>`;
  }

  #row(binding: BindingDocument) {
    const there = this.devices.device(binding.device)?.plugged === true;
    const level = isLevel(binding);
    const missing = this.devices.whyMissing(binding);
    const fader = level && binding.button === "" && binding.relative === "";
    return html`<tr class=${there && missing === "" ? "" : "waits"} data-binding="${binding.device}|${binding.control}">
      <td title=${there ? "" : "Not plugged in: it waits for the device"}>${binding.device}: ${binding.control}</td>
      <td title=${binding.to}>${targetText(binding, labelsOf(this.store))}${missing === "" ? nothing : html`<small class="missing">waits: ${missing}</small>`}</td>
      ${detail("range", level, rangeText(binding))} ${detail("curve", fader, binding.curve)}
      ${detail("pick-up", fader, binding.pick_up ? "yes" : "no")} ${detail("mode", true, modeText(binding))}
      ${detail("bank", true, binding.bank || "all")}
      <td>${this.devices.isFixed(binding) ? html`<span title="From the file of --bindings">from a file</span>` : this.#keys(binding)}</td>
    </tr>`;
  }

  #keys(binding: BindingDocument) {
    return html`<button data-edit @click=${() => (this.draft = { binding, replaces: binding })}>Edit</button>
      <button data-delete aria-label="Delete the binding of ${binding.device} ${binding.control}" @click=${() => this.devices.unbind(binding)}>Delete</button>`;
  }

  #passes(binding: BindingDocument): boolean {
    const text = `${binding.device} ${binding.control} ${binding.to} ${binding.bank} ${targetText(binding, labelsOf(this.store))}`;
    return text.toLowerCase().includes(this.filter.trim().toLowerCase());
  }

  readonly #narrow = (event: Event): void => {
    this.filter = textOf(event);
  };

  readonly #close = (): void => {
    this.draft = null;
  };
}

/** A cell; where a binding has no such thing, a dash. */
const detail = (says: string, has: boolean, value: string | number) =>
  html`<td data-says=${says} class=${has ? "" : "none"}>${has ? value : "–"}</td>`;

const NONE = html`<p>No control plays anything yet. On the console press <b>Learn</b> (Z), touch a control of the page and
  move one of a device. Or load a preset of a device, or press one of its controls here.</p>`;
