/** What edits the list as a whole: record, an empty cue, numbers anew; each form stands over the list and closes by Escape. */

import { css, html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { layerWhileShown } from "../../ui/key_presses";
import { base, entry, flow } from "../../ui/theme";
import { CueElement } from "./cue_element";
import { secondsIn } from "./cue_field";
import type { CueTopic } from "./cue_store";
import { SCENE_PARTS } from "./goal_text";

export type CueFormKind = "record" | "renumber" | "add_list" | "rename_list" | "go_to";

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
  input:not([type="checkbox"]) {
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

  static override styles = [base, style];

  protected override readonly topics: readonly CueTopic[] = ["characters", "view"];

  constructor() {
    super();
    layerWhileShown(this, "form", this.close);
  }

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
    if (this.kind === "record") return ["Record what is on air", this.#recorded(), "Record"] as const;
    if (this.kind === "renumber")
      return [
        "Number the list anew",
        html`${field("first", "From", "1")}${field("step", "by", "1")}`,
        "Renumber",
      ] as const;
    if (this.kind === "go_to")
      return [
        "Go to a cue",
        html`${field("number", "Number", this.cues.standby?.number ?? "")}${check("whole", "with all that the cues before it leave standing")}`,
        "Go to",
      ] as const;
    if (this.kind === "add_list") return ["A new list", field("name", "Name", "", "wide"), "Begin it"] as const;
    return ["Rename the list", field("name", "Name", this.cues.name, "wide"), "Rename"] as const;
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
      );
    } else if (this.kind === "renumber")
      cues.change({ type: "renumber_cues", first: text("first"), step: text("step"), cue_list }, failed);
    else if (this.kind === "go_to")
      cues.play({ type: "go_to_cue", cue: number, whole: given.includes("whole"), cue_list }, failed);
    else if (this.kind === "add_list") cues.addList(text("name"), failed);
    else cues.renameList(text("name"), failed);
  }
}

const field = (name: string, label: string, value: string, look = "", placeholder = "") =>
  html`<label>${label}<input class=${look} name=${name} .value=${value} placeholder=${placeholder} autocomplete="off"></label>`;

const check = (name: string, label: string) => html`<label><input type="checkbox" name=${name}>${label}</label>`;
