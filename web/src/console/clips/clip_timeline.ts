/** The time line of the shown clip: a ruler with its trim, a row for each lane, what is recorded, and where it is now. */

import { html, nothing, svg } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import { CLIP_PARTS } from "../../link/constants";
import type { ClipOutline, ClipPass, LaneOutline } from "../../link/messages";
import { base } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import { AnimatedClipElement, numberIn } from "./clip_element";
import { clipTime, partsLabel } from "./clip_passes";
import type { ClipTopic } from "./clip_store";
import { clipTimelineStyle } from "./clip_timeline_style";
import { columnLabel, curvePath, rulerMarks, type Span, spanBetween, viewSpan } from "./timeline";
import { fetchWaveform, type Waveform, wavePath } from "./waveform";

const COLOURS = ["#7fd1ff", "#ffd27f", "#b7f09a"];
/** Where the sound of a new clip begins: a moment after its first pass, seconds. */
const FIRST_AT = 0.4;
const NEAREST = 40;
/** Pixels that a pointer moves before it drags. */
const SLACK = 4;
/** Pixels beside the end that the place now is kept from. */
const MARGIN = 40;

/** What is dragged: a lane or the sound to another time, or an end of the clip. */
type Dragged = { readonly of: number | "start" | "stop" | "sound_at"; readonly seconds: number };

@customElement("omote-clip-timeline")
export class ClipTimeline extends AnimatedClipElement {
  /** Pixels that the page has for it. */
  @state() private wide = 0;
  /** How many times nearer than all of it. */
  @state() private nearer = 1;
  @state() private dragged: Dragged | null = null;
  /** The span that is being selected. */
  @state() private selecting: Span | null = null;
  @query(".scroll") private pane!: HTMLElement;
  @query(".playhead") private head!: HTMLElement;
  /** The sound of the clip as it is drawn, once it is decoded. */
  @state() private wave: Waveform | null = null;
  #fetched = "";
  #recorded = "";
  #shown: Span = { from: 0, to: 10 };
  #pixels = 1;

  static override styles = [base, clipTimelineStyle];

  protected override readonly topics: readonly ClipTopic[] = ["clips", "work", "view", "link"];

  override firstUpdated(): void {
    new ResizeObserver(() => {
      this.wide = this.pane.clientWidth;
    }).observe(this.pane);
  }

  /** The lane that is recorded comes in sight. */
  override updated(): void {
    const { pass, name } = this.clips;
    const recorded = pass !== null && pass.name === name ? `${name}/${pass.lane}/${pass.began}` : "";
    if (recorded !== "" && recorded !== this.#recorded)
      this.renderRoot.querySelector(".recorded")?.scrollIntoView({ block: "nearest", inline: "nearest" });
    this.#recorded = recorded;
  }

  /** Nearer, farther, or all of it. */
  zoom(way: -1 | 0 | 1): void {
    this.nearer = way === 0 ? 1 : Math.min(NEAREST, Math.max(1, this.nearer * (way > 0 ? 1.5 : 1 / 1.5)));
  }

  get #left(): number {
    return Number.parseFloat(getComputedStyle(this).getPropertyValue("--head")) || 0;
  }

  override render() {
    const { outline, pass, lanes, name } = this.clips;
    this.#shown = viewSpan(outline, this.clips.position);
    const room = Math.max(120, this.wide - this.#left);
    this.#pixels = (room / (this.#shown.to - this.#shown.from)) * this.nearer;
    const length = Math.floor((this.#shown.to - this.#shown.from) * this.#pixels);
    return html`<div class="scroll"><div class="content" style="--length: ${length}px; --view: ${this.wide}px">
      ${this.#ruler(outline)}
      ${this.#sound()}
      ${repeat(
        lanes,
        (_, place) => `${name}/${place}`,
        (lane, place) => this.#lane(lane, place),
      )}
      ${pass !== null && pass.name === name ? this.#recording(pass) : nothing}
      ${lanes.length === 0 && pass === null ? html`<p class="none">${name === "" ? "No clip is shown: choose one, or begin a new one (N)." : `${name} has no lane yet: arm parts, and record (R).`}</p>` : nothing}
      <div class="cursor" style="transform: translateX(${this.#x(this.clips.cursor)}px)"></div><div class="playhead"></div>
    </div></div>`;
  }

  #ruler(outline: ClipOutline | null) {
    return html`<div class="row ruler-row"><div class="head">
        <button aria-label="Farther" title="Farther (−)" @click=${() => this.zoom(-1)}>−</button><button aria-label="Nearer" title="Nearer (=)" @click=${() => this.zoom(1)}>+</button><button title="All of it (0)" @click=${() => this.zoom(0)}>All</button>
        <button aria-label="Earlier" title="Earlier" ?disabled=${this.nearer === 1} @click=${() => this.#page(-1)}>◂</button><button aria-label="Later" title="Later" ?disabled=${this.nearer === 1} @click=${() => this.#page(1)}>▸</button>
      </div>
      <div class="ruler" @pointerdown=${this.#seek}>
        ${rulerMarks(this.#shown, this.#pixels).map((seconds) => html`<span class="mark" style="left: ${this.#x(seconds)}px">${clipTime(seconds).replace(/\.0$/, "")}</span>`)}
        ${outline === null ? nothing : this.#trim(outline)}${this.#span()}
      </div></div>`;
  }

  #trim(outline: ClipOutline) {
    const { start, stop } = this.#ends(outline);
    const length = Math.max(0.01, stop - start);
    const [come, go] = [outline.blend_in / length, outline.blend_out / length].map((part) => 1000 * Math.min(1, part));
    const end = (
      of: "start" | "stop",
      at: number,
      label: string,
    ) => html`<div class="handle ${of === "start" ? "from" : "to"}" role="slider" tabindex="0" aria-label=${label}
      aria-valuenow=${at} aria-valuetext=${clipTime(at)} style="left: ${this.#x(at)}px" title="${label}: drag, or arrow keys"
      @pointerdown=${(event: PointerEvent) => this.#drag(event, of)} @keydown=${(event: KeyboardEvent) => this.#nudge(event, of)}></div>`;
    return html`<div class="trim" style="left: ${this.#x(start)}px; width: ${length * this.#pixels}px">
        <svg viewBox="0 0 1000 100" preserveAspectRatio="none" aria-hidden="true">${svg`<path d="M0 100L${come} 4L${1000 - (go ?? 0)} 4L1000 100" />`}</svg></div>
      ${end("start", start, "Start of the clip")}${end("stop", stop, "End of the clip")}`;
  }

  /** Where the clip begins and ends, as it is dragged. */
  #ends({ start, stop }: ClipOutline): { start: number; stop: number } {
    const { dragged } = this;
    const by = (of: "start" | "stop"): number => (dragged?.of === of ? dragged.seconds : 0);
    return { start: Math.min(start + by("start"), stop - 0.05), stop: Math.max(stop + by("stop"), start + 0.05) };
  }

  /** The sound that the clip is played and recorded along with. */
  #sound() {
    const { clips } = this;
    const { namedSound: named, outline } = clips;
    const key = named?.sound ?? clips.sound;
    if (key === "" || clips.name === "") return nothing;
    if (this.#fetched !== key) void this.#fetch(key);
    const wave = this.wave?.key === key ? this.wave : null;
    const at = outline?.sound_at ?? FIRST_AT;
    const moved = this.dragged?.of === "sound_at" ? this.dragged.seconds : 0;
    const width = Math.max(2, (named?.seconds ?? wave?.seconds ?? 1) * this.#pixels);
    const label = `${named?.name ?? "a sound that is not kept"}${moved === 0 ? "" : ` · ${moved > 0 ? "+" : ""}${moved.toFixed(2)} s`}`;
    return html`<div class="row" role="group" aria-label="Sound"><div class="head">♪ ${named?.name ?? ""}</div>
      <div class="body heard"><div class="block" style="left: ${this.#x(at + moved)}px; width: ${width}px">
        <div class="strip" role="slider" tabindex=${outline === null ? -1 : 0} aria-label="The sound begins" aria-valuenow=${at} aria-valuetext=${clipTime(at)}
          title="It begins: drag, or arrow keys" @pointerdown=${(event: PointerEvent) => outline !== null && this.#drag(event, "sound_at")} @keydown=${(event: KeyboardEvent) => this.#nudge(event, "sound_at")}>${label}</div>
        <svg viewBox="0 0 1000 100" preserveAspectRatio="none" aria-hidden="true">${wave === null ? nothing : svg`<path class="wave" d=${wavePath(wave.peaks)} />`}</svg>
      </div></div></div>`;
  }

  async #fetch(key: string): Promise<void> {
    this.#fetched = key;
    const wave = await fetchWaveform(key);
    if (this.#fetched === key) this.wave = wave;
  }

  #lane(lane: LaneOutline, place: number) {
    const { clips } = this;
    const chosen = place === clips.lane;
    return html`<div class="row lane ${chosen ? "chosen" : ""} ${lane.muted ? "muted" : ""}" role="group" aria-label="Lane ${place + 1} ${lane.name}" aria-current=${chosen} @focusin=${() => chosen || clips.chooseLane(place)}>
      <div class="head" @pointerdown=${() => chosen || clips.chooseLane(place)}>${this.#controls(lane, place)}</div>
      <div class="body" @pointerdown=${(event: PointerEvent) => this.#press(event, place)}>${this.#block(lane, place)}${chosen ? this.#span() : nothing}</div>
    </div>`;
  }

  #controls(lane: LaneOutline, place: number) {
    const { clips } = this;
    const barred = clips.locked !== "";
    const called = `lane ${place + 1}`;
    const shared = lane.parts.some((part) => clips.chosenLane?.parts.includes(part));
    const instead = clips.span !== null && place !== clips.lane && shared;
    return html`<span class="number">${place + 1}</span><input class="name" aria-label="Name of ${called}" maxlength="40" ?disabled=${barred} .value=${lane.name} autocomplete="off"
        @change=${(event: Event) => clips.editLane(place, { to: textOf(event).trim() }, `Lane ${place + 1} is named`)}>
      <button class="mute" aria-label="Mute ${called}" title="Mute (M)" aria-pressed=${lane.muted} ?disabled=${barred} @click=${() => clips.toggleMute(place)}>M</button>
      <button class="more" aria-label="Delete ${called}" title="Delete it; Undo brings it back" ?disabled=${barred || clips.lanes.length === 1} @click=${() => clips.dropLane(place)}>✕</button>
      ${instead ? html`<button class="instead" title="It shows in the chosen lane within the span, and is no lane of its own any more" ?disabled=${barred} @pointerdown=${(event: Event) => event.stopPropagation()} @click=${() => clips.replaceBy(place)} @focus=${(event: Event) => event.stopPropagation()} @focusin=${(event: Event) => event.stopPropagation()}>Into the span</button>` : nothing}
      <div class="line more"><label>Weight<input type="range" min="0" max="1" step="0.01" aria-label="Weight of ${called}" title=${lane.weight} ?disabled=${barred} .value=${String(lane.weight)}
          @change=${(event: Event) => this.#weigh(event, place)}></label>
        <label>Shift<button aria-label="${called} 10 ms earlier" title="10 ms earlier (Alt ←)" ?disabled=${barred} @click=${() => clips.shift(place, -0.01)}>◂</button><input class="seconds" inputmode="decimal" aria-label="Shift of ${called}, seconds" ?disabled=${barred} .value=${String(Math.round(lane.shift * 1000) / 1000)}
          @change=${(event: Event) => this.#shiftTo(event, lane, place)}><button aria-label="${called} 10 ms later" title="10 ms later (Alt →)" ?disabled=${barred} @click=${() => clips.shift(place, 0.01)}>▸</button></label></div>
      <div class="line parts more" role="group" aria-label="Parts of ${called}">${CLIP_PARTS.map((part) => html`<button title="It plays the ${part}" aria-pressed=${lane.parts.includes(part)} ?disabled=${barred} @click=${() => clips.togglePart(place, part)}>${part}</button>`)}</div>`;
  }

  /** A slider that a pointer has moved leaves the arrow keys to the page. */
  #weigh(event: Event, place: number): void {
    const slider = event.target as HTMLInputElement;
    this.clips.editLane(place, { weight: Number(slider.value) }, `Lane ${place + 1} weighs ${slider.value}`);
    if (!slider.matches(":focus-visible")) slider.blur();
  }

  #shiftTo(event: Event, lane: LaneOutline, place: number): void {
    const seconds = numberIn(textOf(event));
    if (seconds === null) (event.target as HTMLInputElement).value = String(lane.shift);
    else this.clips.shiftTo(place, seconds);
  }

  #block(lane: LaneOutline, place: number) {
    const later = this.dragged?.of === place ? this.dragged.seconds : 0;
    const [left, width] = [this.#x(lane.start + later), Math.max(2, (lane.stop - lane.start) * this.#pixels)];
    const moves = Object.entries(lane.moves);
    return html`<div class="block" style="left: ${left}px; width: ${width}px">
      <div class="strip" title="Drag: it comes earlier or later" @pointerdown=${(event: PointerEvent) => this.#drag(event, place)}>${lane.name || `lane ${place + 1}`}${lane.parts.length === CLIP_PARTS.length ? "" : ` · ${lane.parts.join(" ")}`}${later === 0 ? "" : ` · ${later > 0 ? "+" : ""}${later.toFixed(3)} s`}</div>
      ${lane.spans.map(([from, to]) => html`<div class="again" title="Replaced" style="left: ${(from - lane.start) * this.#pixels}px; width: ${(to - from) * this.#pixels}px"></div>`)}
      <svg viewBox="0 0 1000 100" preserveAspectRatio="none" aria-hidden="true">${moves.map(([column, values], at) => svg`<path style="stroke: ${COLOURS[at] ?? "#fff"}" d=${curvePath(values, /^(head|gaze)\//.test(column))} />`)}</svg>
      <div class="moved">${moves.map(([column], at) => html`<span style="color: ${COLOURS[at] ?? "#fff"}">${columnLabel(column)} </span>`)}</div>
    </div>`;
  }

  #span() {
    const span = this.selecting ?? this.clips.span;
    if (span === null) return nothing;
    return html`<div class="span" style="left: ${this.#x(span.from)}px; width: ${(span.to - span.from) * this.#pixels}px"></div>`;
  }

  #recording({ parts, lane, start }: ClipPass) {
    return html`<div class="row recorded" aria-label="Recorded now"><div class="head"><b>● ${lane}</b> ${partsLabel(parts, CLIP_PARTS.length)}</div>
      <div class="body"><div class="block recording now" style="left: ${this.#x(start)}px; width: 1px"></div></div></div>`;
  }

  // --- pointers ---

  /** Pixels of a time from the left of the curves. */
  #x(seconds: number): number {
    return Math.round((seconds - this.#shown.from) * this.#pixels * 10) / 10;
  }

  /** The time under a pointer. */
  #at(event: PointerEvent, element: Element): number {
    return this.#shown.from + (event.clientX - element.getBoundingClientRect().left) / this.#pixels;
  }

  /** Follows a pointer until it is let go. */
  #follow(event: PointerEvent, move: (event: PointerEvent) => void, end: (dropped: boolean) => void): void {
    const element = event.currentTarget as HTMLElement;
    element.setPointerCapture(event.pointerId);
    const ending = new AbortController();
    const { signal } = ending;
    const over = (dropped: boolean) => (): void => {
      ending.abort();
      end(dropped);
    };
    element.addEventListener("pointermove", move, { signal });
    element.addEventListener("pointerup", over(true), { signal });
    element.addEventListener("pointercancel", over(false), { signal });
  }

  readonly #seek = (event: PointerEvent): void => {
    if (event.button !== 0) return;
    const ruler = event.currentTarget as HTMLElement;
    this.clips.seek(this.#at(event, ruler));
    this.#follow(
      event,
      (moved) => this.clips.playing === null && this.clips.seek(this.#at(moved, ruler)),
      () => undefined,
    );
  };

  /** A drag selects a span of the lane, a press chooses it and marks the place. */
  #press(event: PointerEvent, place: number): void {
    if (event.button !== 0) return;
    const body = event.currentTarget as HTMLElement;
    const [from, x] = [this.#at(event, body), event.clientX];
    let to: number | null = null;
    this.clips.chooseLane(place);
    this.#follow(
      event,
      (moved) => {
        if (to === null && Math.abs(moved.clientX - x) < SLACK) return;
        to = this.#at(moved, body);
        this.selecting = spanBetween(from, to);
      },
      (dropped) => {
        const span = this.selecting;
        this.selecting = null;
        if (dropped && to === null) this.clips.seek(from);
        else if (dropped) this.clips.select(span);
      },
    );
  }

  /** Drags a lane to another time, or an end of the clip. */
  #drag(event: PointerEvent, of: Dragged["of"]): void {
    if (event.button !== 0) return;
    event.stopPropagation();
    if (typeof of === "number") this.clips.chooseLane(of);
    if (this.clips.locked !== "") return;
    const x = event.clientX;
    this.#follow(
      event,
      (moved) => {
        const seconds = Math.round(((moved.clientX - x) / this.#pixels) * 100) / 100;
        if (this.dragged !== null || Math.abs(moved.clientX - x) >= SLACK) this.dragged = { of, seconds };
      },
      (dropped) => {
        const { dragged } = this;
        this.dragged = null;
        if (dropped && dragged !== null) this.#drop(dragged);
      },
    );
  }

  #drop({ of, seconds }: Dragged): void {
    const { outline } = this.clips;
    if (typeof of === "number") this.clips.shiftTo(of, (this.clips.lanes[of]?.shift ?? 0) + seconds);
    else if (outline !== null && seconds !== 0) this.#trimTo(of, outline[of] + seconds);
  }

  #trimTo(of: "start" | "stop" | "sound_at", seconds: number): void {
    const lanes = this.clips.outline?.lanes ?? [];
    const last = of === "sound_at" ? Infinity : Math.max(...lanes.map((lane) => lane.stop));
    this.clips.editClip({ [of]: Math.round(Math.min(seconds, last) * 1000) / 1000 });
  }

  #nudge(event: KeyboardEvent, of: "start" | "stop" | "sound_at"): void {
    const way = { ArrowLeft: -1, ArrowRight: 1 }[event.key];
    const { outline } = this.clips;
    if (way === undefined || outline === null || event.altKey || event.ctrlKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    this.#trimTo(of, outline[of] + way * (event.shiftKey ? 1 / 60 : 0.1));
  }

  #page(way: -1 | 1): void {
    this.pane.scrollBy({ left: way * 0.7 * (this.wide - this.#left) });
  }

  // --- what moves ---

  paint(): void {
    const { clips } = this;
    const { pass, position } = clips;
    const records = pass !== null && pass.name === clips.name;
    const moves = records || clips.playing !== null;
    if (records && position > this.#shown.to) this.requestUpdate();
    this.write.style(this.head, "transform", `translateX(${this.#x(position)}px)`);
    this.write.flag(this.head, "recording-now", records);
    const now = this.renderRoot.querySelector<HTMLElement>(".now");
    if (records && now !== null) now.style.width = `${Math.max(1, (position - pass.start) * this.#pixels)}px`;
    if (moves && this.nearer > 1) this.#keepInSight(this.#x(position));
  }

  #keepInSight(x: number): void {
    const room = this.wide - this.#left;
    const { scrollLeft } = this.pane;
    if (x < scrollLeft || x > scrollLeft + room - MARGIN) this.pane.scrollLeft = Math.max(0, x - MARGIN);
  }
}
