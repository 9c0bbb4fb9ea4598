/** The pads of the show beside each other, played, or one of them edited. */

import { html, nothing } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import { MOST_PADS } from "../../link/constants";
import type { PadState } from "../../link/messages";
import { base } from "../../ui/theme";
import { whileShown } from "../../ui/topic_element";
import { ConsoleElement } from "../controls/console_element";
import type { Topic } from "../store/page_store";
import { PadCommands, padsOf } from "./pad_commands";
import { freeName, kindOf, PAD_PARTS, PART_WORDS, type PadContent, type PadPart, padName, restOf } from "./pad_layout";
import { padPanelStyle } from "./pad_panel_style";
import "./blend_pad";
import type { NextPad } from "./pad_editor";
import "./pad_editor";

const DIMENSIONS = [2, 1, 3] as const;
const DIMENSION_WORDS: Readonly<Record<number, string>> = { 1: "a line", 2: "a square", 3: "a square and a depth" };

/** Tells `close`. */
@customElement("omote-pad-panel")
export class PadPanel extends ConsoleElement {
  /** A pad that is made here and not kept yet: it has too few looks. */
  @state() private begun: PadContent | null = null;
  @state() private asks = false;
  /** What is edited next, once the list has it. */
  #next: NextPad | null = null;
  /** The pad that was edited when it was shown last. */
  #seen = "";
  @query("form input") private nameField!: HTMLInputElement | null;

  static override styles = [base, padPanelStyle];

  protected override readonly topics: readonly Topic[] = ["pad_list", "arrangement", "pad_edit", "manifest", "link"];

  constructor() {
    super();
    whileShown(this, () => () => this.store.editPad(""));
  }

  override render() {
    const pads = padsOf(this.store);
    const { begun } = this;
    return html`<div class="head"><h2>Pads</h2>${this.asks ? this.#form() : this.#keys(pads.length)}
        <button class="close" title="Back to faders and head (Shift H)" @click=${this.close}>Close</button></div>
      <div class="pads">${repeat(
        begun === null ? pads : [...pads, begun],
        ({ name }) => name,
        (pad) => (pad.name === this.store.editedPad ? this.#editor(pad, pad === begun) : this.#player(pad as PadState)),
      )}
        ${pads.length === 0 && begun === null ? html`<p class="none">No pad yet: make one, or take those of the cast.</p>` : nothing}</div>`;
  }

  #keys(count: number) {
    const full = count >= MOST_PADS ? `A show has ${MOST_PADS} pads at most: delete one first` : null;
    return html`<button data-do="new" title=${full ?? "Make a pad: a name, what it plays, its dimensions"} ?disabled=${full !== null} @click=${this.#ask}>New pad …</button>
      <button data-do="cast" title="The pads that come with the cast, as a new show has them; those of the same names make way" @click=${() => new PadCommands(this.store).addOfCast()}>Pads of the cast</button>
      <a href="/solo" target="omote-solo" title="A page for one person alone: two pads, the face, keys and cues">Play alone</a>`;
  }

  #form() {
    return html`<form @submit=${this.#make} @keydown=${this.#formKey}>
      <input name="name" required maxlength="24" placeholder="name" aria-label="Name of the new pad" title="Up to 24 letters; hyphens are put for spaces" autocomplete="off" />
      <select name="part" aria-label="What it plays">${PAD_PARTS.map((part) => html`<option value=${part}>${PART_WORDS[part]}</option>`)}</select>
      <select name="dimensions" aria-label="Dimensions">${DIMENSIONS.map((count) => html`<option value=${count}>${DIMENSION_WORDS[count]}</option>`)}</select>
      <button type="submit">Make</button><button type="button" @click=${() => (this.asks = false)}>Cancel</button></form>`;
  }

  #player(pad: PadState) {
    const { pads } = this.store.arrangement;
    const chosen = pads.includes(pad.name);
    return html`<omote-blend-pad class="panel" data-pad=${pad.name} .context=${this.context} .pad=${pad}>
      <button class="star" aria-pressed=${chosen} aria-label="${pad.name} stands first" title="Stands first; the page of one person has the first two" @click=${() => this.#choose(pad.name, !chosen)}>${chosen ? "★" : "☆"}</button>
      <button class="edit" title="Move, add and name its looks, on air too" aria-label="Edit ${pad.name}" @click=${() => this.#edit(pad.name)}>Edit</button></omote-blend-pad>`;
  }

  #editor(pad: PadContent, draft: boolean) {
    return html`<omote-pad-editor class="panel" data-pad=${pad.name} .context=${this.context} .pad=${pad} .draft=${draft}
      @draft=${this.#keepDraft} @next=${({ detail }: CustomEvent<NextPad | null>) => (this.#next = detail)} @done=${() => this.#edit("")}></omote-pad-editor>`;
  }

  #choose(name: string, on: boolean): void {
    const others = this.store.arrangement.pads.filter((other) => other !== name);
    this.store.arrange({ pads: on ? [...others, name] : others });
  }

  /** Edits a pad, "" for none; what was begun and not kept is gone. */
  #edit(name: string): void {
    this.begun = null;
    this.#next = null;
    this.store.editPad(name);
  }

  readonly #ask = (): void => {
    this.asks = true;
    void this.updateComplete.then(() => this.nameField?.focus());
  };

  readonly #formKey = (event: KeyboardEvent): void => {
    if (event.key !== "Escape") return;
    event.preventDefault();
    event.stopPropagation();
    this.asks = false;
  };

  readonly #make = (event: SubmitEvent): void => {
    event.preventDefault();
    const given = new FormData(event.target as HTMLFormElement);
    const name = freeName(padName(String(given.get("name"))), this.store.newest("pad_list")?.pads ?? []);
    if (name === "") return;
    const [part, dimensions] = [given.get("part") as PadPart, Number(given.get("dimensions"))];
    const rest = restOf(part);
    const label = this.store.label(kindOf(part), rest);
    this.asks = false;
    this.begun = {
      name,
      part,
      dimensions,
      looks: [{ label, mix: { [rest]: 1 }, place: new Array(dimensions).fill(0) }],
    };
    this.store.editPad(name);
  };

  /** A pad that has looks enough is kept, and is edited on. */
  readonly #keepDraft = ({ detail }: CustomEvent<PadContent>): void => {
    this.begun = detail;
    if (this.store.editedPad !== detail.name) this.store.editPad(detail.name);
  };

  /** What is edited is seen, wherever it stands in the row; a new pad stands where it will. */
  protected override updated(): void {
    const edited = this.store.editedPad;
    if (edited !== this.#seen)
      this.renderRoot.querySelector("omote-pad-editor")?.scrollIntoView({ block: "nearest", inline: "nearest" });
    this.#seen = edited;
  }

  protected override willUpdate(): void {
    const names = padsOf(this.store).map(({ name }) => name);
    if (this.begun !== null && names.includes(this.begun.name)) this.begun = null;
    const next = this.#next;
    if (next === null || !names.includes(next.to) || (next.from !== null && names.includes(next.from))) return;
    this.#next = null;
    this.store.editPad(next.to);
  }
}
