/** Trackers on and off: what is heard and what to do at each sender, what has announced itself, and what a phone reads. */

import { css, html, nothing } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import type { TrackerOffer } from "../../link/messages";
import { base, entry } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import type { Topic } from "../store/page_store";
import { DevicesElement, section } from "./devices_element";
import { switchRows } from "./switch_rows";
import { listenWord } from "./switch_words";

/** What stands in the field of an address, which may be left empty, and what it is for. */
const ASKS: Readonly<Record<TrackerOffer["asks"], readonly [short: string, long: string]>> = {
  phone: ["Phone's address", "Phone's address, if it is to be asked"],
  computer: ["Computer's address", "Its computer's address, if not this one"],
  sender: ["Sender's address", "Who may send, if not this machine"],
  "": ["", ""],
};

const style = css`
  form input {
    ${entry}
    min-height: 26px;
  }
  form.row {
    display: grid;
    grid-template-columns: minmax(0, 1fr) 88px;
  }
  form input {
    min-width: 0;
  }
  form input[name="host"] {
    grid-column: 1;
  }
  form input[name="port"],
  form button {
    grid-column: 2;
  }
  .phone {
    display: grid;
    grid-template-columns: 116px minmax(0, 1fr);
    gap: 10px;
    align-items: center;
    margin: 8px 0 0;
  }
  .alone {
    margin: 8px 0 0;
  }
  .phone p {
    margin: 0;
  }
  .phone img {
    width: 116px;
    background: #fff;
  }
  a {
    color: var(--focus);
  }
`;

@customElement("omote-trackers")
export class TrackerSwitches extends DevicesElement {
  @state() private chosen = "";
  @query("form") private form!: HTMLFormElement;

  static override styles = [base, section, switchRows, style];

  protected override readonly topics: readonly Topic[] = ["devices"];

  protected override shape(): unknown {
    const { trackers, foundTrackers, phonePage, machine } = this.devices;
    return [trackers, foundTrackers, phonePage, machine];
  }

  override render() {
    const { trackers, foundTrackers } = this.devices;
    const on = trackers.filter(({ word }) => word !== "");
    const off = trackers.filter(({ word }) => word === "");
    return html`<h2>Face trackers</h2>
      ${on.length === 0 ? html`<p class="none">None is heard. Switch on the one that your phone or program speaks.</p>` : nothing}
      <ul>${repeat(on, ({ name }) => name, this.#row)}${off.filter(({ fault }) => fault !== "").map(this.#fault)}</ul>
      ${foundTrackers
        .filter(({ word }) => !on.some((tracker) => tracker.word === word))
        .map(
          ({ word, title, where }) => html`<div class="row found"><span class="lamp on"></span>
            <span class="name">${title || "VTube Studio"} runs at ${where}</span>
            <button data-found=${word} @click=${() => this.#switch(word, true)}>Hear it</button></div>`,
        )}
      ${off.length === 0 ? nothing : this.#form(off)}
      ${on.some(({ asks, port }) => asks !== "computer" && port !== null) ? this.#phone() : nothing}`;
  }

  readonly #row = (tracker: TrackerOffer) => {
    return html`<li data-tracker=${tracker.name}>
      <b class="name">${tracker.title}</b><span class="where">${tracker.port === null ? "" : `port ${tracker.port}`}</span>
      ${
        tracker.fixed
          ? html`<span class="where" title="Started with --listen ${tracker.word}">from the command line</span>`
          : html`<button data-off=${tracker.name} @click=${() => this.#switch(tracker.word, false)}>Switch off</button>`
      }
      ${tracker.stranger === "" ? nothing : this.#stranger(tracker)}</li>`;
  };

  /** One that the start has asked for and that is off: why, and a press that tries again. */
  readonly #fault = ({ name, title, fault, again }: TrackerOffer) => {
    return html`<li data-fault=${name}><b class="name">${title}</b><span class="where">off</span>
      <button data-again=${name} @click=${() => this.#switch(again, true)}>Switch on</button>
      <small class="attention">${fault}</small></li>`;
  };

  /** A phone that sends and may not: one press lets it play. */
  #stranger({ stranger, strange, fixed, title }: TrackerOffer) {
    return html`<small class="attention">${stranger} sends ${title}, and may not play.
      ${fixed ? `Start the show with --allow ${stranger}.` : html`<button data-allow=${stranger} @click=${() => this.#switch(strange, true)}>Let it play</button>`}</small>`;
  }

  #form(off: readonly TrackerOffer[]) {
    const chosen = off.find(({ name }) => name === this.chosen) ?? (off[0] as TrackerOffer);
    const [asks, why] = ASKS[chosen.asks];
    return html`<form class="row" @submit=${(event: Event) => this.#submit(event, chosen)}>
      <select name="tracker" aria-label="Tracker" @change=${this.#choose}>
        ${off.map(({ name, title }) => html`<option value=${name} .selected=${name === chosen.name}>${title}</option>`)}
      </select>
      ${chosen.port === null ? nothing : html`<input name="port" type="number" min="1" max="65535" aria-label="Port" .value=${String(chosen.port)}>`}
      ${asks === "" ? nothing : html`<input name="host" placeholder=${asks} title=${why} aria-label=${why} autocomplete="off" spellcheck="false">`}
      <button data-on>Switch on</button></form>`;
  }

  /** What a phone reads; where no phone opens a page of this show, what is typed and what else it takes. */
  #phone() {
    const { phonePage: page, machine } = this.devices;
    if (page === "")
      return html`<p class="alone"><b>This show listens on this machine alone:</b> no phone opens its pages. An app sends to it
        all the same: type ${machine === "" ? "this machine's address" : html`<b>${machine}</b>`} and the port of its line above into it, then
        press <i>Let it play</i> here. To have a phone read both from a picture (QR code), start the show with
        <code>--host 0.0.0.0</code>.</p>`;
    return html`<div class="phone"><img src="${page}/phone.svg" alt="QR code">
      <p>A phone that reads this picture opens <a href=${page} target="omote-phone">what to type into the app</a>: the
        address and the port, to be copied. No app of a tracker reads them from a picture itself.</p></div>`;
  }

  readonly #choose = (event: Event): void => {
    this.chosen = textOf(event);
  };

  #submit(event: Event, chosen: TrackerOffer): void {
    event.preventDefault();
    const fields = new FormData(this.form);
    const port = chosen.port === null ? null : Number(fields.get("port") ?? chosen.port);
    this.#switch(listenWord(chosen.name, port, chosen.port, String(fields.get("host") ?? "")), true);
  }

  #switch(word: string, on: boolean): void {
    this.devices.switchDevice("listen", word, on);
  }
}
