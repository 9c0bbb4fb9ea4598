/** A line to say by hand, to try lips and sound; gestures, and what is said now. */

import { css, html } from "lit";
import { customElement, state } from "lit/decorators.js";
import type { MakeGesture, Say, SpeechState } from "../../link/messages";
import { base, ellipsis, entry, flow } from "../../ui/theme";
import { AnimatedElement } from "../controls/console_element";
import { groupStyle } from "./group_style";

/** The gestures of the engine, with what they are. */
const GESTURES: readonly (readonly [MakeGesture["name"], string])[] = [
  ["nod", "Nods"],
  ["shake", "Shakes its head"],
  ["tilt", "Tilts its head"],
  ["bow", "Bows"],
  ["shrug", "Shrugs with brows and mouth"],
  ["brows", "Flashes its brows"],
  ["wink", "Winks"],
];
/** The longest line that a message takes. */
const LONGEST = 2000;

const style = css`
  form,
  .row {
    ${flow}
    gap: 4px;
  }
  input {
    ${entry}
    flex: 1 1 120px;
    min-width: 0;
    min-height: 28px;
  }
  .said {
    color: var(--dim);
    ${ellipsis}
    font-variant-numeric: tabular-nums;
  }
`;

@customElement("omote-speech-line")
export class SpeechLine extends AnimatedElement {
  @state() private language: NonNullable<Say["language"]> = "en";

  static override styles = [base, groupStyle, style];

  override render() {
    return html`<form @submit=${this.#say}>
        <input name="text" maxlength=${LONGEST} aria-label="A line to say" placeholder="A line, to try its lips" />
        <button type="button" title="The language whose letters are read" @click=${this.#turn}>${this.language}</button>
        <button type="submit">Say</button>
        <button type="button" title="Ends what is said, and what waits" @click=${this.#stop}>Stop</button>
      </form>
      <div class="said" role="status"></div>
      <div class="row" role="group" aria-label="Gestures">${GESTURES.map(
        ([name, title]) => html`<button title=${title} @click=${() => this.#gesture(name)}>${name}</button>`,
      )}</div>`;
  }

  readonly #say = (event: SubmitEvent): void => {
    event.preventDefault();
    const text = String(new FormData(event.target as HTMLFormElement).get("text") ?? "").trim();
    if (text === "") return;
    for (const character of this.store.played.names)
      this.store.ask({ type: "say", character, text, language: this.language });
  };

  readonly #turn = (): void => {
    this.language = this.language === "en" ? "de" : "en";
  };

  readonly #stop = (): void => {
    for (const character of this.store.played.names) this.store.ask({ type: "stop_speaking", character });
  };

  #gesture(name: MakeGesture["name"]): void {
    for (const character of this.store.played.names) this.store.ask({ type: "make_gesture", character, name });
  }

  paint(): void {
    if (this.store.air === null || this.offsetParent === null) return;
    const said = this.renderRoot.querySelector(".said") as HTMLElement | null;
    if (said !== null) this.write.text(said, speechWords(this.store.air.speech));
  }
}

/** What is said now, in words. */
function speechWords(speech: SpeechState | null): string {
  if (speech === null) return "Says nothing";
  const waiting = speech.waiting === 0 ? "" : `, ${speech.waiting} waiting`;
  const time = `${Math.max(speech.elapsed, 0).toFixed(1)} of ${speech.seconds.toFixed(1)} s`;
  return `${speech.text === "" ? "Speaks" : speech.text}: ${time}${speech.sound === "" ? "" : ", with sound"}${waiting}`;
}
