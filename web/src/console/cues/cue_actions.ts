/** What a cue does beside moving parts: what it sends to others, and who says what. */

import { css, html, nothing, type PropertyValues } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import type { Cue, CueAction } from "../../link/messages";
import { base, flow } from "../../ui/theme";
import { CueElement } from "./cue_element";
import { secondsIn } from "./cue_field";
import "./cue_field";
import type { CueTopic } from "./cue_store";

type Does = CueAction["does"];
type Failed = (reason: string) => void;

const KINDS: readonly (readonly [Does, string])[] = [
  ["osc", "sends OSC"],
  ["midi", "sends MIDI"],
  ["say", "has said"],
];
/** What stands beside the two texts of each kind. */
const WORDS: Readonly<Record<Does, readonly [to: string, what: string]>> = {
  osc: ["Host:port", "Address and arguments"],
  midi: ["Device", "Bytes, or msc go 12.5"],
  say: ["Character", "Text"],
};

const style = css`
  .action {
    display: grid;
    grid-template-columns: minmax(0, 1fr) minmax(0, 2fr) 58px 34px;
    gap: 4px 6px;
    align-items: end;
    padding: 8px 0;
    border-top: 1px solid var(--line);
  }
  .action b {
    grid-column: 1 / -2;
    align-self: center;
    font-weight: 600;
  }
  .away {
    width: 34px;
    padding: 0;
  }
  .add {
    ${flow}
    gap: 6px;
    align-items: end;
    padding: 8px 0;
    border-top: 1px solid var(--line);
  }
  .add > * {
    flex: 1 1 110px;
  }
  .add button {
    flex: none;
    min-height: var(--finger, 34px);
    color: var(--text);
  }
  .wide,
  .delay {
    grid-column: span 2;
  }
`;

@customElement("omote-cue-actions")
export class CueActions extends CueElement {
  @property({ attribute: false }) cue: Cue | null = null;
  /** What is typed of another action, until it is whole. */
  @state() private added: CueAction = { does: "osc", to: "", what: "", delay: 0, voice: "", sound: "" };

  static override styles = [base, style];

  protected override readonly topics: readonly CueTopic[] = ["characters"];

  /** What was added is typed no more. */
  override willUpdate(changed: PropertyValues<this>): void {
    const before = changed.get("cue");
    const more = (this.cue?.actions.length ?? 0) > (before?.actions.length ?? 0);
    if (more && before?.identity === this.cue?.identity) this.added = { ...this.added, what: "" };
  }

  override render() {
    const actions = this.cue?.actions ?? [];
    return html`${actions.map((action, place) => this.#action(action, place))}${this.#adder()}`;
  }

  #action(action: CueAction, place: number) {
    const put = (change: Partial<CueAction>, failed: Failed) =>
      this.#put(
        this.#actions.map((each, at) => (at === place ? { ...each, ...change } : each)),
        failed,
      );
    const [to, what] = WORDS[action.does];
    const title = KINDS.find(([does]) => does === action.does)?.[1] ?? action.does;
    const field = (name: "to" | "what" | "voice" | "sound", label: string, look = "") =>
      html`<omote-cue-field class=${look} label=${label} .value=${action[name]} .offered=${name === "to" ? this.#offered(action.does) : name === "sound" ? this.#sounds : []}
        .save=${(text: string, failed: Failed) => put({ [name]: text.trim() }, failed)}></omote-cue-field>`;
    return html`<div class="action" data-action=${place}>
      <b>${title}</b>
      <button class="away" aria-label="Delete action ${place + 1}" title="Delete this action"
        @click=${() => this.#put(this.#actions.filter((_, at) => at !== place))}>✕</button>
      ${field("to", to)}${field("what", what)}
      <omote-cue-field class="delay" label="Delay" kind="number" .value=${String(action.delay)}
        .save=${(text: string, failed: Failed) => put({ delay: secondsIn(text) }, failed)}></omote-cue-field>
      ${
        action.does === "say"
          ? html`${field("voice", "Voice; none: lips alone", "wide")}${field("sound", "Or a sound of the show", "wide")}`
          : nothing
      }
    </div>`;
  }

  /** Another action: it is there once both of its texts are given. */
  #adder() {
    const { does, to, what } = this.added;
    const [toLabel, whatLabel] = WORDS[does];
    const type = (change: Partial<CueAction>): void => {
      this.added = { ...this.added, ...change };
    };
    const add = (failed: Failed): void => {
      const whole = this.added;
      if (whole.to === "" || whole.what === "") return;
      this.#put([...this.#actions, whole], failed);
    };
    return html`<div class="add">
      <omote-cue-field label="Another action" .choices=${KINDS} .value=${does}
        .save=${(chosen: string) => type({ does: chosen as Does, to: "" })}></omote-cue-field>
      <omote-cue-field label=${toLabel} .value=${to} .offered=${this.#offered(does)}
        .save=${(text: string, failed: Failed) => {
          type({ to: text.trim() });
          add(failed);
        }}></omote-cue-field>
      <omote-cue-field class="what" label="${whatLabel} (Enter adds it)" .value=${what}
        .save=${(text: string, failed: Failed) => {
          type({ what: text.trim() });
          add(failed);
        }}></omote-cue-field>
    </div>`;
  }

  get #actions(): readonly CueAction[] {
    return this.cue?.actions ?? [];
  }

  /** The names of the sounds that the show file keeps. */
  get #sounds(): readonly string[] {
    return (this.cues.show.newest("sounds")?.sounds ?? []).map(({ name }) => name);
  }

  /** Whom or what an action of a kind can be for. */
  #offered(does: Does): readonly string[] {
    if (does === "say") return ["*", ...Object.keys(this.cues.show.state?.characters ?? {})];
    const others = this.cues.list.flatMap(({ actions }) => actions).filter((action) => action.does === does);
    return [...new Set(others.map(({ to }) => to))];
  }

  #put(actions: readonly CueAction[], failed?: Failed): void {
    this.cues.change({ type: "put_cue", cue: this.cue?.identity ?? "", actions: [...actions] }, failed);
  }
}
