/** The page that compares two runs: their curves over one another, and how much later each cue was called. */

import { html, LitElement, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import type { RecordingsDocument } from "../../link/messages";
import { listenToKeys } from "../../ui/key_presses";
import { sinceOf } from "../../ui/show_times";
import { base, palette, toolPage } from "../../ui/theme";
import { textOf, whileShown } from "../../ui/topic_element";
import { type Note, type Run, readRecordings, readRun, seekReplay } from "../recordings";
import { type Anchor, inWords } from "./alignment";
import { type Choices, choicesOf, FIRST_SHOWN, nameOf, QUANTITIES } from "./choices";
import { Comparison, type Side } from "./comparison";
import { unpackRun } from "./curves";
import { COLOUR, type Mark } from "./run_chart";
import { runsPageStyle } from "./runs_page_style";
import { pan, type View, within, zoomAt } from "./view";
import "./run_chart";

const ZOOM = 1.5;
const PAN = 0.2;
const AT_ONCE = "0";

@customElement("omote-runs-page")
export class RunsPage extends LitElement {
  static override styles = [palette, base, toolPage, runsPageStyle];
  @state() private documents: RecordingsDocument[] = [];
  @state() private choices: Choices = { runs: [], a: 0, b: 0 };
  @state() private both: Comparison | undefined;
  @state() private anchor: Anchor = "cues";
  @state() private shown: readonly string[] = FIRST_SHOWN;
  @state() private without: "a" | "b" | undefined;
  @state() private character = "";
  @state() private view: View = { min: 0, max: 1 };
  @state() private here: number | undefined;
  @state() private looks: "a" | "b" = "b";
  @state() private failure = "";
  @state() private reading = true;
  #sides: { a: Side; b: Side } | undefined;
  #marks: readonly Mark[] = [];
  #asked = 0;

  constructor() {
    super();
    whileShown(this, () => listenToKeys({ page: (event, typing) => !typing && this.#key(event) }));
    void this.#open();
  }

  /** How often the view goes into the whole. */
  get #views(): number {
    const { min, max } = this.both?.whole ?? this.view;
    return (max - min) / (this.view.max - this.view.min);
  }

  /** Whether there is a replay that goes to a moment. */
  get #replays(): boolean {
    return this.documents[0] !== undefined && this.documents[0].now === null;
  }

  override render() {
    return html`<header>
        <h1>RUNS</h1>
        <nav>${this.#replays ? html`<a href="/replay" target="omote-replay">Replay</a>` : html`<a href="/console" target="omote-console">Console</a>`}<a href="/notes" target="omote-notes">Notes</a></nav>
        ${this.#choose("a")}${this.#choose("b")}
      </header>
      ${this.failure === "" ? nothing : html`<p class="lost" role="alert">${this.failure}</p>`}
      ${this.both === undefined ? html`<p class="none" role="status">${this.reading ? "Reading…" : "Nothing to compare yet."}</p>` : this.#compared(this.both)}`;
  }

  #choose(of: "a" | "b") {
    const { runs } = this.choices;
    const name = of.toUpperCase();
    const choose = (event: Event): void => {
      this.choices = { ...this.choices, [of]: Number(textOf(event)) };
      void this.#read();
    };
    return html`<span class="choice"><button style="color: ${COLOUR[of]}" aria-pressed=${this.without !== of} title="Show or hide ${name} (${name})" aria-label="Show ${name}" @click=${() => this.#toggle(of)}>${name}</button>
      <select aria-label="Run ${name}" @change=${choose}>${runs.map(
        (run, place) =>
          html`<option value=${place} ?selected=${place === this.choices[of]}>${nameOf(run, this.documents[0]?.files ?? [])}</option>`,
      )}</select></span>`;
  }

  #compared(both: Comparison) {
    const missing = (["a", "b"] as const).filter((of) => both[of].curves.times.length === 0);
    const quantities = QUANTITIES.filter(({ key }) => this.shown.includes(key));
    return html`<main>
      ${this.#tools(both)}
      ${missing.length === 0 ? nothing : html`<p class="lost" role="status">${missing.map((of) => of.toUpperCase()).join(" and ")}: recorded without curves, by an older Omote. Its cues are below.</p>`}
      <div class="charts" tabindex="0" role="group" aria-label="Curves: plus and minus zoom, left and right move, comma and full stop go from cue to cue, Enter looks">
        ${quantities.map((quantity) => {
          const draw = (of: "a" | "b") => (this.without === of ? { values: [] } : this.#drawn(of, quantity.key));
          return html`<omote-run-chart .heading=${quantity.label} .unit=${quantity.unit} .times=${both.times} .a=${draw("a")} .b=${draw("b")}
            .marks=${this.#marks} .view=${this.view} .whole=${both.whole} .here=${this.here}
            @look=${(event: CustomEvent<number>) => this.#look(event.detail)} @view=${(event: CustomEvent<View>) => this.#show(event.detail)}></omote-run-chart>`;
        })}
      </div>
      </main><section class="look">${this.#lookedAt(both)}</section><section class="cues">${this.#table(both)}</section>`;
  }

  /** Columns are laid out once: a chart is drawn anew where it gets others. */
  #drawnOnce = new Map<string, ReturnType<Comparison["drawn"]>>();

  #drawn(of: "a" | "b", key: string) {
    const known = this.#drawnOnce.get(`${of} ${key}`);
    const quantity = QUANTITIES.find((each) => each.key === key);
    if (known !== undefined || quantity === undefined || this.both === undefined) return known;
    const drawn = this.both.drawn(of, this.character, quantity);
    this.#drawnOnce.set(`${of} ${key}`, drawn);
    return drawn;
  }

  #tools(both: Comparison) {
    const notes = this.documents[0]?.markers ?? [];
    const value = this.anchor === "cues" || this.anchor === "start" ? this.anchor : "moment";
    return html`<div class="row tools">
        <select aria-label="Character" @change=${(event: Event) => this.#play(textOf(event))}>${both.characters.map((name) => html`<option ?selected=${name === this.character}>${name}</option>`)}</select>
        <select aria-label="Aligned at" @change=${this.#align}>
          <option value="cues" ?selected=${value === "cues"}>Aligned at each cue</option>
          <option value="start" ?selected=${value === "start"}>Aligned at the start</option>
          ${both.pairs.map(({ a, b, number }, place) => (a === undefined || b === undefined ? nothing : html`<option value="cue ${place}">Aligned at cue ${number}</option>`))}
          ${notePairs(both, notes).map(([name], place) => html`<option value="note ${place}">Aligned at “${name.slice(0, 30)}”</option>`)}
        </select>
        <button title="Zoom in (+)" aria-label="Zoom in" @click=${() => this.#zoom(1 / ZOOM)}>+</button>
        <button title="Zoom out (−)" aria-label="Zoom out" @click=${() => this.#zoom(ZOOM)}>−</button>
        <button title="Earlier (left)" aria-label="Earlier" @click=${() => this.#pan(-PAN)}>◂</button>
        <button title="Later (right)" aria-label="Later" @click=${() => this.#pan(PAN)}>▸</button>
        <button title="All of it (0)" @click=${() => this.#show(both.whole)}>All</button>
      </div>
      <div class="tools quantities" role="group" aria-label="Curves that are shown">
        ${QUANTITIES.map(({ key, label }) => html`<button aria-pressed=${this.shown.includes(key)} @click=${() => this.#chart(key)}>${label}</button>`)}
      </div>`;
  }

  #lookedAt(both: Comparison) {
    const at = this.here === undefined ? undefined : both.momentOf(this.looks, this.here);
    if (!this.#replays)
      return html`<p class="hint">${this.here === undefined ? "" : html`Here it is <b>${sinceOf(this.here)}</b> in A. `}<code>omote replay</code> shows the pictures.</p>`;
    const playable = (of: "a" | "b") => both[of].run.file === 0;
    return html`<iframe src="/stage" title="The replay"></iframe>
      <div class="row" role="group" aria-label="Which run is looked at">
        ${(["a", "b"] as const).map((of) => html`<button style="color: ${this.looks === of ? "" : COLOUR[of]}" aria-pressed=${this.looks === of} ?disabled=${!playable(of)} @click=${() => this.#lookAt(of)}>Look at ${of.toUpperCase()}</button>`)}
        <span class="at">${at === undefined ? "Press a time" : sinceOf(at)}</span>
      </div>`;
  }

  #table(both: Comparison) {
    const { differences } = both;
    if (differences.length === 0) return html`<p class="none">No cue was called in either.</p>`;
    const many = new Set(differences.map(({ list }) => list)).size > 1;
    const time = (at: number | undefined) => (at === undefined ? "–" : tenths(at));
    return html`<table><caption>When each cue was called</caption>
      <thead><tr><th scope="col">Cue</th><th scope="col">A</th><th scope="col">B</th><th scope="col">B came</th><th scope="col" title="Of the time since the cue before">after the cue before</th></tr></thead>
      <tbody>${differences.map((row) => {
        const place = both.cuePlace(row);
        return html`<tr aria-selected=${place !== undefined && place === this.here}><th scope="row"><button ?disabled=${place === undefined} aria-label="Look at cue ${row.number}" @click=${() => this.#lookNear(place)}>${row.number}${many ? html` <small>${row.list}</small>` : nothing}</button></th>
          <td>${time(row.a)}</td><td>${time(row.b)}</td>
          <td class=${classOf(row.late)}>${row.late === undefined ? (row.a === undefined ? "only in B" : "only in A") : inWords(row.late)}</td>
          <td class=${classOf(row.longer)}>${row.longer === undefined ? "" : signed(row.longer)}</td></tr>`;
      })}</tbody></table>`;
  }

  // --- what is read ---

  async #open(): Promise<void> {
    await this.#try(async () => {
      const first = await readRecordings();
      const others = (first.files ?? []).slice(1).map((_, place) => readRecordings(place + 1));
      this.documents = [first, ...(await Promise.all(others))];
      this.choices = choicesOf(this.documents);
    });
    await this.#read();
  }

  async #read(): Promise<void> {
    const { runs, a, b } = this.choices;
    const [one, other] = [runs[a], runs[b]];
    const asked = ++this.#asked;
    if (one === undefined || other === undefined) {
      this.reading = false;
      return;
    }
    this.reading = true;
    await this.#try(async () => {
      const sides = { a: await sideOf(one), b: await sideOf(other) };
      if (asked !== this.#asked) return; // others were chosen meanwhile
      this.#sides = sides;
      if (sides[this.looks].run.file !== 0) this.looks = this.looks === "a" ? "b" : "a";
      this.#compare("cues");
    });
    this.reading = false;
  }

  #compare(anchor: Anchor): void {
    if (this.#sides === undefined) return;
    const before = this.both?.whole;
    this.anchor = anchor;
    this.both = new Comparison(this.#sides.a, this.#sides.b, anchor);
    const { characters, whole } = this.both;
    if (!characters.includes(this.character)) this.character = characters[0] ?? "";
    this.#drawnOnce.clear();
    this.#marks = this.both.marks(this.documents[0]?.markers ?? []);
    this.here = undefined;
    this.view = before?.min === whole.min && before.max === whole.max ? this.view : whole;
  }

  async #try(act: () => Promise<void>): Promise<void> {
    try {
      await act();
      this.failure = "";
    } catch (error) {
      this.failure = (error as Error).message;
    }
  }

  // --- what is pressed ---

  readonly #align = (event: Event): void => {
    const [what, place = AT_ONCE] = textOf(event).split(" ");
    const { both } = this;
    if (both === undefined) return;
    const pair = both.pairs[Number(place)];
    const note = notePairs(both, this.documents[0]?.markers ?? [])[Number(place)];
    if (what === "cues" || what === "start") this.#compare(what);
    else if (what === "note" && note !== undefined) this.#compare({ a: note[1], b: note[2] });
    else if (pair?.a !== undefined && pair.b !== undefined) this.#compare({ a: pair.a, b: pair.b });
  };

  #toggle(of: "a" | "b"): void {
    this.without = this.without === of ? undefined : of;
  }

  #play(character: string): void {
    this.character = character;
    this.#drawnOnce.clear();
  }

  #chart(key: string): void {
    this.shown = this.shown.includes(key) ? this.shown.filter((each) => each !== key) : [...this.shown, key];
  }

  #show(view: View): void {
    if (this.both !== undefined) this.view = within(view, this.both.whole);
  }

  #zoom(factor: number): void {
    const { here, view, both } = this;
    const inside = here !== undefined && here >= view.min && here <= view.max;
    if (both !== undefined) this.#show(zoomAt(view, factor, inside ? here : (view.min + view.max) / 2, both.whole));
  }

  #pan(part: number): void {
    if (this.both !== undefined) this.#show(pan(this.view, part, this.both.whole));
  }

  #lookAt(of: "a" | "b"): void {
    this.looks = of;
    if (this.here !== undefined) this.#look(this.here);
  }

  /** Looks at a time that the view may not have: it then goes there. */
  #lookNear(place: number | undefined): void {
    if (place === undefined) return;
    const length = this.view.max - this.view.min;
    if (place < this.view.min || place > this.view.max)
      this.#show({ min: place - length / 2, max: place + length / 2 });
    this.#look(place);
  }

  #look(time: number): void {
    const { both, looks } = this;
    this.here = time;
    const at = both?.momentOf(looks, time);
    if (both === undefined || !this.#replays || at === undefined || both[looks].run.file !== 0) return;
    const { start, first } = both[looks].run;
    void this.#try(() => seekReplay(start, first + at));
  }

  #step(ahead: boolean): void {
    const { both } = this;
    const places = (both?.pairs.flatMap((pair) => both.cuePlace(pair) ?? []) ?? []).sort((one, other) => one - other);
    const from = this.here ?? (ahead ? -Infinity : Infinity);
    this.#lookNear(ahead ? places.find((place) => place > from) : places.reverse().find((place) => place < from));
  }

  #key(event: KeyboardEvent): void {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    const does: Record<string, () => void> = {
      "+": () => this.#zoom(1 / ZOOM),
      "=": () => this.#zoom(1 / ZOOM),
      "-": () => this.#zoom(ZOOM),
      "0": () => this.both && this.#show(this.both.whole),
      ArrowLeft: () => this.#pan(-PAN),
      ArrowRight: () => this.#pan(PAN),
      Home: () => this.#pan(-this.#views),
      End: () => this.#pan(this.#views),
      ",": () => this.#step(false),
      ".": () => this.#step(true),
      a: () => this.#toggle("a"),
      b: () => this.#toggle("b"),
    };
    const act = does[event.key];
    if (act === undefined) return;
    event.preventDefault();
    act();
  }
}

async function sideOf(run: Run): Promise<Side> {
  const document = await readRun(run);
  return { run, curves: await unpackRun(document), cues: document.cues };
}

/** Notes of the same words in both runs: their times in each. */
function notePairs({ a, b }: Comparison, notes: readonly Note[]): [name: string, a: number, b: number][] {
  const timed = ({ run }: Side) =>
    notes.flatMap(({ name, start, at }): [string, number][] =>
      run.file === 0 && start === run.start && at >= run.first && at <= run.first + run.seconds
        ? [[name, at - run.first]]
        : [],
    );
  const others = new Map(timed(b));
  return timed(a).flatMap(([name, at]): [string, number, number][] => {
    const other = others.get(name);
    return other === undefined ? [] : [[name, at, other]];
  });
}

const tenths = (seconds: number): string => `${sinceOf(seconds).replace(/^0:/, "")}.${Math.floor((seconds * 10) % 10)}`;
const signed = (seconds: number): string => `${seconds < 0 ? "−" : "+"}${Math.abs(seconds).toFixed(1)} s`;
const classOf = (seconds: number | undefined): string =>
  seconds === undefined || Math.abs(seconds) < 1 ? "" : seconds > 0 ? "late" : "early";
