/** What edits the list as a whole: record, an empty cue, numbers anew; each form stands over the list and closes by Escape. */

import { css, html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { layerWhileShown } from "../../ui/key_presses";
import { base, entry, flow } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import { CueElement } from "./cue_element";
import { secondsIn } from "./cue_field";
import type { CueTopic } from "./cue_store";
import { SCENE_PARTS } from "./goal_text";

export type CueFormKind = "record" | "renumber" | "add_list" | "rename_list" | "go_to" | "take_in";

const style = css`
  form {
    ${flow}
    gap: 6px 10px;
    padding: 8px 12px;
  }
  label {
    ${flow}
    gap: 5px;
    min-height: 34px;
    color: var(--dim);
  }
  input[type="file"] {
    max-width: 100%;
    color: var(--text);
  }
  input:not([type="checkbox"], [type="file"]) {
    ${entry}
    width: 76px;
    min-height: var(--finger, 34px);
    font-size: 14px;
  }
  input.wide {
    width: 180px;
  }
  input[type="checkbox"] {
    width: 20px;
    height: 20px;
  }
  fieldset {
    ${flow}
    gap: 4px 10px;
    min-width: 0;
    margin: 0;
    padding: 0;
    border: 0;
  }
  button {
    min-height: var(--finger, 34px);
    color: var(--text);
  }
  [role="alert"] {
    max-height: 30dvh;
    overflow: auto;
    white-space: pre-line;
    flex: 1 0 100%;
    color: var(--attention);
  }
  @media (pointer: coarse) {
    :host {
      --finger: 44px;
    }
    input:not([type="checkbox"]) {
      font-size: 16px;
    }
  }
`;

/** Each form sends once, and stays with its words where the show rejects it. */
@customElement("omote-cue-form")
export class CueForm extends CueElement {
  @property() kind: CueFormKind = "record";
  @state() private error = "";
  /** The number of the cue that is chosen, until another is typed. */
  #chosen: string | null = null;

  static override styles = [base, style];

  protected override readonly topics: readonly CueTopic[] = ["characters", "view", "cues"];

  constructor() {
    super();
    layerWhileShown(this, "form", this.close);
  }

  /** What was recorded is recorded: nothing of it is left for the next cue. */
  readonly #recordedOne = (): void => this.renderRoot.querySelector("form")?.reset();

  override firstUpdated(): void {
    this.renderRoot.querySelector<HTMLElement>("input")?.focus();
  }

  override render() {
    const [title, fields, does] = this.#form();
    return html`<form aria-label=${title} @submit=${this.#submit}>
      <h2>${title}</h2>${fields}<button type="submit">${does}</button><button type="button" @click=${this.close}>Close</button>
      ${this.error === "" ? nothing : html`<span role="alert">${this.error}</span>`}
    </form>`;
  }

  #form() {
    if (this.kind === "record")
      return [
        this.cues.show.bus === "air" ? "Record what is on air" : "Record what preview has",
        this.#recorded(),
        "Record",
      ] as const;
    if (this.kind === "renumber")
      return [
        "Number the list anew",
        html`${field("first", "From", "1")}${field("step", "by", "1")}`,
        "Renumber",
      ] as const;
    if (this.kind === "go_to")
      return [
        "Go to a cue",
        html`${this.#number()}${check("whole", "with all that the cues before it leave standing", true)}`,
        "Go to",
      ] as const;
    if (this.kind === "take_in") return [`Import into ${this.cues.name}`, FILE, "Take in"] as const;
    if (this.kind === "add_list") return ["A new list", field("name", "Name", "", "wide"), "Begin it"] as const;
    return ["Rename the list", field("name", "Name", this.cues.name, "wide"), "Rename"] as const;
  }

  /** The cue that is edited, stands by or was called last, until a number is typed. */
  #number() {
    const { cues } = this;
    const chosen = cues.editing ? cues.find(cues.edited) : null;
    const number = this.#chosen ?? (chosen ?? cues.standby ?? cues.way.current)?.number ?? "";
    const type = (event: Event): void => {
      this.#chosen = textOf(event);
    };
    return html`<label>Number<input name="number" .value=${number} autocomplete="off" @input=${type}></label>`;
  }

  #recorded() {
    const { labels } = this.cues;
    return html`${field("number", "Number", "", "", "next")}${field("label", "Label", "", "wide")}${field("seconds", "Seconds", "1")}
      <fieldset aria-label="Parts; none: all that cues do not leave so">
        <span>All of</span>${Object.entries(labels).map(([name, label]) => check(`part ${name}`, label || name))}${SCENE_PARTS.map(
          (part) => check(`part */${part}`, part),
        )}<span>or, with none ticked, what differs</span>
      </fieldset>`;
  }

  readonly #submit = (event: SubmitEvent): void => {
    event.preventDefault();
    const data = new FormData(event.target as HTMLFormElement);
    const text = (name: string): string => String(data.get(name) ?? "").trim();
    this.error = "";
    try {
      this.#send(text, [...data.keys()]);
    } catch (error) {
      this.error = (error as Error).message;
    }
  };

  async #takeIn(): Promise<void> {
    const file = this.renderRoot.querySelector<HTMLInputElement>('input[type="file"]')?.files?.[0];
    if (file === undefined) return;
    this.error = await this.cues.takeIn(await file.text());
    if (this.error !== "") return;
    this.cues.show.say(`${file.name} is the list ${this.cues.name} now.`, "done");
    this.close();
  }

  #send(text: (name: string) => string, given: readonly string[]): void {
    const { cues } = this;
    const failed = (reason: string): void => {
      this.error = reason;
    };
    const [cue_list, number] = [cues.name, text("number")];
    if (this.kind === "record") {
      const parts = given.filter((name) => name.startsWith("part ")).map((name) => name.slice(5));
      cues.add(
        { type: "record_cue", cue: number, label: text("label"), seconds: secondsIn(text("seconds")), parts, cue_list },
        failed,
        this.#recordedOne,
      );
    } else if (this.kind === "renumber")
      cues.change({ type: "renumber_cues", first: text("first"), step: text("step"), cue_list }, failed);
    else if (this.kind === "go_to")
      cues.play({ type: "go_to_cue", cue: number, whole: given.includes("whole"), cue_list }, failed);
    else if (this.kind === "take_in") void this.#takeIn();
    else if (this.kind === "add_list") cues.addList(text("name"), failed);
    else cues.renameList(text("name"), failed);
  }
}

const FILE = html`<label>A list as text<input type="file" name="file" accept=".toml" required></label>
  <span>It takes the place of all cues of the list; a cue stays the same by its number. Undo brings them back.</span>`;

const field = (name: string, label: string, value: string, look = "", placeholder = "") =>
  html`<label>${label}<input class=${look} name=${name} value=${value} placeholder=${placeholder} autocomplete="off"></label>`;

const check = (name: string, label: string, on = false) =>
  html`<label><input type="checkbox" name=${name} ?checked=${on}>${label}</label>`;
