/** The clips of the show by name: one is shown; new, named, copied and deleted. */

import { css, html, nothing } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { onRoam } from "../../ui/gestures";
import { layerWhileShown } from "../../ui/key_presses";
import { base, ellipsis, flow } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import { ClipElement, clipControls } from "./clip_element";
import type { ClipTopic } from "./clip_store";

/** Letters of a name. */
const LONGEST = 40;

const style = css`
  :host {
    display: grid;
    grid-template: auto auto minmax(0, 1fr) / minmax(0, 1fr);
    gap: 6px;
    padding: 8px;
    min-height: 0;
  }
  .row {
    ${flow}
    gap: 4px;
  }
  .row > :is(input, button) {
    flex: 1 1 60px;
    min-width: 0;
  }
  ul {
    overflow: auto;
    min-height: 0;
  }
  li button {
    ${ellipsis}
    width: 100%;
    min-height: var(--finger, 36px);
    text-align: left;
    background: none;
    border-color: transparent;
  }
  li button[aria-current="true"] {
    background: #22262b;
    border-color: var(--hand);
  }
  li button.on {
    color: #fff;
    background: var(--air-deep);
  }
  select {
    display: none;
    min-height: var(--finger, 36px);
    flex: 3 1 120px;
    min-width: 0;
  }
  .none {
    padding: 8px 2px;
    color: var(--faint);
  }
  @media (max-width: 899px) {
    :host {
      grid-template: auto / minmax(0, 1fr);
      gap: 4px;
      padding: 4px;
    }
    ul,
    .find {
      display: none;
    }
    select {
      display: block;
    }
    .all {
      flex-wrap: nowrap;
    }
    .row > button {
      flex: 0 1 auto;
      padding: 0 8px;
    }
  }
`;

@customElement("omote-clip-list")
export class ClipList extends ClipElement {
  /** What is asked for: the name of a new clip, or another name of the one that is shown. */
  @state() private asked: "new" | "rename" | null = null;
  @query(".find") private field!: HTMLInputElement;
  @query("ul") private list!: HTMLElement;

  static override styles = [base, clipControls, style];

  protected override readonly topics: readonly ClipTopic[] = ["clips", "view", "link"];

  override firstUpdated(): void {
    onRoam(this.list, "button");
  }

  /** To the field for words. */
  search(): void {
    this.field.focus();
  }

  /** Asks for the name of a new clip. */
  begin(): void {
    this.#ask("new");
  }

  override render() {
    const { clips } = this;
    const names = clips.name === "" || clips.names.includes(clips.name) ? clips.names : [...clips.names, clips.name];
    return html`
      <div class="row"><input class="find" type="search" placeholder="search /" aria-label="Search clips" .value=${clips.search}
        @input=${(event: Event) => clips.searchFor(textOf(event))} @keydown=${this.#searchKey}></div>
      ${this.asked === null ? html`<div class="row all">${this.#choice(names)}${this.#actions()}</div>` : html`<omote-clip-name .clips=${clips} .kind=${this.asked} @close=${() => this.#ask(null)}></omote-clip-name>`}
      <ul @keydown=${this.#key}>${this.#items()}</ul>`;
  }

  #choice(names: readonly string[]) {
    return html`<select aria-label="Clip" @change=${(event: Event) => this.clips.choose(textOf(event))}>
      ${names.length === 0 ? html`<option>no clip yet</option>` : names.map((name) => html`<option .selected=${name === this.clips.name}>${name}</option>`)}</select>`;
  }

  #actions() {
    const { clips } = this;
    const none = !clips.names.includes(clips.name);
    const why = clips.locked;
    return html`<button title=${why || "A new clip (N)"} ?disabled=${why !== ""} @click=${() => this.#ask("new")}>New</button>
      <button title=${why || "Another name (F2 in the list)"} ?disabled=${none || why !== ""} @click=${() => this.#ask("rename")}>Rename</button>
      <button title=${why} ?disabled=${none || why !== ""} @click=${() => clips.copy()}>Copy</button>
      <button title=${why || "Undo brings it back (Del in the list)"} ?disabled=${none || why !== ""} @click=${() => clips.drop()}>Delete</button>`;
  }

  #items() {
    const { clips } = this;
    if (clips.found.length === 0)
      return html`<li class="none">${clips.search === "" ? "No clip yet: New (N) begins one, and its first pass makes it." : `No clip is called "${clips.search}".`}</li>`;
    return clips.found.map(
      (name) =>
        html`<li><button data-name=${name} aria-current=${name === clips.name} @click=${() => clips.choose(name)}>${name}</button></li>`,
    );
  }

  readonly #searchKey = (event: KeyboardEvent): void => {
    const [first] = this.clips.found;
    if (event.key !== "Enter" || event.isComposing || first === undefined) return;
    event.preventDefault();
    this.clips.choose(first);
  };

  readonly #key = (event: KeyboardEvent): void => {
    const { name } = (event.target as HTMLElement).dataset;
    if (name === undefined || (event.key !== "F2" && event.key !== "Delete")) return;
    event.preventDefault();
    if (event.key === "Delete") this.clips.drop(name);
    else {
      this.clips.choose(name);
      this.#ask("rename");
    }
  };

  #ask(what: "new" | "rename" | null): void {
    if (what !== null && this.clips.locked !== "") this.clips.show.say(this.clips.locked);
    else this.asked = what;
  }
}

const formStyle = css`
  form {
    ${flow}
    gap: 4px;
  }
  input {
    flex: 1 1 120px;
  }
`;

/** The name of a clip, as it is typed. Tells `close`. */
@customElement("omote-clip-name")
export class ClipName extends ClipElement {
  kind: "new" | "rename" = "new";

  static override styles = [base, clipControls, formStyle];

  constructor() {
    super();
    layerWhileShown(this, "form", this.close);
  }

  override firstUpdated(): void {
    const field = this.renderRoot.querySelector("input");
    field?.focus();
    field?.select();
  }

  override render() {
    const old = this.kind === "rename" ? this.clips.name : "";
    return html`<form @submit=${this.#submit}><input name="name" maxlength=${LONGEST} aria-label=${old === "" ? "Name of the new clip" : "Another name"} placeholder="name" .value=${old} autocomplete="off">
      <button type="submit">${old === "" ? "Begin" : "Rename"}</button><button type="button" @click=${this.close}>Cancel</button>${nothing}</form>`;
  }

  readonly #submit = (event: SubmitEvent): void => {
    event.preventDefault();
    const name = String(new FormData(event.target as HTMLFormElement).get("name"))
      .trim()
      .replace(/\s+/g, " ");
    if (name === "") this.clips.show.say("Give the clip a name.");
    else if (this.kind === "rename") this.clips.rename(name);
    if (name !== "" && (this.kind === "rename" || this.clips.begin(name))) this.close();
  };
}
