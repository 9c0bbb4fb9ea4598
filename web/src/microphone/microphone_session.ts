/** One microphone at one show: capture, link and settings together, as the page shows them. */

import { type Device, listDevices, MicrophoneCapture } from "./microphone_capture";
import type { ToMicrophone, Voice } from "./microphone_messages";
import { keepSettings, type MicrophoneSettings, type Mode, readSettings, withSpeaker } from "./microphone_settings";
import { VoiceLink } from "./voice_link";

const store = (): Storage => localStorage;
/** In which a sentence is read. */
export const SENTENCE_SECONDS = 6;

export class MicrophoneSession {
  settings: MicrophoneSettings = readSettings(store);
  devices: readonly Device[] = [];
  voice: Voice | null = null;
  online = false;
  opening = false;
  muted = false;
  /** In the mode `push`: whether it is held. */
  held = false;
  /** What went wrong, in words, or what was done. */
  notice = "";
  /** The character that was chosen, until the show tells it: a link that is lost takes what was sent with it. */
  #chosen: string | null = null;
  readonly #capture = new MicrophoneCapture({
    heard: (samples) => this.#send(samples),
    ended: (reason) => this.#say(reason),
  });
  readonly #link: VoiceLink;

  constructor(private readonly changed: () => void) {
    this.#link = new VoiceLink({
      greet: () => this.#greet(),
      received: (message) => this.#receive(message),
      connected: (up) => this.#connect(up),
      revoked: () => location.reload(), // the server then asks for another token
    });
    navigator.mediaDevices?.addEventListener("devicechange", () => void this.#look());
    void this.#look();
  }

  get isOpen(): boolean {
    return this.#capture.isOpen;
  }

  /** Whether what is said is sent. */
  get isHeard(): boolean {
    return this.isOpen && !this.muted && (this.settings.mode === "open" || this.held);
  }

  async start(): Promise<void> {
    this.opening = true;
    this.#say("");
    const reason = await this.#capture.open(this.settings);
    this.opening = false;
    await this.#look();
    this.#say(reason ?? "");
  }

  stop(): void {
    this.#capture.close();
    this.changed();
  }

  /** Changes what this browser remembers; an open microphone is opened anew where that is another sound. */
  async change(part: Partial<MicrophoneSettings>): Promise<void> {
    this.settings = { ...this.settings, ...part };
    keepSettings(store, this.settings);
    if ("name" in part || "device" in part) this.#greet();
    this.changed();
    if (("device" in part || "cleaning" in part) && this.isOpen) await this.start();
  }

  setMode(mode: Mode): void {
    this.held = false;
    void this.change({ mode });
  }

  hold(held: boolean): void {
    if (held === this.held) return;
    this.held = held;
    this.changed();
  }

  mute(): void {
    this.muted = !this.muted;
    this.changed();
  }

  /** Chooses the character that speaks by this microphone, "" for none. */
  speakThrough(character: string): void {
    this.#chosen = character;
    this.#choose();
  }

  #choose(): void {
    if (this.#chosen !== null) this.#link.send({ type: "speak", character: this.#chosen });
  }

  /** Begins to measure the speaker, ends it, or forgets the measure. */
  measure(step: "start" | "finish" | "forget"): void {
    if (step === "start") this.#say("");
    this.#link.send({ type: "sentence", step });
  }

  /** Who speaks now has these bands, if this device was measured. */
  #greet(): void {
    const { name, device, speakers } = this.settings;
    const { bands, level } = speakers[device] ?? { bands: [], level: 0 };
    this.#link.send({ type: "begin", name, bands: [...bands], level });
    this.#choose();
  }

  #connect(up: boolean): void {
    this.online = up;
    if (!up) this.voice = null;
    this.changed();
  }

  #receive(message: ToMicrophone): void {
    if (message.type === "voice") {
      this.voice = message;
      if ((message.characters[0] ?? "") === this.#chosen) this.#chosen = null;
    } else if (message.type === "rejected") {
      this.notice = message.reason;
      this.#chosen = null;
    } else this.#keepSpeaker(message.bands, message.level);
    this.changed();
  }

  #keepSpeaker(bands: number[], level: number): void {
    const isMeasured = bands.length > 0;
    this.settings = withSpeaker(this.settings, isMeasured ? { bands, level } : null);
    keepSettings(store, this.settings);
    this.notice = isMeasured
      ? "The voice is measured; this browser remembers it for this microphone."
      : "The measure is forgotten.";
  }

  #send(samples: Int16Array): void {
    if (!this.isHeard) return;
    const bytes = new Uint8Array(samples.buffer, samples.byteOffset, samples.byteLength);
    this.#link.send({ type: "sound", samples: bytes, sent: performance.now() });
  }

  #say(notice: string): void {
    this.notice = notice;
    this.changed();
  }

  async #look(): Promise<void> {
    this.devices = await listDevices();
    this.changed();
  }
}
