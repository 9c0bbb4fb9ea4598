/** The hand at the camera page: its model, its guided minute and calibration, and what it plays at the show. */

import { Rate } from "../../face_mesh/face_health";
import { LandmarkClient, type ModelState } from "../../face_mesh/landmark_client";
import { adviseOnCalibration, type HandCalibration, readCalibration } from "../../hands/hand_calibration";
import { playHand } from "../../hands/hand_channels";
import type { HandWorker } from "../../hands/hand_client";
import type { Hands, HandsFound } from "../../hands/hand_messages";
import { HandMinute } from "../../hands/hand_minute";
import { type HandReading, HandTracker } from "../../hands/hand_tracker";
import type { FromCamera } from "./camera_messages";

/** What the session is given: workers, what keeps settings, the link, whom it tells. */
export interface HandHost {
  openWorker(): HandWorker;
  picture(): Promise<ImageBitmap>;
  readonly storage: Storage;
  send(message: FromCamera): boolean;
  changed(): void;
  drawn(hands: Hands, playing: number): void;
}

/** The performer's hand before the camera. */
export class HandSession {
  /** How far the model is; null where no hand is looked for. */
  model: ModelState | null = null;
  reading: HandReading | null = null;
  /** Pictures a second that are looked at. */
  rate = 0;
  minute: HandMinute | null = null;
  calibration: HandCalibration | null = null;
  /** Why the minute gave no calibration; "" for nothing. */
  failed = "";
  #name = "";
  #camera = "";
  #tracker = new HandTracker(null);
  #worker: HandWorker | null = null;
  #client: LandmarkClient<HandsFound> | null = null;
  #rates = new Rate();
  #told = 0;

  constructor(private readonly host: HandHost) {}

  /** How many hands are looked for: 2 where the second is a point. */
  get count(): 1 | 2 {
    return this.host.storage.getItem(COUNT_KEY) === "2" ? 2 : 1;
  }

  /** The pad whose point the other hand moves; "" for none. */
  get pad(): string {
    return this.host.storage.getItem(PAD_KEY) ?? "";
  }

  /** Has the other hand move a pad, by its name, or none for "". */
  choosePad(pad: string): void {
    this.host.storage.setItem(PAD_KEY, pad);
    this.host.changed();
  }

  /** Whether a picture would be looked at now. */
  get free(): boolean {
    return this.#client?.free ?? false;
  }

  /** What is to be said of the calibration; "" for nothing. now: ms since 1970. */
  advice(now: number): string {
    return this.calibration === null ? "" : adviseOnCalibration(this.calibration, this.#camera, now);
  }

  /** Looks for a hand from now on, or no more. */
  use(on: boolean): void {
    if (on === (this.model !== null)) return;
    if (on) void this.#start();
    else this.#stop();
  }

  /** Looks for so many hands; the model is loaded again. */
  chooseCount(count: 1 | 2): void {
    this.host.storage.setItem(COUNT_KEY, String(count));
    if (this.model === null) return;
    this.#stop();
    void this.#start();
  }

  /** The performer is this one from now on: their calibration is read. */
  perform(name: string): void {
    if (name === this.#name) return;
    this.#name = name;
    this.#take(readCalibration(this.host.storage.getItem(CALIBRATION_KEY + name)));
  }

  /** A performer has another name: the calibration goes with it. */
  rename(before: string, name: string): void {
    if (before !== this.#name || name === before) return;
    const kept = this.host.storage.getItem(CALIBRATION_KEY + before);
    if (kept !== null) this.host.storage.setItem(CALIBRATION_KEY + name, kept);
    this.host.storage.removeItem(CALIBRATION_KEY + before);
    this.#name = name;
  }

  /** Another camera is open, by its label. */
  see(camera: string): void {
    this.#camera = camera;
  }

  /** Has a picture looked at. time: when it was taken, ms of the page's clock. */
  look(picture: ImageBitmap, time: number): void {
    this.#client?.look(picture, time);
  }

  /** Begins the guided minute. now: seconds of the page's clock. */
  beginMinute(now: number): void {
    this.failed = "";
    this.minute = new HandMinute(now);
    this.host.changed();
  }

  /** Ends the guided minute; the calibration before it stays. */
  cancelMinute(): void {
    this.minute = null;
    this.host.changed();
  }

  /** Forgets how the hand is read. */
  forget(): void {
    this.host.storage.removeItem(CALIBRATION_KEY + this.#name);
    this.#take(null);
  }

  async #start(): Promise<void> {
    const loading: ModelState = { kind: "loading", what: "the hand model", share: 0 };
    this.#set(loading);
    const worker = this.host.openWorker();
    this.#worker = worker;
    this.#client = new LandmarkClient<HandsFound>(worker, {
      loading: (what, share) => this.#set({ kind: "loading", what, share }),
      ready: (backend, cost) => this.#set({ kind: "ready", backend, cost }),
      landmarks: (hands) => this.#receive(hands),
      failed: (reason) => this.#set({ kind: "failed", reason }),
    });
    const picture = await this.host.picture();
    if (this.#worker === worker) this.#client.start(picture, this.count);
  }

  #stop(): void {
    this.#worker?.terminate();
    this.#worker = this.#client = this.minute = this.reading = null;
    this.#set(null);
  }

  #set(model: ModelState | null): void {
    this.model = model;
    this.host.changed();
  }

  #take(calibration: HandCalibration | null): void {
    this.calibration = calibration;
    this.#tracker = new HandTracker(calibration);
    this.host.changed();
  }

  #receive(hands: Hands): void {
    const reading = this.#tracker.read(hands);
    this.reading = reading;
    this.rate = this.#rates.count(hands.time);
    if (this.minute === null) this.#send(reading);
    else this.#calibrate(this.minute, hands, reading.playing);
    this.host.drawn(hands, reading.playing);
    if (hands.time - this.#told > TOLD_MS) {
      this.#told = hands.time;
      this.host.changed();
    }
  }

  #send({ time, axes, other }: HandReading): void {
    if (this.calibration === null) return;
    const played = axes === null ? { weights: {}, head: null } : playHand(axes);
    const moved =
      other === null || this.pad === "" ? {} : { pad: this.pad, point: [other[0], other[1]] as [number, number] };
    this.host.send({ type: "hand_frame", time, found: axes !== null, ...played, ...moved });
  }

  #calibrate(minute: HandMinute, hands: Hands, playing: number): void {
    minute.hear(hands, playing);
    if (!minute.done) return;
    this.minute = null;
    try {
      const calibration = minute.fit(this.#camera, Date.now());
      this.host.storage.setItem(CALIBRATION_KEY + this.#name, JSON.stringify(calibration));
      this.#take(calibration);
    } catch (error) {
      this.failed = error instanceof Error ? error.message : String(error);
      this.host.changed();
    }
  }
}

const COUNT_KEY = "omote.hand.count";
const PAD_KEY = "omote.hand.pad";
const CALIBRATION_KEY = "omote.hand.calibration.";
const TOLD_MS = 250;
