/** A pad as it is edited, on air too: its looks are moved, added, named and taken away; its point is not. */

import { html, nothing } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { FEWEST_LOOKS } from "../../link/constants";
import type { PadLook, PadState } from "../../link/messages";
import { onArrows, onDrag, placeIn } from "../../ui/gestures";
import { base } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import { CARRIED, type CarriedLook } from "../palette/look_carry";
import { carries, droppedLook } from "../palette/look_drag";
import { posesFound } from "../palette/pose_commands";
import { foundIn } from "../palette/tile_groups";
import type { LookKind } from "../store/axis";
import { PadCommands, type PadDrag } from "./pad_commands";
import { padEditorStyle } from "./pad_editor_style";
import { across, PadFieldElement, placeAt, wayOf } from "./pad_field";
import {
  freeLabel,
  kindOf,
  nameTaken,
  type PadContent,
  padName,
  roomiest,
  scaled,
  spread,
  withMoved,
} from "./pad_layout";
import { padStyle } from "./pad_style";

/** A pointer this near to a look (of the pad's width) takes it along. */
const NEAR = 0.09;
const STEP = 0.05;
const SCALE = 1.15;
/** Milliseconds after the last key that moves a look, until that is one change. */
const PAUSE = 700;
/** Milliseconds for which a look that was let go is shown there before the show has answered. */
const OWED = 1000;
/** Faces or expressions that a search shows. */
const MOST_FOUND = 6;

/** Which pad is to be edited once the list has it: `from` by another name, or where that is null a copy. */
export type NextPad = Readonly<{ from: string | null; to: string }>;

/** Tells `done`, `draft` (a pad that is not kept yet), `next` (`NextPad`; null where the show has refused it). */
@customElement("omote-pad-editor")
export class PadEditor extends PadFieldElement {
  /** It has not been kept yet: it has too few looks. */
  @property({ type: Boolean }) draft = false;
  /** The looks under the hand of this page, until the show has them. */
  @state() private own: readonly PadLook[] | null = null;
  /** The look that buttons and keys change; by its label, which no other has. */
  @state() private chosen = "";
  @state() private search = "";
  /** What is typed a name of. */
  @state() private naming: "" | "pad" | "look" = "";
  /** Which pad has the name that was typed; "" for none. */
  @state() private taken = "";
  @state() private over = false;
  @query(".naming") private nameField!: HTMLInputElement | null;
  @query(".dot") private dot!: HTMLElement;
  @query(".depth") private slider!: HTMLElement | null;
  #drag: PadDrag | null = null;
  #at: number[] = [];
  #pause: ReturnType<typeof setTimeout> | undefined;
  #owed = 0;
  #wired: HTMLElement | null = null;

  static override styles = [base, padStyle, padEditorStyle];

  protected override get looks(): readonly PadLook[] {
    return this.own ?? this.pad.looks;
  }

  get #commands(): PadCommands {
    return new PadCommands(this.store);
  }

  get #kind(): LookKind {
    return kindOf(this.pad.part);
  }

  get #index(): number {
    return this.looks.findIndex(({ label }) => label === this.chosen);
  }

  override render() {
    const looks = this.looks;
    return html`<header>${this.heading()}<button class="done" aria-pressed="true" title="Back to playing" @click=${this.#done}>Done</button></header>
      <div class="body"><div class="well"><div class="square"><div class="field ${this.over ? "over" : ""}" role="group" tabindex="0" aria-label="Looks of ${this.pad.name}"
          @keydown=${this.#lookKey} @dragover=${this.#dragOver} @dragleave=${this.#dragOut} @drop=${this.#drop}>
          ${this.ground}<div class="carrier dot"></div>${looks.map((look, at) => this.picture(look, at))}
          ${looks.length < FEWEST_LOOKS ? html`<p class="hint">Drag ${this.#kind}s here, or search: a pad has two looks at least.</p>` : nothing}
        </div>${this.depthSlider}</div></div>
        <div class="tools">${this.naming === "" ? this.#tools() : this.#nameField()}</div></div>`;
  }

  #tools() {
    const none = this.#index < 0;
    const few = this.looks.length < FEWEST_LOOKS;
    return html`<div class="search">
        <input type="search" placeholder="Add look …" aria-label="Add a look: search ${this.#kind}s" .value=${this.search}
          @input=${(event: Event) => (this.search = textOf(event))} @keydown=${this.#searchKey} />
        ${this.search.trim() === "" ? nothing : html`<div class="found">${this.#found.map((tile, at) => html`<button class=${at === 0 ? "first" : ""} data-add=${tile.name} @click=${() => this.#add(tile.name)}>${tile.label}</button>`)}</div>`}
      </div>
      <button class="half" data-do="keep" title="What shows of it now, as a look at the point" @click=${this.#keep}>Keep what shows</button>
      <button data-do="name-look" ?disabled=${none} title="Another name for the look (F2)" @click=${() => this.#beginNaming("look")}>Name</button>
      <button data-do="remove" ?disabled=${none} title="Takes the look off the pad (Delete)" @click=${() => this.#remove()}>Remove</button>
      <button data-do="smaller" ?disabled=${few} title="All looks nearer to the middle" @click=${() => this.#scale(1 / SCALE)}>Closer</button>
      <button data-do="larger" ?disabled=${few} title="All looks farther from the middle" @click=${() => this.#scale(SCALE)}>Wider</button>
      <button data-do="rename" title="Another name for the pad" @click=${() => this.#beginNaming("pad")}>Rename</button>
      <button data-do="copy" ?disabled=${this.draft} @click=${this.#copy}>Copy</button>
      <button class="half" data-do="spread" ?disabled=${few} title="Evenly apart, in the order in which they lie" @click=${this.#spread}>Spread evenly</button>
      <button class="half" data-do="delete" title="Ctrl Z brings it back" @click=${this.#delete}>${this.draft ? "Discard" : "Delete pad"}</button>`;
  }

  #nameField() {
    const [what, before] = this.naming === "pad" ? ["pad", this.pad.name] : ["look", this.chosen];
    return html`<input class="naming" aria-label="Name of the ${what}" aria-describedby="name-note" .value=${before} maxlength=${this.naming === "pad" ? 24 : 40} @keydown=${this.#nameKey} @input=${() => (this.taken = "")} />
      <p id="name-note" class="whole note ${this.taken === "" ? "" : "wrong"}" role="status">${this.#nameNote}</p>
      <button class="whole" data-do="take-name" @click=${this.#takeName}>Take this name</button>
      <button class="whole" @click=${() => (this.naming = "")}>Cancel</button>`;
  }

  get #nameNote(): string {
    if (this.taken !== "") return `There is a pad ${this.taken} already.`;
    return this.naming === "pad" ? "Hyphens are put for spaces." : "";
  }

  get #found() {
    if (this.#kind === "pose") return posesFound(this.store, this.search).slice(0, MOST_FOUND);
    return foundIn(this.#kind === "face" ? this.store.faces : this.store.expressions, this.search).slice(0, MOST_FOUND);
  }

  override focus(): void {
    this.renderRoot.querySelector<HTMLElement>("input")?.focus();
  }

  protected override depth(): number {
    return this.looks[Math.max(0, this.#index)]?.place[2] ?? 0;
  }

  override firstUpdated(): void {
    this.addEventListener(CARRIED.over, this.#carried);
    this.addEventListener(CARRIED.drop, this.#carried);
    this.addEventListener(CARRIED.out, this.#dragOut);
    onDrag(this.field, {
      start: (x, y) => this.#take(x, y),
      move: (dx, dy) => this.#move([wayOf(dx), this.pad.dimensions === 1 ? 0 : wayOf(dy)]),
      end: () => this.#end(),
    });
    onArrows(
      this.field,
      (dx, dy) => this.#nudge([dx * STEP, dy * STEP, 0]),
      () => undefined,
    );
  }

  protected override willUpdate(): void {
    const arrived = this.own !== null && JSON.stringify(this.own) === JSON.stringify(this.pad.looks);
    if (this.#drag === null && (arrived || performance.now() > this.#owed)) this.own = null;
  }

  override updated(): void {
    super.updated();
    for (const picture of this.pictures) {
      const label = this.looks[Number(picture.dataset.at)]?.label ?? "";
      picture.classList.toggle("chosen", label === this.chosen);
      picture.tabIndex = 0;
      picture.setAttribute("role", "button");
      picture.setAttribute("aria-label", `${label}: arrows move it, Delete removes it, F2 names it`);
      picture.onfocus = () => {
        this.chosen = label;
      };
    }
    if (this.slider !== null && this.slider !== this.#wired) this.#wireDepth(this.slider);
    this.#wired = this.slider;
  }

  #wireDepth(slider: HTMLElement): void {
    onDrag(slider, {
      start: () => this.#begin(),
      move: (_, dy) => this.#move([0, 0, 2 * dy]),
      end: () => this.#end(),
    });
    onArrows(
      slider,
      (dx, dy) => this.#nudge([0, 0, (dx + dy) * STEP]),
      () => undefined,
    );
  }

  /** The look under the pointer, the nearest of several; none where there is none. */
  #take(x: number, y: number): void {
    const way = ({ place }: PadLook): number =>
      Math.hypot(x - across(place[0] as number), this.pad.dimensions === 1 ? 0 : y - across(place[1] as number));
    const [nearest] = [...this.looks].sort((a, b) => way(a) - way(b));
    this.chosen = nearest !== undefined && way(nearest) < NEAR ? nearest.label : "";
    if (this.chosen !== "") this.#begin();
  }

  #begin(): void {
    const look = this.looks[this.#index];
    if (look === undefined || this.draft) {
      this.#at = [...(look?.place ?? [])];
      return;
    }
    this.#endKeys();
    this.#at = [...look.place];
    this.#drag ??= this.#commands.drag({ ...this.pad, looks: this.looks }, `Moved ${this.chosen} on ${this.pad.name}`);
  }

  #move(by: readonly number[]): void {
    const index = this.#index;
    if (index < 0 || this.#at.length === 0) return;
    this.#at = this.#at.map((at, axis) => Math.max(-1, Math.min(1, at + (by[axis] ?? 0))));
    const looks = withMoved(this.looks, index, this.#at);
    if (this.draft) this.#tellDraft({ ...this.pad, looks });
    else {
      this.own = looks;
      this.#drag?.put(looks, performance.now());
    }
  }

  #end(): void {
    this.#at = [];
    this.#drag?.end(performance.now());
    this.#drag = null;
    this.#owed = performance.now() + OWED;
    setTimeout(() => this.requestUpdate(), OWED + 1);
  }

  /** Keys that follow each other are one change. */
  #nudge(by: readonly number[]): void {
    if (this.#index < 0) return;
    const waiting = this.#pause !== undefined;
    clearTimeout(this.#pause);
    this.#pause = undefined;
    if (!waiting) this.#begin();
    this.#move(by);
    this.#pause = setTimeout(() => this.#endKeys(), PAUSE);
  }

  #endKeys(): void {
    if (this.#pause === undefined) return;
    clearTimeout(this.#pause);
    this.#pause = undefined;
    this.#end();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#endKeys();
    if (this.#drag !== null) this.#end();
  }

  readonly #lookKey = (event: KeyboardEvent): void => {
    if (this.#index < 0) return;
    if (event.key === "F2") this.#beginNaming("look");
    else if (event.key === "Delete") this.#remove();
    else return;
    event.preventDefault();
    event.stopPropagation();
  };

  readonly #dragOver = (event: DragEvent): void => {
    if (!carries(event, this.#kind)) return;
    event.preventDefault();
    this.over = true;
  };

  readonly #dragOut = (): void => {
    this.over = false;
  };

  readonly #drop = (event: DragEvent): void => {
    this.over = false;
    const name = droppedLook(event, this.#kind);
    if (name === "") return;
    event.preventDefault();
    this.#addAt(name, event.clientX, event.clientY);
  };

  /** A finger carries a tile over it, and lets it go. */
  readonly #carried = (event: Event): void => {
    const { kind, name, x, y } = (event as CustomEvent<CarriedLook>).detail;
    if (kind !== this.#kind) return;
    this.over = event.type === CARRIED.over;
    if (event.type === CARRIED.drop) this.#addAt(name, x, y);
  };

  /** Puts a face, an expression or a pose where it was dropped, in pixels of the page. */
  #addAt(name: string, left: number, top: number): void {
    const [x, y] = placeIn(this.field.getBoundingClientRect(), left, top, [0.5, 0.5]);
    const flat = [placeAt(x), placeAt(y)].slice(0, this.pad.dimensions);
    this.#add(name, this.pad.dimensions === 3 ? [...flat, this.depth()] : flat);
  }

  /** Puts a face, an expression or a pose on the pad: where it was dropped, or where there is most room. */
  #add(name: string, place: readonly number[] = roomiest(this.looks, this.pad.dimensions)): void {
    const label = freeLabel(this.store.label(this.#kind, name), this.looks);
    this.search = "";
    this.#addLook({ label, mix: { [name]: 1 }, place: place.map((at) => Math.max(-1, Math.min(1, at))) });
  }

  #addLook(look: PadLook): void {
    const pad = this.#commands.added({ ...this.pad, looks: this.looks }, look);
    if (pad === null) return;
    this.chosen = look.label;
    this.#put(pad, `add ${look.label} to ${pad.name}`, `${look.label} stands on ${pad.name}.`);
  }

  readonly #keep = (): void => {
    const place = this.#point(performance.now());
    const look = this.#commands.shown({ ...this.pad, looks: this.looks }, place);
    if (look === null) this.store.say("Nothing shows that could be kept as a look.");
    else this.#addLook(look);
  };

  #remove(): void {
    const { looks } = this;
    const look = looks[this.#index];
    if (look === undefined) return;
    if (!this.draft && looks.length <= FEWEST_LOOKS) {
      this.store.say(`${this.pad.name} has two looks, as few as a pad can: add another one first, or delete the pad.`);
      return;
    }
    const left = looks.filter((other) => other !== look);
    this.#put(
      { ...this.pad, looks: left },
      `remove ${look.label} from ${this.pad.name}`,
      `${look.label} is off ${this.pad.name}.`,
    );
  }

  #scale(factor: number): void {
    const looks = scaled(this.looks, factor);
    this.#put(
      { ...this.pad, looks },
      `scale ${this.pad.name}`,
      `${this.pad.name}: looks stand ${factor > 1 ? "wider" : "closer"}.`,
    );
  }

  readonly #spread = (): void => {
    const looks = spread({ ...this.pad, looks: [...this.looks] });
    this.#put({ ...this.pad, looks }, `spread ${this.pad.name}`, `${this.pad.name}: looks stand evenly apart.`);
  };

  /** Keeps the pad with other looks, as soon as it has enough of them. */
  #put(pad: PadContent, what: string, done: string): void {
    if (pad.looks.length < FEWEST_LOOKS) this.#tellDraft(pad);
    else if (this.#commands.set(pad, what, done)) {
      this.own = this.draft ? null : pad.looks;
      this.#owed = performance.now() + OWED;
      if (this.draft) this.#tellDraft(pad);
    }
  }

  #tellDraft(pad: PadContent): void {
    this.dispatchEvent(new CustomEvent<PadContent>("draft", { detail: pad }));
  }

  #beginNaming(what: "pad" | "look"): void {
    if (what === "look" && this.#index < 0) return;
    this.naming = what;
    this.taken = "";
    this.#focusName();
  }

  #focusName(): void {
    void this.updateComplete.then(() => {
      this.nameField?.focus();
      this.nameField?.select();
    });
  }

  readonly #nameKey = (event: KeyboardEvent): void => {
    if (event.isComposing || (event.key !== "Enter" && event.key !== "Escape")) return;
    event.preventDefault();
    event.stopPropagation();
    if (event.key === "Enter") this.#takeName();
    else this.naming = "";
  };

  readonly #takeName = (): void => {
    const typed = this.nameField?.value.trim() ?? "";
    const { naming, pad } = this;
    const name = padName(typed);
    this.taken = naming === "pad" ? nameTaken(name, pad.name, this.store.newest("pad_list")?.pads ?? []) : "";
    if (this.taken !== "") {
      this.#focusName();
      return;
    }
    this.naming = "";
    if (typed === "") return;
    if (naming === "look") this.#nameLook(typed);
    else if (this.draft) this.#tellDraft({ ...pad, name });
    else this.#tellNext(pad.name, this.#commands.rename(pad as PadState, name, this.#refused));
  };

  readonly #refused = (): void => void this.dispatchEvent(new CustomEvent<NextPad | null>("next", { detail: null }));

  #nameLook(label: string): void {
    const before = this.chosen;
    if (label === before) return;
    const looks = this.looks.map((look) => (look.label === before ? { ...look, label } : look));
    this.chosen = label;
    this.#put({ ...this.pad, looks }, `name ${before} on ${this.pad.name}`, `${before} is called ${label} now.`);
  }

  readonly #copy = (): void => this.#tellNext(null, this.#commands.copy(this.pad as PadState, this.#refused));

  readonly #delete = (): void => {
    if (this.draft || this.#commands.delete(this.pad as PadState)) this.#done();
  };

  #tellNext(from: string | null, to: string | null): void {
    if (to !== null) this.dispatchEvent(new CustomEvent<NextPad | null>("next", { detail: { from, to } }));
  }

  readonly #done = (): void => void this.dispatchEvent(new CustomEvent("done"));

  readonly #searchKey = (event: KeyboardEvent): void => {
    const [first] = this.#found;
    if (event.key !== "Enter" || event.isComposing || this.search.trim() === "" || first === undefined) return;
    event.preventDefault();
    this.#add(first.name);
  };

  #point(now: number): number[] {
    return this.axes.map((axis) => this.store.pad(this.pad.name, axis).value(now));
  }

  /** Where the point is: it plays on while looks are moved under it. */
  protected override paintHands(now: number): void {
    const [x = 0, y = 0] = this.#point(now);
    this.write.style(this.dot, "transform", `translate(${100 * (across(x) - 0.5)}%, ${100 * (0.5 - across(y))}%)`);
    this.write.flag(this.dot, "air", this.store.air?.pads[this.pad.name]?.plays ?? false);
    const knob = this.renderRoot.querySelector<HTMLElement>(".knob");
    if (knob !== null) this.write.style(knob, "transform", `translateY(${-46 * this.depth()}%)`);
  }
}
