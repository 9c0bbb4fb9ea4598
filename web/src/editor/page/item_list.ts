/** The library: all own items, and what new ones can begin from. */

import { html, nothing } from "lit";
import { customElement, queryAll, state } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import type { ItemDocument } from "../../link/editing_messages";
import { strayClickStopper } from "../../ui/gestures";
import { base } from "../../ui/theme";
import { THUMBNAIL_SIZE } from "../../ui/thumbnails";
import { textOf, whileShown } from "../../ui/topic_element";
import { controls } from "../controls/controls_style";
import { EditorElement } from "../controls/editor_element";
import { PicturesInSight, scrollToRow } from "../controls/scrolled_list";
import type { Topic } from "../session/draft_store";
import {
  describe,
  duplicate,
  type Kind,
  matches,
  openItem,
  ordered,
  othersOf,
  placeAt,
  remove,
  restore,
} from "../session/item_commands";
import { grouped, type ListedSource, sourcesOf } from "../session/sources";
import { style } from "./item_list_style";
import "./new_item";

const TABS: readonly (readonly [Kind, string])[] = [
  ["expression", "Expressions"],
  ["face", "Faces"],
  ["pose", "Poses"],
];

/** The face that wears what is pictured of expressions. */
const PLAIN = "generic";

/** Two sheets, one behind the other; few fonts have it. */
const COPY = html`<svg width="13" height="13" viewBox="0 0 13 13" fill="none" stroke="currentColor" aria-hidden="true">
  <path d="M4.5 4.5h7v7h-7zM8.5 4.5v-3h-7v7h3" />
</svg>`;

/** Own expressions and faces, and all that they can begin from. */
@customElement("omote-item-list")
export class ItemListPanel extends EditorElement {
  /** Which of both lists is shown. */
  @state() kind: Kind = "expression";
  @state() private search = "";
  @state() private deleted = false;
  @state() private making: Readonly<Record<string, number>> | null = null;
  @state() private naming = -1;
  @queryAll("canvas") private canvases!: NodeListOf<HTMLCanvasElement>;
  /** Others are drawn when they are scrolled to. */
  readonly #sight = new PicturesInSight<HTMLCanvasElement>((canvas) => this.#portray(canvas));
  #carried: ItemDocument | null = null;
  #open = -1;
  /** An item was opened whose row has not been scrolled to yet. */
  #sought = false;
  /** What items that are not saved yet look like, as far as they have been open here. */
  readonly #drafts = new Map<number, string>();

  static override styles = [base, controls, style];

  protected override readonly topics: readonly Topic[] = ["items", "cast", "draft"];

  /** Opens the form for something new, from a mix of sources. */
  make(mix: Readonly<Record<string, number>> = {}, kind: Kind = this.kind): void {
    this.kind = kind;
    this.making = mix;
    void this.updateComplete.then(() =>
      this.renderRoot.querySelector("omote-new")?.scrollIntoView({ block: "nearest" }),
    );
  }

  constructor() {
    super();
    this.addEventListener("click", strayClickStopper(), { capture: true });
    whileShown(this, () => () => this.#sight.stop());
  }

  override focus(): void {
    this.renderRoot.querySelector<HTMLElement>("input[type=search]")?.focus();
  }

  get #own(): ItemDocument[] {
    return ordered(this.store.items, this.kind).filter((item) => item.deleted === this.deleted);
  }

  /** The list shows where the item is that has just been opened. */
  override willUpdate(): void {
    const { item, draft } = this.store;
    if (draft !== null) this.#drafts.set(draft.item, draft.content);
    if (item === null || item.id === this.#open) return;
    [this.#open, this.kind, this.#sought] = [item.id, item.kind, true];
  }

  override render() {
    const own = this.#own.filter(({ label, tags }) => matches(this.search, label, tags));
    return html`
      <div class="tabs" role="tablist" aria-label="Library">
        ${TABS.map(
          ([kind, label]) => html`<button role="tab" data-kind=${kind} aria-selected=${this.kind === kind}
            @click=${() => ([this.kind, this.making] = [kind, null])}>${label}</button>`,
        )}
      </div>
      <div class="row">
        <input class="grow" type="search" placeholder="search /" aria-label="Search by name or tag" .value=${this.search}
          @input=${(event: Event) => (this.search = textOf(event))} />
        <button class="main" data-new @click=${() => this.make()}>New</button></div>
      ${this.kind === "face" ? html`<div class="row"><omote-scan-button></omote-scan-button><omote-scan-button of="photographs"></omote-scan-button><omote-scan-button of="camera"></omote-scan-button></div>` : nothing}
      ${
        this.making === null
          ? nothing
          : html`<omote-new .context=${this.context} .kind=${this.kind} .mix=${this.making}
              @close=${() => (this.making = null)}></omote-new>`
      }
      <div class="list">${this.#section(own)} ${this.deleted ? nothing : this.#beginnings()}</div>
    `;
  }

  #section(own: readonly ItemDocument[]) {
    const gone = this.store.items.some((item) => item.deleted && item.kind === this.kind);
    return html`
      <header><h2 class="grow">${this.deleted ? "Deleted" : "Own"}</h2>
        ${
          gone || this.deleted
            ? html`<label class="row note"><input type="checkbox" .checked=${this.deleted}
                @change=${() => (this.deleted = !this.deleted)} /> deleted</label>`
            : nothing
        }
      </header>
      ${own.length === 0 ? html`<p class="note">${this.#nothing()}</p>` : nothing}
      <ul>${repeat(
        own,
        ({ id }) => id,
        (item) => this.#item(item, own),
      )}</ul>
    `;
  }

  #nothing(): string {
    if (this.deleted) return "Nothing is deleted.";
    return this.search === "" ? `No own ${this.kind} yet: press New.` : `Nothing of yours is called "${this.search}".`;
  }

  #item(item: ItemDocument, shown: readonly ItemDocument[]) {
    const open = this.store.draft?.item === item.id;
    return html`<li class="item ${open ? "open" : ""}" data-item=${item.name} draggable=${!item.deleted && this.naming !== item.id}
      @dragstart=${() => (this.#carried = item)}
      @dragover=${(event: DragEvent) => event.preventDefault()}
      @drop=${() => this.#drop(item)}
      @keydown=${(event: KeyboardEvent) => this.#key(event, item)}>
      <button class="picture" title="Open" aria-label="Open ${item.label}" ?disabled=${item.deleted}
        @click=${() => openItem(this.store, item.id)}>
        <canvas data-source=${this.#pictured(item)} width=${THUMBNAIL_SIZE.width} height=${THUMBNAIL_SIZE.height} aria-hidden="true"></canvas>
        <span class="text">${this.naming === item.id ? nothing : html`<b>${item.label}</b>`}
          <small class=${this.#isUnsaved(item) ? "unsaved" : ""}>${this.#remark(item)}</small></span>
      </button>
      ${this.naming === item.id ? this.#entry(item) : nothing}
      <div class="acts">${item.deleted ? this.#bringer(item) : this.#acts(item, shown)}</div>
    </li>`;
  }

  #isUnsaved({ id, head, deleted }: ItemDocument): boolean {
    return head === 0 || (this.store.unsaved.has(id) && !deleted);
  }

  #remark(item: ItemDocument): string {
    const others = othersOf(item.editors, this.context.name());
    const here = others.length === 0 ? "" : `open: ${others.join(", ")}`;
    const unsaved = item.head === 0 ? "not saved yet" : "changes not saved";
    return [this.#isUnsaved(item) ? unsaved : "", item.tags.join(", "), here].filter(Boolean).join(" · ");
  }

  #entry(item: ItemDocument) {
    const name = (event: Event): void => {
      const label = textOf(event).trim();
      this.naming = -1;
      if (label !== "" && label !== item.label) void describe(this.store, item, { label });
    };
    return html`<input class="naming" aria-label="New name of ${item.label}" maxlength="64" .value=${item.label}
      @change=${name} @blur=${name} @keydown=${(event: KeyboardEvent) => {
        if (event.key !== "Escape") return;
        event.stopPropagation();
        (event.target as HTMLInputElement).value = item.label; // what is left is as it was
        this.naming = -1;
      }} />`;
  }

  #bringer(item: ItemDocument) {
    return html`<button @click=${() => restore(this.store, item)}>Restore</button>`;
  }

  #acts(item: ItemDocument, shown: readonly ItemDocument[]) {
    const act = (label: string, sign: unknown, does: (event: MouseEvent) => void, off = false) =>
      html`<button class="icon quiet" title=${label} aria-label="${label}: ${item.label}" ?disabled=${off} @click=${does}>${sign}</button>`;
    const once = (event: MouseEvent): void => {
      if (event.detail < 2) void remove(this.store, item);
    };
    return [
      act("Further up", "↑", () => this.#shift(item, -1), shown[0] === item),
      act("Further down", "↓", () => this.#shift(item, 1), shown.at(-1) === item),
      act("Rename", "✎", () => void this.#name(item)),
      act("Duplicate", COPY, () => duplicate(this.store, item), item.head === 0),
      act("Delete", "✕", once),
    ];
  }

  async #name(item: ItemDocument): Promise<void> {
    this.naming = item.id;
    await this.updateComplete;
    this.renderRoot.querySelector<HTMLInputElement>(".naming")?.select();
  }

  #key(event: KeyboardEvent, item: ItemDocument): void {
    const by = event.key === "ArrowUp" ? -1 : event.key === "ArrowDown" ? 1 : 0;
    if (!event.altKey || by === 0) return;
    event.preventDefault();
    this.#shift(item, by);
  }

  #shift(item: ItemDocument, by: -1 | 1): void {
    const all = this.#own;
    const at = all.indexOf(item) + by;
    if (at >= 0 && at < all.length) this.#put(item, at);
  }

  #drop(onto: ItemDocument): void {
    const item = this.#carried;
    this.#carried = null;
    if (item !== null && item !== onto) this.#put(item, this.#own.indexOf(onto));
  }

  /** What the picture of an item shows: its content, saved or as it was open here; a pose is found by its name. */
  #pictured({ id, kind, name, content }: ItemDocument): string {
    return kind === "pose" ? name : content || (this.#drafts.get(id) ?? "");
  }

  #put(item: ItemDocument, at: number): void {
    const others = this.#own.filter(({ id }) => id !== item.id);
    void describe(this.store, item, { place: placeAt(others, at) });
  }

  #beginnings() {
    const sources = sourcesOf(this.store, this.kind).filter(
      ({ group, label }) => group !== "Own" && matches(this.search, label),
    );
    return grouped(sources).map(
      ([group, inside]) => html`<h2 title="A press begins a new one from it">Begin from: ${group}</h2>
        <div class="tiles">${repeat(
          inside,
          ({ source }) => source,
          (source) => this.#tile(source),
        )}</div>`,
    );
  }

  #tile({ source, label }: ListedSource) {
    return html`<button class="tile" data-begin=${source} title="New ${this.kind} from ${label}"
      @click=${() => this.make({ [source]: 1 })}>
      <canvas data-source=${source} width=${THUMBNAIL_SIZE.width} height=${THUMBNAIL_SIZE.height} aria-hidden="true"></canvas>
      <span>${label}</span>
    </button>`;
  }

  override updated(): void {
    if (this.#sought) requestAnimationFrame(() => this.#scrollToOpen()); // what stands above has its height by then
    this.#sight.watch(this.canvases);
  }

  /** Scrolls the list alone: on a phone the page itself goes on to what is edited. */
  #scrollToOpen(): void {
    if (!this.#sought || this.store.draft?.item !== this.#open) return; // the row before is open until the draft comes
    const row = this.renderRoot.querySelector(".item.open");
    const list = row?.closest(".list");
    if (!row || !list) return;
    this.#sought = false;
    scrollToRow(list, row);
  }

  /** What is neither saved nor has been open here has no picture, rather than that of something else. */
  #portray(canvas: HTMLCanvasElement): void {
    const { source } = canvas.dataset;
    if (!source) return;
    const [face, expression] = this.kind === "face" ? [source, "neutral"] : [PLAIN, source];
    if (this.kind !== "pose") this.context.thumbnails.ask(canvas, { face, expression });
    else if (this.store.library?.poses.has(this.store.library.sourceOf("poses", source)))
      this.context.thumbnails.ask(canvas, { face: PLAIN, expression: "neutral", pose: source });
  }
}
