/** Who performs, how the face is read, and which characters it plays. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { base, entry, palette } from "../ui/theme";
import { CameraElement } from "./camera_element";
import type { CameraStatus } from "./session/camera_messages";
import { drawStep } from "./step_picture";

const READ_BY = {
  no: "Your face is not known yet: look at the camera, relaxed, for two seconds.",
  rest: "Read by a moment at rest. The guided minute reads you better.",
  guided: "Read by your guided minute.",
} as const;

@customElement("omote-performer")
export class PerformerPanel extends CameraElement {
  @state() private renaming = false;

  static override styles = [
    palette,
    base,
    css`
      section {
        display: grid;
        gap: 8px;
        padding: 12px;
      }
      section + section {
        margin-top: 8px;
      }
      .row {
        display: flex;
        flex-wrap: wrap;
        gap: 6px;
        align-items: center;
      }
      input {
        ${entry}
        flex: 1 1 120px;
        min-height: 34px;
      }
      button {
        min-height: 34px;
      }
      .main {
        color: var(--ground);
        background: var(--coming);
        border-color: var(--coming);
        font-weight: 700;
      }
      p {
        margin: 0;
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
    `,
  ];

  override render() {
    const status = this.session.status;
    return html`<section class="panel" aria-label="Performer">${this.#name()}${status ? this.#list(status) : nothing}</section>
      ${status ? html`${this.#characters(status)}${this.#calibration(status)}` : nothing}`;
  }

  #name() {
    const { name, status } = this.session;
    const label = this.renaming ? "New name" : "Performer";
    return html`<h2>${label}</h2>
      <form class="row" @submit=${this.#submit}>
        <input name="performer" aria-label=${label} maxlength="40" autocomplete="off" .value=${name}
          list="performers" @keydown=${(event: KeyboardEvent) => event.key === "Escape" && this.#endRenaming(event)} />
        <datalist id="performers">${(status?.performers ?? []).map((each) => html`<option value=${each}></option>`)}</datalist>
        <button>${this.renaming ? "Rename" : "Perform"}</button>
      </form>`;
  }

  #list(status: CameraStatus) {
    const known = status.performers.includes(status.performer);
    const forget = () => this.session.send({ type: "delete_performer" });
    return html`<div class="row">
      <button ?disabled=${!known} aria-pressed=${this.renaming} @click=${() => this.#startRenaming()}>Rename</button>
      <button ?disabled=${!known} title="Forgets how this face is read" @click=${forget}>Forget this face</button>
      <button ?disabled=${status.undo === ""} title=${status.undo} @click=${() => this.session.send({ type: "undo_performer" })}>
        Undo${status.undo ? `: ${status.undo}` : ""}</button>
    </div>`;
  }

  #characters(status: CameraStatus) {
    const played = status.characters.filter((each) => each.played).map(({ name }) => name);
    const toggle = (name: string): void => {
      const characters = played.includes(name) ? played.filter((each) => each !== name) : [...played, name];
      this.session.send({ type: "play_characters", characters });
    };
    return html`<section class="panel" aria-label="Characters"><h2>Plays</h2>
      <div class="row">${status.characters.map(
        ({ name, label, played: on }) =>
          html`<button aria-pressed=${on} @click=${() => toggle(name)}>${label}</button>`,
      )}</div>
      ${played.length ? nothing : html`<p>Nobody yet: choose a character, and it follows your face.</p>`}</section>`;
  }

  #calibration(status: CameraStatus) {
    const busy = status.guide !== null && status.guide.of > 1;
    const begin = (rest: boolean) => this.session.send({ type: "begin_guide", rest });
    return html`<section class="panel" aria-label="Calibration"><h2>How your face is read</h2>
      <p role="status">${status.fitting ? "Reading what you showed …" : READ_BY[status.calibrated]}</p>
      <div class="row">
        <button class=${status.calibrated === "guided" ? "" : "main"} ?disabled=${busy} @click=${() => begin(false)}>
          ${status.calibrated === "guided" ? "Guided minute again" : "Guided minute"}</button>
        <button ?disabled=${status.guide !== null} @click=${() => begin(true)}>At rest now</button>
      </div>
      ${status.redoable.length ? this.#steps(status, busy) : nothing}</section>`;
  }

  #steps({ redoable }: CameraStatus, busy: boolean) {
    return html`<p>One of them again:</p><div class="steps">${redoable.map(
      (
        step,
      ) => html`<button aria-label="Again: ${step}" ?disabled=${busy} @click=${() => this.session.send({ type: "redo_step", step })}>
        <svg viewBox="0 0 120 140" aria-hidden="true">${drawStep(step)}</svg>${step}</button>`,
    )}</div>`;
  }

  readonly #submit = (event: SubmitEvent): void => {
    event.preventDefault();
    const name = String(new FormData(event.target as HTMLFormElement).get("performer") ?? "");
    if (this.renaming) this.session.send({ type: "rename_performer", name });
    else this.session.perform(name);
    this.renaming = false;
  };

  #startRenaming(): void {
    this.renaming = !this.renaming;
    if (this.renaming) this.renderRoot.querySelector("input")?.select();
  }

  #endRenaming(event: KeyboardEvent): void {
    this.renaming = false;
    (event.target as HTMLInputElement).value = this.session.name;
  }
}
