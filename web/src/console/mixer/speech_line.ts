/** A line to say by hand, to try lips and sound; gestures, and what is said now. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { live } from "lit/directives/live.js";
import type { MakeGesture, Say, SpeechState } from "../../link/messages";
import { base, ellipsis, entry, flow } from "../../ui/theme";
import { AnimatedElement } from "../controls/console_element";
import { groupStyle } from "./group_style";
import { HOW_TO_GET_A_VOICE, listVoices, speak, usualVoice, type Voice } from "./voices";

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
/** By whose rules letters are read where only lips move. */
const SPELLINGS: Readonly<Record<NonNullable<Say["language"]>, string>> = { en: "English", de: "German" };
/** Before the name of a voice among what can be chosen. */
const VOICE = "voice ";
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
    flex: 1 1 100%; /* a row of its own: a sentence is to be read while it is typed */
    min-width: 0;
    min-height: 28px;
  }
  select {
    ${entry}
    min-height: 28px;
    flex: 1 1 96px;
  }
  @media (pointer: coarse) {
    input,
    select {
      min-height: var(--finger, 34px);
    }
  }
  .hint {
    color: var(--dim);
  }
  .said {
    color: var(--dim);
    ${ellipsis}
    font-variant-numeric: tabular-nums;
  }
`;

@customElement("omote-speech-line")
export class SpeechLine extends AnimatedElement {
  @state() private voices: readonly Voice[] | null = null;
  @state() private manner = "en";
  @state() private speaking = false;

  static override styles = [base, groupStyle, style];

  override render() {
    return html`<form @submit=${this.#say}>
        <input name="text" maxlength=${LONGEST} aria-label="A line to say" placeholder="A line, to try its lips" />
        <select aria-label="Voice" title="Who speaks it; the stage that plays sounds is heard" @change=${this.#choose}>
          <optgroup label="Lips alone">${Object.entries(SPELLINGS).map(([name, label]) => this.#option(name, label))}</optgroup>
          ${this.voices === null || this.voices.length === 0 ? nothing : html`<optgroup label="Voices">${this.voices.map(({ name, label }) => this.#option(VOICE + name, label))}</optgroup>`}
        </select>
        <button type="submit" ?disabled=${this.speaking}>Say</button>
        <button type="button" title="Ends what is said, and what waits" @click=${this.#stop}>Stop</button>
      </form>
      ${this.voices?.length === 0 ? html`<div class="hint">${HOW_TO_GET_A_VOICE}</div>` : nothing}
      <div class="said" role="status"></div>
      <div class="row" role="group" aria-label="Gestures">${GESTURES.map(
        ([name, title]) => html`<button title=${title} @click=${() => this.#gesture(name)}>${name}</button>`,
      )}</div>`;
  }

  override connectedCallback(): void {
    super.connectedCallback();
    void this.#list();
  }

  async #list(): Promise<void> {
    this.voices = await listVoices();
    const usual = usualVoice(this.voices, navigator.languages);
    if (usual !== "") this.manner = VOICE + usual;
  }

  #option(value: string, label: string) {
    return html`<option value=${value} .selected=${live(value === this.manner)}>${label}</option>`;
  }

  readonly #choose = (event: Event): void => {
    this.manner = (event.target as HTMLSelectElement).value;
  };

  readonly #say = (event: SubmitEvent): void => {
    event.preventDefault();
    const text = String(new FormData(event.target as HTMLFormElement).get("text") ?? "").trim();
    if (text === "" || this.speaking) return;
    if (this.manner.startsWith(VOICE)) void this.#speak(text, this.manner.slice(VOICE.length));
    else this.#ask({ text, language: this.manner as NonNullable<Say["language"]> });
  };

  /** Says a text as soon as a voice has spoken it; why not, where it cannot. */
  async #speak(text: string, voice: string): Promise<void> {
    this.speaking = true;
    try {
      this.#ask({ text, ...(await speak(text, voice)) });
    } catch (error) {
      this.store.say((error as Error).message);
    } finally {
      this.speaking = false;
    }
  }

  #ask(said: Omit<Say, "type" | "id" | "character">): void {
    for (const character of this.store.played.names) this.store.ask({ type: "say", character, ...said });
  }

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
