/** The microphone page: start, level, through whom one speaks, and the sentence that measures a voice. */

import { html, LitElement, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { ALL } from "../link/constants";
import { listenToKeys } from "../ui/key_presses";
import { base, palette, toolPage } from "../ui/theme";
import { hearWhileShown, textOf, whileShown } from "../ui/topic_element";
import { explainMissing } from "./capture_failure";
import { pageStyle } from "./microphone_page_style";
import { MicrophoneSession, SENTENCE_SECONDS } from "./microphone_session";
import { CLEANINGS, LONGEST_NAME } from "./microphone_settings";

const CLEANING_LABELS = {
  echoCancellation: "Take the echo of loudspeakers away",
  noiseSuppression: "Take noise away",
  autoGainControl: "Set the level by itself",
} as const;
/** dB of full scale at the left end of the meter, and above which a sound is clipped. */
const QUIETEST = -70;
const OVER = -3;
const SPEAKS = 0.5;

@customElement("omote-microphone-page")
export class MicrophonePage extends LitElement {
  static override styles = [palette, base, toolPage, pageStyle];
  readonly #session = new MicrophoneSession(() => this.requestUpdate());
  #finish: ReturnType<typeof setTimeout> | undefined;

  constructor() {
    super();
    whileShown(this, () => listenToKeys({ page: (event, typing) => !typing && this.#press(event) }));
    hearWhileShown(this, window, ["keyup"], ({ code }: KeyboardEvent) => code === "Space" && this.#letGo());
    hearWhileShown(this, window, ["blur"], this.#letGo);
  }

  override render() {
    const { online, notice } = this.#session;
    const missing = explainMissing({ isSecureContext, mediaDevices: navigator.mediaDevices }, location.origin);
    return html`<header>
        <h1>MICROPHONE</h1><a href="/console" target="omote-console">Console</a>
        ${online ? nothing : html`<span class="lost" role="alert">LINK LOST – nothing is heard</span>`}
      </header>
      <main>
        ${missing === null && notice === "" ? nothing : html`<p class="notice wide" role="status">${missing ?? notice}</p>`}
        ${this.#hearing(missing !== null)} ${this.#speaker()} ${this.#measuring()} ${this.#device()}
      </main>`;
  }

  #hearing(impossible: boolean) {
    const { isOpen, opening, muted } = this.#session;
    return html`<section class="panel wide">
      <div class="status" data-heard=${this.#session.isHeard} data-viseme=${this.#session.voice?.viseme ?? ""}>${this.#status()}</div>
      ${this.#meter()}
      <div class="row">
        <button class="start ${isOpen ? "on" : ""}" ?disabled=${impossible || opening} @click=${this.#toggle}>
          ${isOpen ? "Stop" : "Start the microphone"}</button>
        ${this.#talk()}
        <button class="mute" aria-pressed=${muted} title="Mute (M)" @click=${() => this.#session.mute()}>Mute</button>
      </div>
      <div class="row" role="radiogroup" aria-label="When it hears">
        ${this.#modeButton("open", "Always open")} ${this.#modeButton("push", "Push to talk (space bar)")}
      </div>
    </section>`;
  }

  #talk() {
    const { settings, held } = this.#session;
    if (settings.mode === "open") return nothing;
    return html`<button class="talk ${held ? "on" : ""}" @pointerdown=${this.#holdByHand} @pointerup=${this.#letGo}
      @pointercancel=${this.#letGo} @contextmenu=${(event: Event) => event.preventDefault()}>Hold to talk</button>`;
  }

  #modeButton(mode: "open" | "push", label: string) {
    return html`<button role="radio" aria-checked=${this.#session.settings.mode === mode}
      @click=${() => this.#session.setMode(mode)}>${label}</button>`;
  }

  #meter() {
    const voice = this.#session.isHeard ? this.#session.voice : null;
    const level = Math.max(0, Math.min(1, ((voice?.level ?? QUIETEST) - QUIETEST) / -QUIETEST));
    const state = (voice?.level ?? QUIETEST) > OVER ? "over" : (voice?.speaks ?? 0) > SPEAKS ? "speaks" : "";
    return html`<div class="meter ${state}" role="meter" aria-label="Level" aria-valuemin="0" aria-valuemax="1"
      aria-valuenow=${level.toFixed(2)}><i style="transform: scaleX(${level.toFixed(3)})"></i></div>`;
  }

  #status(): string {
    const { isOpen, opening, muted, isHeard, voice, online } = this.#session;
    if (opening) return "The browser asks whether it may…";
    if (!isOpen) return "The microphone is off.";
    if (muted) return "Muted: nothing is sent.";
    if (!isHeard) return "Hold the button or the space bar, and speak.";
    if (!online || voice === null) return "Waiting for the show…";
    if (voice.speaks <= SPEAKS) return "Silent.";
    return voice.characters.length === 0 ? "Speaks, through nobody: choose a character." : "Speaks.";
  }

  #speaker() {
    const { voice, settings } = this.#session;
    const chosen = voice?.characters[0] ?? "";
    const all = Object.entries(voice?.there ?? {});
    return html`<section class="panel">
      <h2>Through whom</h2>
      <div class="row">
        <label>Character
          <select data-field="character" ?disabled=${voice === null} @change=${(event: Event) => this.#session.speakThrough(textOf(event))}>
            ${[["", "Nobody"] as const, ...all, [ALL, "All"] as const].map(
              ([name, label]) => html`<option value=${name} ?selected=${name === chosen}>${label}</option>`,
            )}
          </select></label>
        <label>Name of this microphone
          <input type="text" data-field="name" maxlength=${LONGEST_NAME} .value=${settings.name}
            @change=${(event: Event) => void this.#session.change({ name: textOf(event).trim() || "Microphone" })} /></label>
      </div>
      <p class="hint">The mouth moves on the layer lips; a smile survives it. How much, and in which parts of the face, is set
        in the mixer of the character, on the console.</p>
    </section>`;
  }

  #measuring() {
    const { voice, isHeard } = this.#session;
    const measuring = voice?.calibrating === true;
    return html`<section class="panel">
      <h2>Your voice</h2>
      <p class="hint">${voice?.calibrated === true ? "Measured." : "It works as it is; one sentence makes it surer."}
        Read aloud, as you will speak, or say any sentence of yours:</p>
      <blockquote>My father bought a big boat, and five small fish swam by while we sang.</blockquote>
      <div class="row">
        <button data-do="measure" aria-pressed=${measuring} ?disabled=${!isHeard || voice === null} @click=${this.#measure}>
          ${measuring ? "Read now… (done)" : "Measure my voice"}</button>
        ${voice?.calibrated === true ? html`<button @click=${() => this.#session.measure("forget")}>Forget it</button>` : nothing}
      </div>
    </section>`;
  }

  #device() {
    const { devices, settings } = this.#session;
    return html`<section class="panel wide">
      <h2>Device</h2>
      <div class="row">
        <label>Microphone
          <select data-field="device" @change=${(event: Event) => void this.#session.change({ device: textOf(event) })}>
            <option value="" ?selected=${settings.device === ""}>What the system uses</option>
            ${devices.map(({ id, label }) => html`<option value=${id} ?selected=${id === settings.device}>${label}</option>`)}
          </select></label>
      </div>
      <div class="row">
        ${CLEANINGS.map(
          (
            name,
          ) => html`<label class="check"><input type="checkbox" data-field=${name} .checked=${settings.cleaning[name]}
            @change=${(event: Event) => this.#clean(name, (event.target as HTMLInputElement).checked)} />${CLEANING_LABELS[name]}</label>`,
        )}
      </div>
      <p class="hint">All three are off at first: they come late and blur the consonants. Turn them on where the house is loud.</p>
    </section>`;
  }

  #clean(cleaning: (typeof CLEANINGS)[number], on: boolean): void {
    void this.#session.change({ cleaning: { ...this.#session.settings.cleaning, [cleaning]: on } });
  }

  readonly #toggle = (): void => {
    if (this.#session.isOpen) this.#session.stop();
    else void this.#session.start();
  };

  readonly #measure = (): void => {
    clearTimeout(this.#finish);
    if (this.#session.voice?.calibrating === true) this.#session.measure("finish");
    else {
      this.#session.measure("start");
      this.#finish = setTimeout(() => this.#session.measure("finish"), SENTENCE_SECONDS * 1000);
    }
  };

  #press(event: KeyboardEvent): void {
    if (event.key.toLowerCase() === "m" && !event.repeat && !event.ctrlKey && !event.metaKey) this.#session.mute();
    if (event.code !== "Space" || this.#session.settings.mode === "open") return;
    event.preventDefault();
    this.#session.hold(true);
  }

  readonly #holdByHand = (event: PointerEvent): void => {
    (event.currentTarget as Element).setPointerCapture(event.pointerId);
    this.#session.hold(true);
  };

  readonly #letGo = (): void => this.#session.hold(false);
}
