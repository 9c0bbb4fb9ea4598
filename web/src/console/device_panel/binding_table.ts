/** All bindings as a table: which control plays what, and how; to be changed, deleted and made. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import type { BindingDocument } from "../../link/messages";
import { base, entry } from "../../ui/theme";
import { FIRST_BINDING, modeText, rangeText } from "../devices/binding_fields";
import { isLevel, labelsOf, targetText } from "../devices/binding_target";
import type { Draft } from "./binding_form";
import { DevicesElement, section } from "./devices_element";
import "./binding_form";

@customElement("omote-bindings")
export class BindingTable extends DevicesElement {
  @state() private draft: Draft | null = null;
  @state() private filter = "";

  static override styles = [
    base,
    section,
    css`
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
          display: flex;
          flex-wrap: wrap;
          align-items: center;
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
    `,
  ];

  protected override listen(changed: () => void): (() => void)[] {
    return [
      this.devices.listen("bindings", changed),
      this.devices.listen("devices", changed),
      this.store.listen("cast", changed),
      this.store.listen("characters", changed),
    ];
  }

  /** Opens the form with a control that is to be bound. */
  begin(device: string, control: string): void {
    this.draft = { binding: { ...FIRST_BINDING, device, control }, replaces: null };
    this.scrollIntoView({ block: "nearest" });
  }

  override render() {
    const { bindings } = this.devices;
    const shown = bindings.filter((one) => this.#passes(one));
    return html`<div class="head"><h2>Bindings</h2>
        <input type="search" placeholder="filter" aria-label="Filter the bindings" .value=${this.filter} @input=${this.#narrow} /><button data-add @click=${() => this.begin("", "")}>Add</button></div>
      ${this.draft === null ? html`<span></span>` : html`<omote-binding-form .context=${this.context} .draft=${this.draft} @close=${this.#close}></omote-binding-form>`}
      <div class="scroll">${bindings.length === 0 ? NONE : this.#table(shown)}</div>`;
  }

  #table(bindings: readonly BindingDocument[]) {
    return html`<table>
      <thead><tr><th>Control</th><th>plays</th><th>Range</th><th>Curve</th><th>Pick-up</th><th>Mode</th><th>Bank</th><th></th></tr></thead>
      <tbody>${bindings.map((one) => this.#row(one))}</tbody>
    </table>`;
  }

  #row(one: BindingDocument) {
    const there = this.devices.device(one.device)?.plugged === true;
    const level = isLevel(one);
    const missing = this.devices.whyMissing(one);
    const fader = level && one.button === "" && one.relative === "";
    return html`<tr class=${there && missing === "" ? "" : "waits"} data-binding="${one.device}|${one.control}">
      <td title=${there ? "" : "Not plugged in: it waits for the device"}>${one.device}: ${one.control}</td>
      <td title=${one.to}>${targetText(one, labelsOf(this.store))}${missing === "" ? nothing : html`<small class="missing">waits: ${missing}</small>`}</td>
      ${detail("range", level, rangeText(one))} ${detail("curve", fader, one.curve)}
      ${detail("pick-up", fader, one.pick_up ? "yes" : "no")} ${detail("mode", true, modeText(one))}
      ${detail("bank", true, one.bank || "all")}
      <td>${this.devices.isFixed(one) ? html`<span title="From the file of --bindings">from a file</span>` : this.#keys(one)}</td>
    </tr>`;
  }

  #keys(one: BindingDocument) {
    return html`<button data-edit @click=${() => {
      this.draft = { binding: one, replaces: one };
    }}>Edit</button>
      <button data-delete aria-label="Delete the binding of ${one.device} ${one.control}" @click=${() => this.devices.unbind(one)}>Delete</button>`;
  }

  #passes(one: BindingDocument): boolean {
    const text = `${one.device} ${one.control} ${one.to} ${one.bank} ${targetText(one, labelsOf(this.store))}`;
    return text.toLowerCase().includes(this.filter.trim().toLowerCase());
  }

  readonly #narrow = (event: Event): void => {
    this.filter = (event.target as HTMLInputElement).value;
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
