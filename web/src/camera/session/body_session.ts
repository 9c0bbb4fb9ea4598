/** The body at the camera page: its model, and its points for the show, which reads them. */

import type { BodyWorker } from "../../body/body_client";
import { SEEN } from "../../body/body_drawing";
import { BODY_NUMBERS, type Body, type BodyFound, VISIBLE } from "../../body/body_messages";
import { Rate } from "../../face_mesh/face_health";
import { LandmarkClient, type ModelState } from "../../face_mesh/landmark_client";
import { writeBodyFrame } from "./body_frame";

/** What the session is given: workers, the link, whom it tells. */
export interface BodyHost {
  openWorker(): BodyWorker;
  picture(): Promise<ImageBitmap>;
  sendFrame(frame: ArrayBuffer): void;
  changed(): void;
  drawn(body: Body): void;
}

/** What a picture shows of a body, in words' terms. */
export interface BodySeen {
  shoulders: boolean;
  left: boolean;
  right: boolean;
  hips: boolean;
}

/** The performer's body before the camera. */
export class BodySession {
  /** How far the model is; null where no body is looked for. */
  model: ModelState | null = null;
  /** What the newest picture shows; null before the first. */
  seen: BodySeen | null = null;
  /** Pictures a second that are looked at. */
  rate = 0;
  #worker: BodyWorker | null = null;
  #client: LandmarkClient<BodyFound> | null = null;
  #rates = new Rate();
  #told = 0;

  constructor(private readonly host: BodyHost) {}

  /** Whether a picture would be looked at now. */
  get free(): boolean {
    return this.#client?.free ?? false;
  }

  /** Looks for a body from now on, or no more. */
  use(on: boolean): void {
    if (on === (this.model !== null)) return;
    if (on) void this.#start();
    else this.#stop();
  }

  /** Has a picture looked at. time: when it was taken, ms of the page's clock. */
  look(picture: ImageBitmap, time: number): void {
    this.#client?.look(picture, time);
  }

  async #start(): Promise<void> {
    this.#set({ kind: "loading", what: "the body model", share: 0 });
    const worker = this.host.openWorker();
    this.#worker = worker;
    this.#client = new LandmarkClient<BodyFound>(worker, {
      loading: (what, share) => this.#set({ kind: "loading", what, share }),
      ready: (backend, cost) => this.#set({ kind: "ready", backend, cost }),
      landmarks: (body) => this.#receive(body),
      failed: (reason) => this.#set({ kind: "failed", reason }),
    });
    const picture = await this.host.picture();
    if (this.#worker === worker) this.#client.start(picture);
  }

  /** Ends the worker; the show is told that nobody is seen, so that what was tracked fades to what is called. */
  #stop(): void {
    this.#worker?.terminate();
    this.#worker = this.#client = this.seen = null;
    this.host.sendFrame(
      writeBodyFrame({ time: performance.now(), width: 1, height: 1, cost: 0, body: new Float32Array() }),
    );
    this.#set(null);
  }

  #set(model: ModelState | null): void {
    this.model = model;
    this.host.changed();
  }

  #receive(body: Body): void {
    this.host.sendFrame(writeBodyFrame(body));
    this.seen = whatIsSeen(body);
    this.rate = this.#rates.count(body.time);
    this.host.drawn(body);
    if (body.time - this.#told > TOLD_MS) {
      this.#told = body.time;
      this.host.changed();
    }
  }
}

const TOLD_MS = 250;
const [SHOULDERS, HIPS] = [[11, 12] as const, [23, 24] as const];
/** Elbow and wrist. */
const [LEFT, RIGHT] = [[13, 15] as const, [14, 16] as const];

/** Which parts of a body a picture shows. */
export function whatIsSeen({ body }: BodyFound): BodySeen {
  const visible = (point: number): boolean => (body[BODY_NUMBERS * point + VISIBLE] ?? 0) >= SEEN;
  const shoulders = SHOULDERS.every(visible);
  return {
    shoulders,
    left: shoulders && LEFT.every(visible),
    right: shoulders && RIGHT.every(visible),
    hips: shoulders && HIPS.every(visible),
  };
}

/** What the performer can do where less is seen than plays; "" where both arms and shoulders are. */
export function adviseOnBody(seen: BodySeen | null): string {
  if (seen === null) return "";
  if (!seen.shoulders)
    return "No body is seen: step back until head, shoulders and arms are in the picture, with light from the front.";
  if (seen.left && seen.right) return "";
  const missing = seen.left ? "Your right arm is" : seen.right ? "Your left arm is" : "Your arms are";
  return `${missing} not in the picture, so what is called plays there: step back, or lift elbows and hands into it.`;
}
