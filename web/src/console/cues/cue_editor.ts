/** The cue that is edited: every field of it, and its moves. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { keyed } from "lit/directives/keyed.js";
import { repeat } from "lit/directives/repeat.js";
import { EASING_NAMES } from "../../link/constants";
import { FIGURE_SHOTS, inSize } from "../../link/framings";
import type { Cue, Move } from "../../link/messages";
import { base, flow } from "../../ui/theme";
import { COLOURS, CueElement } from "./cue_element";
import { type CueField, secondsIn } from "./cue_field";
import "./clip_fields";
import { clipCallOf, goalOfClip } from "./clip_goal";
import "./cue_actions";
import "./cue_field";
import { movedBehind } from "./cue_order";
import type { CueTopic } from "./cue_store";
import { partWords } from "./cue_words";
import {
  CHARACTER_PARTS,
  firstGoal,
  type Goal,
  goalText,
  kindOf,
  parseGoal,
  partsInOrder,
  SCENE_PARTS,
} from "./goal_text";
import { missingInMove } from "./missing_names";
import { pointsOffered } from "./pad_goal";

const style = css`
  :host {
    overflow: auto;
    padding: 10px 12px;
  }
  header,
  .tools,
  .add {
    ${flow}
    gap: 6px;
  }
  h2 {
    flex: 1;
  }
  .fields {
    display: grid;
    grid-template-columns: repeat(6, minmax(0, 1fr));
    gap: 8px;
    margin: 10px 0;
  }
  .two {
    grid-column: span 2;
  }
  .three {
    grid-column: span 3;
  }
  .four {
    grid-column: span 4;
  }
  .six {
    grid-column: span 6;
  }
  .check {
    ${flow}
    gap: 8px;
    grid-column: span 3;
    align-self: end;
    min-height: 34px;
    flex-wrap: nowrap;
    color: var(--text);
  }
  .check input {
    width: 20px;
    height: 20px;
  }
  .tools button,
  .add button {
    min-height: var(--finger, 34px);
    color: var(--text);
  }
  .move {
    display: grid;
    grid-template-columns: minmax(0, 1fr) 58px 58px 84px;
    gap: 4px 6px;
    align-items: end;
    padding: 8px 0;
    border-top: 1px solid var(--line);
  }
  .move b {
    grid-column: 1 / -2;
    align-self: center;
    font-weight: 600;
  }
  .away {
    justify-self: end;
    width: 34px;
    padding: 0;
  }
  .add {
    align-items: end;
    padding: 8px 0;
    border-top: 1px solid var(--line);
  }
  .add > * {
    flex: 1 1 130px;
  }
  .add button {
    flex: none;
  }
  p {
    color: var(--dim);
  }
  .missing {
    grid-column: 1 / -1;
    margin: 0;
    color: var(--attention);
  }
  .to-list,
  .closer {
    color: var(--text);
  }
  @media (min-width: 721px) {
    .to-list {
      display: none; /* the list is beside it */
    }
  }
  @media (pointer: coarse) {
    :host {
      --finger: 44px;
    }
    .move {
      grid-template-columns: repeat(3, minmax(0, 1fr));
    }
    .move .goal {
      grid-column: 1 / -1;
    }
  }
`;

const GOES_ON = [
  ["", "on GO"],
  ["continue", "with it"],
  ["follow", "after it"],
] as const;
const EASINGS = EASING_NAMES.map((name) => [name, name] as const);

@customElement("omote-cue-editor")
export class CueEditor extends CueElement {
  /** The part that a move is added of. */
  @state() private added = "";

  static override styles = [base, style];

  protected override readonly topics: readonly CueTopic[] = ["list", "view", "cues", "manifest", "characters"];

  override render() {
    const cue = this.cues.find(this.cues.edited);
    if (cue === null)
      return html`<header><h2>Cue</h2>${this.#closer()}</header>
        <p>Choose a cue of the list, record what ${this.cues.show.bus === "air" ? "is on air" : "preview has"}, or begin an empty one.</p>`;
    return html`<header><h2>Cue ${cue.number}</h2>${this.#closer()}</header>${keyed(cue.identity, this.#cue(cue))}`;
  }

  /** An empty cue that was begun here is given its label first. */
  override updated(): void {
    if (this.cues.begun === null || this.cues.begun !== this.cues.edited) return;
    this.cues.begun = null;
    this.renderRoot.querySelector<CueField>('[label="Label"]')?.enter();
  }

  #closer() {
    return html`${this.cues.edited === null ? nothing : html`<button class="to-list" @click=${() => this.cues.edit(null)}>List</button>`}
      <button class="closer" title="Back to playing (Esc)" @click=${() => this.cues.setEditing(false)}>Done</button>`;
  }

  #cue(cue: Cue) {
    return html`${this.#tools(cue)}${this.#fields(cue)}
      <h2>Moves</h2>
      ${Object.keys(cue.moves).length === 0 ? html`<p>It moves nothing yet.</p>` : nothing}
      ${repeat(
        partsInOrder(Object.keys(cue.moves), Object.keys(this.cues.labels)),
        (part) => part,
        (part) => this.#move(cue, part, cue.moves[part] as Move),
      )}
      ${this.#adder(cue)}
      <h2>Also does</h2>
      <omote-cue-actions .cues=${this.cues} .cue=${cue}></omote-cue-actions>`;
  }

  #tools({ identity, number }: Cue) {
    const { list } = this.cues;
    const up = movedBehind(list, identity, -1);
    const down = movedBehind(list, identity, 1);
    const moved = (after: string | null) => () =>
      after !== null && this.cues.change({ type: "move_cue", cue: identity, after });
    return html`<div class="tools">
      <button title="Write what ${this.cues.show.bus === "air" ? "is on air" : "preview has"} into cue ${number}" @click=${() => this.cues.change({ type: "update_cue", cue: identity, cue_list: this.cues.name })}>Update</button>
      <button title="Shows cue ${number} in preview, whatever is on air" @click=${() => this.cues.lookAt(number)}>Preview</button>
      <button @click=${() => this.cues.add({ type: "copy_cue", cue: identity })}>Copy</button>
      <button aria-label="One place up" title="One place up (Alt ↑)" ?disabled=${up === null} @click=${moved(up)}>↑</button>
      <button aria-label="One place down" title="One place down (Alt ↓)" ?disabled=${down === null} @click=${moved(down)}>↓</button>
      <button @click=${() => this.cues.change({ type: "drop_cue", cue: identity })}>Delete</button>
    </div>`;
  }

  #fields(cue: Cue) {
    const put = (change: Partial<Cue>, failed: (reason: string) => void) =>
      this.cues.change({ type: "put_cue", cue: cue.identity, ...change }, failed);
    const field = (name: "number" | "label" | "note", label: string, wide: string, kind = "text") =>
      html`<omote-cue-field class=${wide} label=${label} kind=${kind} .value=${cue[name]}
        .save=${(text: string, failed: (reason: string) => void) => put({ [name]: text.trim() }, failed)}></omote-cue-field>`;
    const time = (name: "pre_wait" | "post_wait", label: string) =>
      html`<omote-cue-field class="two" label=${label} kind="number" .value=${String(cue[name])}
        .save=${(text: string, failed: (reason: string) => void) => put({ [name]: secondsIn(text) }, failed)}></omote-cue-field>`;
    return html`<div class="fields">
      ${field("number", "Number", "two", "number")}${field("label", "Label", "four")}${field("note", "Note", "six", "lines")}
      ${time("pre_wait", "Wait before, s")}
      <omote-cue-field class="two" label="Next goes on" .choices=${GOES_ON} .value=${cue.goes_on}
        .save=${(text: string, failed: (reason: string) => void) => put({ goes_on: text as Cue["goes_on"] }, failed)}></omote-cue-field>
      ${time("post_wait", "Wait after, s")}
      <omote-cue-field class="three" label="Colour" .choices=${coloursWith(cue.colour)} .value=${cue.colour}
        .save=${(text: string, failed: (reason: string) => void) => put({ colour: text }, failed)}></omote-cue-field>
      <label class="check"><input type="checkbox" .checked=${cue.skip}
        @change=${(event: Event) => put({ skip: (event.target as HTMLInputElement).checked }, (reason) => this.cues.show.say(reason))}>Skip: GO passes it by</label>
    </div>`;
  }

  #move(cue: Cue, part: string, move: Move) {
    const newest = (): Move => this.cues.newest(cue).moves[part] ?? move;
    const put = (change: Partial<Move>, failed: (reason: string) => void) =>
      this.cues.change({ type: "put_move", cue: cue.identity, part, ...newest(), ...change }, failed);
    const time = (name: "seconds" | "delay", label: string) =>
      html`<omote-cue-field label=${label} kind="number" .value=${String(move[name])}
        .save=${(text: string, failed: (reason: string) => void) => put({ [name]: secondsIn(text) }, failed)}></omote-cue-field>`;
    const { known } = this.cues;
    const missing = known === null ? [] : missingInMove(part, move.goal, known);
    return html`<div class="move" data-part=${part}>
      <b title=${part}>${partWords(part, this.cues.labels)}</b>
      <button class="away" aria-label="Delete the move of ${part}" title="Delete this move"
        @click=${() => this.cues.change({ type: "drop_move", cue: cue.identity, part })}>✕</button>
      <omote-cue-field class="goal" label="Goes to" .value=${goalText(part, nameOf(part, move.goal))} .offered=${this.#offered(part)}
        .save=${(text: string, failed: (reason: string) => void) => put({ goal: goalAfter(part, newest().goal, text) }, failed)}></omote-cue-field>
      ${time("seconds", "Seconds")}${time("delay", "Delay")}
      <omote-cue-field label="Easing" .choices=${EASINGS} .value=${move.easing}
        .save=${(text: string, failed: (reason: string) => void) => put({ easing: text }, failed)}></omote-cue-field>
      ${
        kindOf(part) === "clip"
          ? html`<omote-clip-fields .cues=${this.cues} .goal=${move.goal} .newest=${() => newest().goal}
        .save=${(goal: Record<string, number>, failed: (reason: string) => void) => put({ goal }, failed)}></omote-clip-fields>`
          : nothing
      }
      ${missing.length === 0 ? nothing : html`<p class="missing">⚠ There is ${missing.join(", ")} in the show now: until it comes, GO leaves this move out.</p>`}
    </div>`;
  }

  /** A part that the cue does not move yet, and where it is to go: the move is there once that is given. */
  #adder({ identity, moves }: Cue) {
    const parts = this.#parts.filter((part) => !(part in moves));
    const part = parts.includes(this.added) ? this.added : (parts[0] ?? "");
    const save = (text: string, failed: (reason: string) => void) =>
      this.cues.change({ type: "put_move", cue: identity, part, goal: parseGoal(part, text) }, failed);
    return html`<div class="add">
      <omote-cue-field label="Another part" .choices=${parts.map((each) => [each, partWords(each, this.cues.labels)])} .value=${part}
        .save=${(chosen: string) => {
          this.added = chosen;
        }}></omote-cue-field>
      <omote-cue-field class="new" of=${part} label="goes to (Enter adds it)" .value=${""} .offered=${this.#offered(part)} .save=${save}></omote-cue-field>
      ${firstGoal(part) === "" ? nothing : html`<button title="Adds it there" @click=${() => save(firstGoal(part), (reason) => this.cues.show.say(reason))}>${firstGoal(part)}</button>`}
    </div>`;
  }

  get #parts(): string[] {
    const characters = Object.keys(this.cues.show.state?.characters ?? {});
    return [
      ...characters.flatMap((name) => CHARACTER_PARTS.map((part) => `${name}/${part}`)),
      ...SCENE_PARTS.map((part) => `*/${part}`),
    ];
  }

  /** The names that a part can go to. */
  #offered(part: string): readonly string[] {
    const { faces, expressions, lights, state: shown } = this.cues.show;
    const kind = kindOf(part);
    if (kind === "clip") return ["stop", ...this.cues.clips];
    if (firstGoal(part) !== "") return [firstGoal(part)];
    if (kind === "framing") {
      const held = ["*", ...Object.keys(shown?.characters ?? {})];
      return held.flatMap((name) => [name, ...FIGURE_SHOTS.map((size) => inSize(name, size))]);
    }
    if (kind === "look") return this.#looked(part);
    const documents = kind === "face" ? faces : kind === "light" ? lights : expressions;
    return [...documents.map(({ name }) => name), ...pointsOffered(kind, this.cues.pads ?? [])];
  }

  /** What the eyes of a character can look at. */
  #looked(part: string): readonly string[] {
    const { state: shown } = this.cues.show;
    const others = Object.keys(shown?.characters ?? {}).filter((name) => !part.startsWith(`${name}/`));
    const points = Object.keys(shown?.gaze_points ?? {});
    return [
      "ahead",
      "stage",
      ...others.map((name) => `character ${name}`),
      ...points.map((name) => `gaze_point ${name}`),
    ];
  }
}

/** The goal of a part without how a clip plays, which has fields of its own. */
function nameOf(part: string, goal: Goal): Goal {
  const call = kindOf(part) === "clip" ? clipCallOf(goal) : null;
  return call === null ? goal : { [call.clip]: 1 };
}

/** The goal that a text says; another clip plays as the one before did. */
function goalAfter(part: string, before: Goal, text: string): Record<string, number> {
  const goal = parseGoal(part, text, before);
  if (kindOf(part) !== "clip") return goal;
  const [was, is] = [clipCallOf(before), clipCallOf(goal)];
  return was === null || is === null ? goal : goalOfClip({ ...was, clip: is.clip });
}

const coloursWith = (colour: string): (readonly [string, string])[] => {
  const named = ["", ...COLOURS, colour].filter((each, at, all) => all.indexOf(each) === at);
  return named.map((each) => [each, each || "none"]);
};
