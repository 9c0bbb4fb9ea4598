/** To whom faces are sent: each receiver with its count and what is wrong, and a form that adds one. */

import { css, html, nothing } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import type { ReceiverState, SendWay } from "../../link/messages";
import { base, entry } from "../../ui/theme";
import { StyleWriter } from "../controls/console_element";
import { DevicesElement, section } from "./devices_element";
import { switchRows } from "./switch_rows";
import { sendWord } from "./switch_words";

@customElement("omote-receivers")
export class ReceiverSwitches extends DevicesElement {
  @state() private chosen = "";
  @query("form") private form!: HTMLFormElement;
  readonly #written = new StyleWriter();
  #shape = "";

  static override styles = [
    base,
    section,
    switchRows,
    css`
      input {
        ${entry}
        min-height: 26px;
      }
      input[name="host"] {
        flex: 1 1 110px;
        min-width: 0;
      }
      input[name="port"] {
        width: 88px;
      }
    `,
  ];

  protected override listen(changed: () => void): (() => void)[] {
    const heard = (): void => {
      const shape = JSON.stringify([this.devices.ways, this.devices.receivers.map(({ sent, ...rest }) => rest)]);
      if (shape === this.#shape) return;
      this.#shape = shape;
      changed();
    };
    return [this.devices.listen("devices", heard), this.store.listen("characters", changed)];
  }

  override render() {
    const { receivers, ways } = this.devices;
    return html`<h2>Faces sent to other programs</h2>
      ${receivers.length === 0 ? html`<p class="none">None. Unreal, Unity, Warudo, VSeeFace and VTube Studio play the face on air.</p>` : nothing}
      <ul>${repeat(receivers, ({ word }) => word, this.#row)}</ul>
      ${ways.length === 0 ? nothing : this.#form(ways)}`;
  }

  readonly #row = (one: ReceiverState) => html`<li data-receiver=${one.word}>
    <span class="lamp"></span><b class="name">${one.title}</b>
    <span class="where">${one.where}${one.character === "" ? "" : `, ${one.character}`}</span>
    <span class="where sent"></span>
    ${
      one.fixed
        ? html`<span class="where" title="Started with --send ${one.word}">from the command line</span>`
        : html`<button data-off=${one.word} @click=${() => this.devices.switchDevice("send", one.word, false)}>Stop</button>`
    }
    ${one.fault === "" ? nothing : html`<small class="attention">${one.fault[0]?.toUpperCase()}${one.fault.slice(1)}.</small>`}
  </li>`;

  #form(ways: readonly SendWay[]) {
    const chosen = ways.find(({ name }) => name === this.chosen) ?? (ways[0] as SendWay);
    const characters = Object.entries(this.store.state?.characters ?? {});
    return html`<form class="row" @submit=${(event: Event) => this.#submit(event, chosen)}>
      <select name="way" aria-label="Way" @change=${this.#choose}>
        ${ways.map(({ name, title }) => html`<option value=${name} .selected=${name === chosen.name}>${title}</option>`)}
      </select>
      <input name="host" required placeholder="127.0.0.1" aria-label="Address of the program" autocomplete="off" spellcheck="false">
      <input name="port" type="number" min="1" max="65535" required aria-label="Port" .value=${String(chosen.port)}>
      <select name="character" aria-label="Whose face"><option value="">the first character</option>
        ${characters.map(([id, { label }]) => html`<option value=${id}>${label}</option>`)}</select>
      <button data-on>Send</button></form>`;
  }

  readonly #choose = (event: Event): void => {
    this.chosen = (event.target as HTMLSelectElement).value;
  };

  #submit(event: Event, { name }: SendWay): void {
    event.preventDefault();
    const given = new FormData(this.form);
    const read = (field: string): string => String(given.get(field) ?? "");
    this.devices.switchDevice("send", sendWord(name, read("host"), Number(read("port")), read("character")), true);
  }

  override paint(): void {
    for (const row of this.renderRoot.querySelectorAll<HTMLElement>("li")) {
      const one = this.devices.receivers.find(({ word }) => word === row.dataset.receiver);
      if (one === undefined) continue;
      row.querySelector(".lamp")?.classList.toggle("on", one.sent > 0 && one.fault === "");
      this.#written.text(row.querySelector(".sent") as Element, `${one.sent} sent`);
    }
  }
}
