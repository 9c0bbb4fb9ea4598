/** The cues in the order of GO: a press has one stand by, or while editing opens it. */

import { html, nothing, type PropertyValues } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import { styleMap } from "lit/directives/style-map.js";
import type { Cue } from "../../link/messages";
import { base } from "../../ui/theme";
import { THUMBNAIL_SIZE, type Thumbnails } from "../../ui/thumbnails";
import { textOf } from "../../ui/topic_element";
import { CueElement, colourOf } from "./cue_element";
import { cueListStyle } from "./cue_list_style";
import { isFound, movedBehind } from "./cue_order";
import type { CueTopic } from "./cue_store";
import { goesOnWords, movesWords, titleWords } from "./cue_words";
import { missingInCue } from "./missing_names";
import { lookOf, shownCharacter, type Tracked, trackedLooks } from "./tracked_looks";

/** Where a cue that is dragged would come to lie. */
interface Drop {
  readonly dragged: string;
  /** The row at that edge, and which edge it is. */
  readonly row: string;
  readonly edge: "above" | "below";
}

/** Pixels from an edge of the list where a drag scrolls it, and how far. */
const [SCROLL_ZONE, SCROLL_STEP] = [48, 14];

@customElement("omote-cue-list")
export class CueListView extends CueElement {
  @property({ attribute: false }) thumbnails!: Thumbnails;
  @state() private drop: Drop | null = null;
  @query("input") private field!: HTMLInputElement;
  @query("ol") private rows!: HTMLElement;
  #standby: string | undefined;
  /** What each cue leaves standing, of the list that it was folded from. */
  #looks: { readonly of: readonly Cue[]; readonly each: readonly Tracked[] } = { of: [], each: [] };

  static override styles = [base, cueListStyle];

  protected override readonly topics: readonly CueTopic[] = ["list", "cues", "view", "link", "characters", "manifest"];

  /** Goes to the search. */
  search(): void {
    this.field.focus();
  }

  override render() {
    const { list, search, standby, way, edited, editing, locked } = this.cues;
    this.toggleAttribute("editing", editing);
    const shown = search.trim() === "" ? list : list.filter((cue) => isFound(cue, search));
    const row = (cue: Cue) =>
      this.#row(cue, { standby: standby?.identity, current: way.current?.identity, edited, editing });
    return html`<div class="head">
        <input type="search" placeholder="Search (/)" aria-label="Search cues" .value=${search} @input=${(event: Event) => this.cues.searchFor(textOf(event))}>
        ${shown.length < list.length ? html`<span role="status">${shown.length} of ${list.length}</span>` : nothing}<slot></slot>
      </div>
      <ol role="listbox" aria-label="Cues">${repeat(shown, ({ identity }) => identity, row)}${
        list.length > 0
          ? nothing
          : html`<li class="empty" role="option" aria-selected="false">${locked === "" ? "No cue yet. Set the stage at the console, then press Edit and Record here." : "No cue in this list."}</li>`
      }</ol>`;
  }

  #row(cue: Cue, { standby, current, edited, editing }: Marks) {
    const { identity, number, label, note, colour, skip } = cue;
    const [isCurrent, isStandby] = [identity === current, identity === standby];
    const drop = this.drop?.row === identity ? this.drop.edge : "";
    const classes = [
      isCurrent && "current",
      isStandby && "standby",
      skip && "skip",
      editing && identity === edited && "edited",
      drop,
    ];
    const mark = isStandby ? "▶" : isCurrent ? "●" : "";
    const { labels, known } = this.cues;
    const missing = known === null ? [] : missingInCue(cue, known);
    return html`<li class=${classes.filter(Boolean).join(" ")} role="option" data-cue=${identity} aria-selected=${isStandby} title=${note}
      @click=${() => (editing ? this.cues.edit(identity) : this.cues.setStandby(cue))}>
      <span class="colour" style=${styleMap({ background: colourOf(colour) })}></span>
      <span class="mark" aria-label=${isStandby ? "stands by" : isCurrent ? "was called last" : ""}>${mark}</span>
      <span class="number">${number}</span>
      <canvas width=${THUMBNAIL_SIZE.width} height=${THUMBNAIL_SIZE.height} aria-hidden="true" data-cue=${identity}></canvas>
      <span class="words"><span class="label">${label || html`<i>${titleWords(cue, labels)}</i>`}</span>
        ${note === "" ? nothing : html`<span class="note">${note}</span>`}${missing.length === 0 ? nothing : html`<span class="missing" title="GO leaves this out while it is not in the show">⚠ ${missing.join(", ")}</span>`}<span class="moves">${movesWords(cue, labels)}</span></span>
      <span class="times">${timesOf(cue)}</span>
      ${editing ? this.#tools(cue) : nothing}
    </li>`;
  }

  #tools({ identity, number }: Cue) {
    const moved = (way: -1 | 1) => (event: Event) => {
      event.stopPropagation();
      this.move(identity, way);
    };
    return html`<span class="tools">
      <button class="up" aria-label="Cue ${number} one place up" @click=${moved(-1)}>↑</button>
      <button class="down" aria-label="Cue ${number} one place down" @click=${moved(1)}>↓</button>
      <button class="handle" aria-label="Drag cue ${number}" title="Drag" @click=${(event: Event) => event.stopPropagation()}
        @pointerdown=${(event: PointerEvent) => this.#grip(event, identity)} @pointermove=${this.#drag}
        @pointerup=${this.#release} @pointercancel=${this.#abandon}>≡</button>
    </span>`;
  }

  /** Moves a cue by one place. */
  move(identity: string, way: -1 | 1): void {
    const after = movedBehind(this.cues.list, identity, way);
    if (after !== null) this.cues.change({ type: "move_cue", cue: identity, after });
  }

  #grip(event: PointerEvent, dragged: string): void {
    if (event.button !== 0) return;
    (event.currentTarget as Element).setPointerCapture(event.pointerId);
    this.drop = { dragged, row: "", edge: "above" };
  }

  readonly #drag = ({ clientX, clientY }: PointerEvent): void => {
    if (this.drop === null) return;
    const box = this.rows.getBoundingClientRect();
    if (clientY < box.top + SCROLL_ZONE) this.rows.scrollTop -= SCROLL_STEP;
    if (clientY > box.bottom - SCROLL_ZONE) this.rows.scrollTop += SCROLL_STEP;
    const row = (this.renderRoot as ShadowRoot)
      .elementFromPoint(clientX, clientY)
      ?.closest<HTMLElement>("li[data-cue]");
    if (row?.dataset.cue === undefined) return;
    const { top, height } = row.getBoundingClientRect();
    this.drop = { ...this.drop, row: row.dataset.cue, edge: clientY < top + height / 2 ? "above" : "below" };
  };

  readonly #release = (): void => {
    const { drop } = this;
    this.drop = null;
    if (drop === null || drop.row === "" || drop.row === drop.dragged) return;
    const others = this.cues.list.filter(({ identity }) => identity !== drop.dragged);
    const at = others.findIndex(({ identity }) => identity === drop.row);
    const after = drop.edge === "below" ? drop.row : (others[at - 1]?.identity ?? "");
    this.cues.change({ type: "move_cue", cue: drop.dragged, after });
  };

  readonly #abandon = (): void => {
    this.drop = null;
  };

  /** The standby is in sight whenever it is another, and the pictures are those of the cues. */
  override updated(_: PropertyValues): void {
    const { editing, edited, standby, way } = this.cues;
    const shown = (editing ? edited : (standby ?? way.current)?.identity) ?? undefined;
    const row = this.renderRoot.querySelector(`li[data-cue="${shown}"]`); // not there before the list is
    if (shown !== this.#standby) row?.scrollIntoView({ block: "nearest" });
    if (row !== null || shown === undefined) this.#standby = shown;
    this.#showPictures();
  }

  #showPictures(): void {
    const { list, show } = this.cues;
    if (list !== this.#looks.of) this.#looks = { of: list, each: trackedLooks(list) };
    const looks = this.#looks.each;
    const canvases = new Map(
      [...this.renderRoot.querySelectorAll("canvas")].map((canvas) => [canvas.dataset.cue, canvas] as const),
    );
    for (const [at, cue] of list.entries()) {
      const [canvas, character] = [canvases.get(cue.identity), shownCharacter(cue)];
      if (canvas === undefined) continue;
      canvas.style.visibility = character === null ? "hidden" : "";
      if (character === null) continue;
      const home = show.state?.characters[character]?.home_face ?? "generic";
      this.thumbnails.ask(canvas, lookOf(looks[at] ?? {}, character, home, this.cues.pads ?? []));
    }
  }
}

interface Marks {
  readonly standby: string | undefined;
  readonly current: string | undefined;
  readonly edited: string | null;
  readonly editing: boolean;
}

/** Waits, and what goes on by itself. */
function timesOf(cue: Cue) {
  const { pre_wait, moves, actions } = cue;
  const ends = Object.values(moves).map((move) => move.seconds + move.delay);
  const seconds = Math.max(0, ...ends, ...actions.map(({ delay }) => delay));
  return html`<span>${pre_wait > 0 ? `after ${pre_wait} s, ` : ""}${seconds} s</span>${
    actions.length === 0
      ? nothing
      : html`<span class="does">⇢ ${[...new Set(actions.map(({ does }) => does))].join(", ")}</span>`
  }${cue.goes_on === "" ? nothing : html`<b>↓ ${goesOnWords(cue)}</b>`}`;
}
