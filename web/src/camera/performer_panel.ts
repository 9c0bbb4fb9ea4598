/** Who performs, how the face is read, and which characters it plays. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { base, entry, flow, palette } from "../ui/theme";
import { textOf } from "../ui/topic_element";
import { CameraElement } from "./camera_element";
import { mainButton } from "./camera_page_style";
import type { CameraStatus } from "./session/camera_messages";
import { drawStep } from "./step_picture";

const READ_BY = {
  no: "Your face is not known yet: look at the camera, relaxed, for two seconds.",
  rest: "Read by a moment at rest. The guided minute reads you better.",
  guided: "Read by your guided minute.",
} as const;

/** How the face is read now, and how far a guided minute is. */
function sayCalibration(status: CameraStatus): string {
  const { fitting, calibrated, unrest, redoable, missing, unused, guide } = status;
  if (fitting) return "Reading what you showed …";
  const progress = `${redoable.length} of ${redoable.length + missing.length} faces made`;
  if (missing.length > 0 && guide !== null && guide.of > 1) return `${progress}.`;
  if (unused) return `${progress}, not used yet. ${READ_BY[calibrated]}`;
  if (unrest !== "") return unrest;
  if (missing.length > 0 && calibrated === "guided") return `Read by your guided minute: ${progress}.`;
  return READ_BY[calibrated];
}

/** Why no character follows the face yet: the only one of a show does by itself, once the face is known. */
function sayNobody({ calibrated, characters }: CameraStatus): string {
  const [only, other] = characters;
  if (calibrated === "no" && only !== undefined && other === undefined)
    return `${only.label} follows your face as soon as that is known.`;
  return "Nobody yet: choose a character, and it follows your face.";
}

const style = css`
  section {
    display: grid;
    gap: 8px;
    padding: 12px;
  }
  section + section {
    margin-top: 8px;
  }
  .row {
    ${flow}
    gap: 6px;
  }
  input {
    ${entry}
    flex: 1 1 120px;
    min-height: 34px;
  }
  button {
    min-height: 34px;
  }
  p {
    line-height: 1.35;
    color: var(--dim);
  }
  .steps {
    display: grid;
    grid-template-columns: repeat(auto-fill, minmax(64px, 1fr));
    gap: 4px;
  }
  .steps button {
    display: grid;
    justify-items: center;
    padding: 4px 0;
    font-size: 11px;
  }
  .steps svg {
    height: 40px;
  }
`;

@customElement("omote-performer")
export class PerformerPanel extends CameraElement {
  /** The name in the field, "" until it is typed. */
  @state() private typed = "";

  static override styles = [palette, base, mainButton, style];

  override render() {
    const status = this.session.status;
    return html`<section class="panel" aria-label="Performer">${this.#name()}${status ? this.#list(status) : nothing}</section>
      ${status && this.session.tracksFace ? html`${this.#characters(status)}${this.#calibration(status)}` : nothing}`;
  }

  #name() {
    const { name, status } = this.session;
    return html`<h2>Performer</h2>
      <form class="row" @submit=${this.#submit}>
        <input name="performer" aria-label="Performer" maxlength="40" autocomplete="off" .value=${name} list="performers"
          @input=${this.#type} @keydown=${(event: KeyboardEvent) => event.key === "Escape" && this.#restore(event)} />
        <datalist id="performers">${(status?.performers ?? []).map((performer) => html`<option value=${performer}></option>`)}</datalist>
        <button>Perform</button>
      </form>`;
  }

  #list(status: CameraStatus) {
    const { performer, performers, undo } = status;
    const [isKnown, another] = [performers.includes(performer), this.typed !== "" && this.typed !== performer];
    const title = isKnown ? "Type the new name above" : "The show does not know this face yet";
    return html`<div class="row">
      <button ?disabled=${!isKnown || !another} title=${title} @click=${() => this.#rename()}>
        Rename ${performer}${another ? ` to ${this.typed}` : ""}</button>
      <button ?disabled=${!isKnown} title="Forgets how this face is read" @click=${() => this.session.send({ type: "delete_performer" })}>Forget this face</button>
      <button ?disabled=${undo === ""} title=${undo} @click=${() => this.session.send({ type: "undo_performer" })}>
        Undo${undo ? `: ${undo}` : ""}</button>
    </div>`;
  }

  #characters(status: CameraStatus) {
    const played = status.characters.filter((character) => character.played).map(({ name }) => name);
    const toggle = (name: string): void => {
      const characters = played.includes(name) ? played.filter((other) => other !== name) : [...played, name];
      this.session.send({ type: "play_characters", characters });
    };
    return html`<section class="panel" aria-label="Characters"><h2>Plays</h2>
      <div class="row">${status.characters.map(
        ({ name, label, played: on }) =>
          html`<button aria-pressed=${on} @click=${() => toggle(name)}>${label}</button>`,
      )}</div>
      <p>Its face, a person's or the dog's, is chosen at the <a href="/console" target="_blank">console</a>.</p>
      ${played.length ? nothing : html`<p>${sayNobody(status)}</p>`}</section>`;
  }

  #calibration(status: CameraStatus) {
    const busy = status.guide !== null && status.guide.of > 1;
    const { noPicture } = this.session;
    const begin = (rest: boolean) => this.session.send({ type: "begin_guide", rest });
    return html`<section class="panel" aria-label="Calibration"><h2>How your face is read</h2>
      <p role="status">${sayCalibration(status)}</p>
      <div class="row">
        <button class=${status.calibrated === "guided" || status.unused ? "" : "main"} ?disabled=${busy || noPicture !== ""} title=${noPicture} @click=${() => begin(false)}>
          ${status.calibrated === "guided" ? "Guided minute again" : "Guided minute"}</button>
        <button ?disabled=${status.guide !== null || noPicture !== ""} title=${noPicture} @click=${() => begin(true)}>At rest now</button>
      </div>
      ${status.redoable.length ? this.#steps(status, busy) : nothing}</section>`;
  }

  #steps({ redoable }: CameraStatus, busy: boolean) {
    return html`<p>One of them again:</p><div class="steps">${redoable.map(
      (step) => html`<button aria-label="Again: ${step}" ?disabled=${busy || this.session.noPicture !== ""}
          title=${this.session.noPicture} @click=${() => this.session.send({ type: "redo_step", step })}>
        <svg viewBox="0 0 120 140" aria-hidden="true">${drawStep(step)}</svg>${step}</button>`,
    )}</div>`;
  }

  readonly #type = (event: InputEvent): void => {
    this.typed = textOf(event).trim();
  };

  readonly #submit = (event: SubmitEvent): void => {
    event.preventDefault();
    this.session.perform(String(new FormData(event.target as HTMLFormElement).get("performer") ?? ""));
    this.typed = "";
  };

  #rename(): void {
    this.session.send({ type: "rename_performer", name: this.typed });
    this.typed = "";
  }

  #restore(event: KeyboardEvent): void {
    this.typed = "";
    (event.target as HTMLInputElement).value = this.session.name;
  }
}
