/** To whom faces are sent: each receiver with its count and what is wrong, and a form that adds one. */

import { css, html, nothing } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import type { ReceiverState, SendWay } from "../../link/messages";
import { base, entry } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import type { Topic } from "../store/page_store";
import { DevicesElement, section } from "./devices_element";
import { switchRows } from "./switch_rows";
import { sendWord } from "./switch_words";

const style = css`
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
`;

@customElement("omote-receivers")
export class ReceiverSwitches extends DevicesElement {
  @state() private chosen = "";
  @query("form") private form!: HTMLFormElement;

  static override styles = [base, section, switchRows, style];

  protected override readonly topics: readonly Topic[] = ["devices", "characters"];

  protected override shape(): unknown {
    return [this.devices.ways, this.devices.receivers.map(({ sent, ...rest }) => rest)];
  }

  override render() {
    const { receivers, ways } = this.devices;
    return html`<h2>Faces sent to other programs</h2>
      ${receivers.length === 0 ? html`<p class="none">None. Unreal, Unity, Warudo, VSeeFace and VTube Studio play the face on air.</p>` : nothing}
      <ul>${repeat(receivers, ({ word }) => word, this.#row)}</ul>
      ${ways.length === 0 ? nothing : this.#form(ways)}`;
  }

  readonly #row = (receiver: ReceiverState) => html`<li data-receiver=${receiver.word}>
    <span class="lamp"></span><b class="name">${receiver.title}</b>
    <span class="where">${receiver.where}${receiver.character === "" ? "" : `, ${receiver.character}`}</span>
    <span class="where sent"></span>
    ${
      receiver.fixed
        ? html`<span class="where" title="Started with --send ${receiver.word}">from the command line</span>`
        : html`<button data-off=${receiver.word} @click=${() => this.devices.switchDevice("send", receiver.word, false)}>Stop</button>`
    }
    ${receiver.fault === "" ? nothing : html`<small class="attention">${receiver.fault[0]?.toUpperCase()}${receiver.fault.slice(1)}.</small>`}
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
    this.chosen = textOf(event);
  };

  #submit(event: Event, { name }: SendWay): void {
    event.preventDefault();
    const fields = new FormData(this.form);
    const read = (field: string): string => String(fields.get(field) ?? "");
    this.devices.switchDevice("send", sendWord(name, read("host"), Number(read("port")), read("character")), true);
  }

  override paint(): void {
    for (const row of this.renderRoot.querySelectorAll<HTMLElement>("li")) {
      const receiver = this.devices.receivers.find(({ word }) => word === row.dataset.receiver);
      if (receiver === undefined) continue;
      row.querySelector(".lamp")?.classList.toggle("on", receiver.sent > 0 && receiver.fault === "");
      this.write.text(row.querySelector(".sent") as Element, `${receiver.sent} sent`);
    }
  }
}
