/** The palette of faces or expressions with thumbnails, hot keys and search. */

import { html, nothing } from "lit";
import { customElement, property, query, queryAll, state } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import { EDITOR, EDITOR_TAB } from "../../link/editor_address";
import type { CharacterState } from "../../link/messages";
import { onHold, onRoam } from "../../ui/gestures";
import { base } from "../../ui/theme";
import { THUMBNAIL_SIZE, type ThumbnailSubject } from "../../ui/thumbnails";
import { textOf } from "../../ui/topic_element";
import { clipsFound, pressClip } from "../clips/clip_tiles";
import { AnimatedElement } from "../controls/console_element";
import type { OwnItem } from "../show_file/own_items";
import { KINDS, type PaletteKind } from "../store/arrangement";
import type { Axis } from "../store/axis";
import { keyLabel } from "../store/keys";
import type { Topic } from "../store/page_store";
import { calledRegions, regionMark, type ShownWeight, shownOf, targetsOf } from "../store/region_calls";
import { LookCarry } from "./look_carry";
import { carryLook } from "./look_drag";
import { ModelFace } from "./model_face";
import { style } from "./palette_style";
import type { PoseTiles } from "./pose_tiles";
import { expressionGroups, faceGroups, foundIn, isOwn, type PaletteTile, type TileGroup } from "./tile_groups";
import type { MenuRequest } from "./tile_menu";
import "../controls/timing_row";
import "./pose_tiles";
import "./region_row";

const LABELS: Readonly<Record<PaletteKind, string>> = {
  performed: "Performed",
  own: "Own",
  arkit: "ARKit",
  makehuman: "MakeHuman",
  poses: "Poses",
  clips: "Clips",
};
const SEARCHED = {
  face: "faces by name or tag",
  expression: "expressions by name, region or tag",
  clips: "clips by name",
  poses: "poses by name",
} as const;
/** Without a keyboard no key needs to be named. */
const FINGERS = matchMedia("(pointer: coarse)");

/** The faces or the expressions, as pictures: a tap calls one in the chosen time. */
@customElement("omote-palette")
export class Palette extends AnimatedElement {
  @property() axis: Axis = "face";
  @state() private search = "";
  /** The face that the expressions are shown on. */
  @state() private model = "generic";
  @query(".tiles") private list!: HTMLElement;
  @query("omote-pose-tiles") private poses!: PoseTiles | null;
  @query("input") private input!: HTMLInputElement | null;
  @queryAll(".tile") private tiles!: NodeListOf<HTMLElement>;
  readonly #model = new ModelFace("generic");

  static override styles = [base, style];

  protected override readonly topics: readonly Topic[] = ["manifest", "arrangement", "pad_edit"];

  private get kind(): PaletteKind {
    return this.store.arrangement.kind;
  }

  /** What the palette shows now, in order. */
  get shown(): readonly PaletteTile[] {
    return this.#sections(this.store.arrangement.ownFaces).flatMap(([, inside]) => inside);
  }

  /** The first nine of these have hot keys: what is shown, but a face keeps its key while own faces are shown alone. */
  get #keyed(): readonly PaletteTile[] {
    return this.#sections(false).flatMap(([, inside]) => inside);
  }

  #sections(ownFaces: boolean): readonly TileGroup[] {
    const all: readonly PaletteTile[] = this.axis === "face" ? this.store.faces : this.store.expressions;
    if (this.search.trim() !== "") return [["", foundIn(all, this.search)]];
    return this.axis === "face"
      ? faceGroups(this.store.faces, ownFaces)
      : expressionGroups(this.store.expressions, this.kind);
  }

  /** What stands in the place of expressions, if anything: motion clips, or poses of the figures. */
  get #instead(): "clips" | "poses" | null {
    if (this.axis === "face") return null;
    return this.kind === "clips" || this.kind === "poses" ? this.kind : null;
  }

  /** Calls the tile at an index, as its hot key does. */
  callIndex(index: number): void {
    const clip = this.#instead === "clips" ? clipsFound(this.store, "")[index] : undefined;
    if (clip !== undefined) pressClip(this.store, clip);
    this.poses?.callIndex(index);
    if (this.#instead !== null) return;
    const name = this.#keyed[index]?.name;
    if (name !== undefined) this.store.call(this.axis, name);
  }

  override focus(): void {
    this.input?.focus();
  }

  override render() {
    const instead = this.#instead;
    return html`
      <header>${this.axis === "face" ? this.#ownSwitch() : this.#tabs()} ${this.#searchField()}</header>
      <div class="tiles" ?hidden=${instead !== null} @scroll=${this.#hint} @contextmenu=${this.#menuAt} @keydown=${this.#tileKey}>${instead === null ? this.#tiles() : nothing}</div>
      ${instead === "clips" ? html`<omote-clip-tiles .context=${this.context} .search=${this.search}></omote-clip-tiles>` : nothing}
      ${instead === "poses" ? html`<omote-pose-tiles .context=${this.context} .search=${this.search}></omote-pose-tiles>` : nothing}
      ${this.axis === "face" || instead === "poses" ? nothing : html`<omote-regions .context=${this.context}></omote-regions>`}
      <omote-timing .context=${this.context} .axis=${this.axis}></omote-timing>
    `;
  }

  #tabs() {
    return html`<select class="kinds" aria-label="Kind of expressions" @change=${(event: Event) => this.#open(textOf(event) as PaletteKind)}>
        ${KINDS.map((kind) => html`<option value=${kind} .selected=${this.kind === kind}>${LABELS[kind]}</option>`)}
      </select>
      <div class="tabs" role="tablist" aria-label="Kinds of expressions">
      ${KINDS.map(
        (kind) => html`<button
          role="tab"
          data-kind=${kind}
          aria-selected=${this.kind === kind && (this.search === "" || this.#instead !== null)}
          @click=${() => this.#open(kind)}
        >
          ${LABELS[kind]}
        </button>`,
      )}
    </div>`;
  }

  #open(kind: PaletteKind): void {
    this.store.arrange({ kind });
    this.search = "";
  }

  #ownSwitch() {
    const { ownFaces } = this.store.arrangement;
    return html`<h2>Faces</h2>
      <div class="tabs">
        <button
          data-own-faces
          title="Your own faces alone; hot keys stay with their faces"
          aria-pressed=${ownFaces && this.search === ""}
          @click=${() => {
            this.store.arrange({ ownFaces: !ownFaces || this.search !== "" });
            this.search = "";
          }}
        >
          Own
        </button>
      </div>`;
  }

  #searchField() {
    const what = SEARCHED[this.#instead ?? this.axis];
    return html`<input
      type="search"
      placeholder=${this.axis === "face" || FINGERS.matches ? "search" : "search /"}
      aria-label="Search ${what}"
      .value=${this.search}
      @keydown=${this.#searchKey}
      @input=${(event: Event) => (this.search = textOf(event))}
    />`;
  }

  #tiles() {
    const { shown } = this;
    const keyed = this.#keyed;
    if (shown.length === 0 && this.search !== "")
      return html`<div class="none">Nothing is called "${this.search}".</div>`;
    if (shown.length === 0)
      return html`<div class="none">Nothing of your own yet: keep what is on air (${this.axis === "face" ? "N" : "M"}), or make one in the <a href=${EDITOR} target=${EDITOR_TAB}>editor</a>.</div>`;
    return this.#sections(this.store.arrangement.ownFaces).map(
      ([heading, inside]) => html`${heading === "" ? nothing : html`<div class="region">${heading}</div>`}
        ${repeat(
          inside,
          (tile) => tile.name,
          (tile) => this.#place(tile, keyed.indexOf(tile)),
        )}`,
    );
  }

  /** A tile, and over a corner of an own one what opens its menu, which never calls: for a mouse on it and for the
   * keyboard; a finger holds the tile, and its tap calls, wherever it falls. */
  #place(tile: PaletteTile, index: number) {
    const more = isOwn(tile)
      ? html`<button
          class="menu"
          aria-label="Menu of ${tile.label}"
          aria-haspopup="menu"
          title="Edit, rename or delete ${tile.label}"
          @click=${(event: MouseEvent) => this.#more(event, tile)}
          ><span aria-hidden="true">⋯</span></button
        >`
      : nothing;
    return html`<div class="place">${this.#tile(tile, index)}${more}</div>`;
  }

  #more(event: MouseEvent, tile: PaletteTile): void {
    if (event instanceof PointerEvent && event.pointerType === "touch") this.store.call(this.axis, tile.name);
    else this.#askMenu(tile.name);
  }

  /** The own item of a tile by its name; null for a built-in one. */
  #itemOf(name: string | undefined): OwnItem | null {
    const tile = this.shown.find((candidate) => candidate.name === name);
    return tile === undefined || !isOwn(tile) ? null : { kind: this.axis, name: tile.name, label: tile.label };
  }

  #askMenu(name: string | undefined): void {
    const item = this.#itemOf(name);
    const tile = [...this.tiles].find((element) => element.dataset.name === name)?.getBoundingClientRect();
    if (item === null || tile === undefined) return;
    this.dispatchEvent(new CustomEvent<MenuRequest>("menu", { detail: { item, tile } }));
  }

  readonly #menuAt = (event: MouseEvent): void => {
    const name = (event.target as Element).closest(".place")?.querySelector<HTMLElement>(".tile")?.dataset.name;
    if (this.#itemOf(name) === null) return;
    event.preventDefault();
    this.#askMenu(name);
  };

  /** Names or deletes the own tile in focus, as file managers do. */
  readonly #tileKey = (event: KeyboardEvent): void => {
    const item = this.#itemOf((event.target as HTMLElement).dataset.name);
    if (item === null || (event.key !== "F2" && event.key !== "Delete")) return;
    event.preventDefault();
    if (event.key === "F2") this.context.items.beginNaming(item);
    else this.context.items.delete(item);
  };

  #tile(tile: PaletteTile, index: number) {
    const key = this.search === "" ? keyLabel(this.axis, index) : null; // those keys type letters now
    return html`<button
      class=${isOwn(tile) ? "tile own" : "tile"}
      data-name=${tile.name}
      data-source=${tile.source}
      aria-label="${tile.label}${key === null ? "" : `, key ${key}`}"
      title=${[tile.name, ...tile.tags].join(", ")}
      draggable=${this.store.editedPad === "" ? "false" : "true"}
      @dragstart=${(event: DragEvent) => carryLook(event, this.axis, tile.name)}
      @click=${(event: MouseEvent) => this.#call(event, tile)}
    >
      <canvas width="${THUMBNAIL_SIZE.width}" height="${THUMBNAIL_SIZE.height}" aria-hidden="true"></canvas>
      <span class="name">${tile.label}</span>
      ${key === null ? nothing : html`<span class="key">${key}</span>`}
      <span class="where"></span>
      <span class="weight"></span>
    </button>`;
  }

  /** A tile that was clicked keeps no focus: the space bar would play it again long after another was called. */
  #call(event: MouseEvent, tile: PaletteTile): void {
    this.store.call(this.axis, tile.name);
    if (event.detail > 0) (event.currentTarget as HTMLElement).blur();
  }

  /** Enter in the search calls what is found first, the arrow leads to it. */
  readonly #searchKey = (event: KeyboardEvent): void => {
    if (this.search.trim() === "" || event.isComposing) return;
    const [first] = this.shown;
    if (this.#instead !== null) {
      if (event.key === "Enter" && this.#callFound()) event.preventDefault();
      return;
    }
    if (first === undefined) return;
    else if (event.key === "Enter") this.store.call(this.axis, first.name);
    else if (event.key === "ArrowDown") this.tiles[0]?.focus();
    else return;
    event.preventDefault();
  };

  /** Plays the clip or calls the pose that is found first; false where none is. */
  #callFound(): boolean {
    const clip = this.#instead === "clips" ? clipsFound(this.store, this.search)[0] : undefined;
    if (clip !== undefined) pressClip(this.store, clip);
    return clip !== undefined || this.poses?.callFirst() === true;
  }

  override firstUpdated(): void {
    onRoam(this.list, ".tile");
    const edits = (): boolean => this.store.editedPad !== "";
    const carry = new LookCarry(this.list, () => this.axis, "omote-pad-editor", edits);
    onHold(this.list, ".tile.own", (tile) => {
      if (!carry.carries) this.#askMenu(tile.dataset.name);
    });
    new ResizeObserver(this.#hint).observe(this.list);
  }

  /** Fades what goes on below: scroll bars are hidden on tablets until they are used. */
  readonly #hint = (): void => {
    const { scrollTop, clientHeight, scrollHeight } = this.list;
    this.write.flag(this.list, "more", scrollHeight - clientHeight - scrollTop > 4);
  };

  override updated(): void {
    this.#hint();
    for (const tile of this.tiles) {
      const source = tile.dataset.source ?? "";
      const sitting: ThumbnailSubject =
        this.axis === "face"
          ? { face: source, expression: "neutral" }
          : { face: this.#modelSource, expression: source };
      this.context.thumbnails.ask(tile.querySelector("canvas") as HTMLCanvasElement, sitting);
    }
  }

  /** What the model is now: an own face that was saved again is another picture. */
  get #modelSource(): string {
    return this.store.faces.find(({ name }) => name === this.model)?.source ?? this.model;
  }

  paint(now: number): void {
    const coming = targetsOf(this.store.callOf(this.axis), this.axis === "face" ? {} : this.store.air?.region_calls);
    const { air } = this.store;
    const regions = air === null ? {} : calledRegions(air);
    for (const tile of this.tiles) {
      const name = tile.dataset.name ?? "";
      const shown = this.#shown(name, regions);
      this.write.flag(tile, "coming", coming.has(name));
      this.write.flag(tile, "air", !coming.has(name) && shown.weight >= 0.001);
      const [where, bar] = [...tile.children].slice(-2) as [HTMLElement, HTMLElement];
      this.write.text(where, regionMark(shown));
      this.write.style(bar, "transform", `scaleX(${shown.weight.toFixed(3)})`);
    }
    if (this.axis === "expression")
      this.model = this.#model.follow(this.store.air?.faces ?? {}, this.store.callOf("face")?.target ?? null, now);
  }

  #shown(name: string, regions: CharacterState["regions"]): ShownWeight {
    const { air } = this.store;
    if (this.axis === "face" || air === null) return { weight: air?.faces[name] ?? 0, regions: [] };
    return shownOf(name, { ...air, regions });
  }
}
