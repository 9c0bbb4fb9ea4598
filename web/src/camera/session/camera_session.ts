/** What happens at the camera page: pictures go to the landmark worker, landmarks to the show, news to the page. */

import type { BodyWorker } from "../../body/body_client";
import type { Body } from "../../body/body_messages";
import { type HealthLine, judgeFace, Rate } from "../../face_mesh/face_health";
import { LandmarkClient, type Messenger, type ModelState } from "../../face_mesh/landmark_client";
import type { Landmarks } from "../../face_mesh/landmark_messages";
import type { HandWorker } from "../../hands/hand_client";
import type { Hands } from "../../hands/hand_messages";
import { CAMERA_KEY, type CameraDevice, CameraStream, type CameraTrouble } from "../../webcam/camera_stream";
import { takePictures } from "../../webcam/picture_stream";
import { BodySession } from "./body_session";
import { CameraLink } from "./camera_link";
import type { CameraStatus, FromCamera } from "./camera_messages";
import { HandSession } from "./hand_session";
import { writeLandmarkFrame } from "./landmark_frame";

/** What the camera is looked at for. */
export type Tracked = "face" | "hand" | "both" | "body";

/** What draws over the picture. */
export interface Drawing {
  face(landmarks: Landmarks): void;
  hands(hands: Hands, playing: number): void;
  body(body: Body): void;
}

/** The workers of the models, and the pictures that they warm up with. */
export interface Models {
  face: Messenger;
  facePicture(): Promise<ImageBitmap>;
  openHand(): HandWorker;
  handPicture(): Promise<ImageBitmap>;
  openBody(): BodyWorker;
  bodyPicture(): Promise<ImageBitmap>;
}

/** The state of the page; `changed` is called with each change of what is shown as words. */
export class CameraSession {
  trouble: CameraTrouble | null = null;
  devices: CameraDevice[] = [];
  device = "";
  model: ModelState = { kind: "loading", what: "the face model", share: 0 };
  health: HealthLine[] = [];
  status: CameraStatus | null = null;
  online = false;
  displaced = false;
  /** What the show said no to last, until it is dismissed or something is accepted. */
  notice = "";
  readonly hand: HandSession;
  readonly body: BodySession;
  #faceStarted = false;
  readonly video = document.createElement("video");
  #endPictures: () => void = () => undefined;
  /** Whether this page has stopped a guided minute without a face, of which the show still tells. */
  #stopped = false;
  #noticed = 0;
  readonly #rate = new Rate();
  readonly #client: LandmarkClient;
  readonly #stream: CameraStream;
  readonly #link: CameraLink;

  constructor(
    private readonly models: Models,
    private readonly storage: Storage,
    private readonly changed: () => void,
    private readonly drawing: Drawing,
    reload: () => void,
  ) {
    this.#client = new LandmarkClient(models.face, {
      loading: (what, share) => this.#setModel({ kind: "loading", what, share }),
      ready: (backend, cost) => this.#setModel({ kind: "ready", backend, cost }),
      landmarks: (landmarks) => this.#receive(landmarks),
      failed: (reason) => this.#setModel({ kind: "failed", reason }),
    });
    const listener = {
      opened: (stream: MediaStream, device: string) => this.#opened(stream, device),
      devices: (cameras: CameraDevice[]) => this.#set({ devices: cameras }),
      trouble: (trouble: CameraTrouble) => this.#lose(trouble),
    };
    this.#stream = new CameraStream(listener, WISH);
    this.#link = new CameraLink({
      status: (status) => this.#follow(status),
      refused: (reason) => this.#note(reason),
      displaced: () => this.#set({ displaced: true, online: false, status: null }),
      connected: (online) => this.#set({ online }),
      revoked: reload,
    });
    this.hand = new HandSession({
      openWorker: () => models.openHand(),
      picture: () => models.handPicture(),
      storage,
      send: (message) => this.#link.send(message),
      changed,
      drawn: (hands, playing) => drawing.hands(hands, playing),
    });
    this.body = new BodySession({
      openWorker: () => models.openBody(),
      picture: () => models.bodyPicture(),
      sendFrame: (frame) => this.#link.sendFrame(frame),
      changed,
      drawn: (body) => drawing.body(body),
    });
  }

  /** What the camera is looked at for. */
  get tracked(): Tracked {
    const kept = this.storage.getItem(TRACKED_KEY);
    return kept === "hand" || kept === "both" || kept === "body" ? kept : "face";
  }

  get tracksFace(): boolean {
    return this.tracked === "face" || this.tracked === "both";
  }

  get tracksHand(): boolean {
    return this.tracked === "hand" || this.tracked === "both";
  }

  /** Whether a body is looked for: alone, or beside what else is. */
  get tracksBody(): boolean {
    return this.tracked === "body" || this.storage.getItem(BODY_KEY) === "beside";
  }

  /** Looks at the camera for a face, a hand, both or a body alone from now on. */
  track(tracked: Tracked): void {
    this.storage.setItem(TRACKED_KEY, tracked);
    this.#useModels();
    this.#set({ health: [] });
  }

  /** Looks for a body beside what else is tracked, or no more. */
  trackBody(on: boolean): void {
    this.storage.setItem(BODY_KEY, on ? "beside" : "");
    this.#useModels();
    this.changed();
  }

  #useModels(): void {
    this.hand.use(this.tracksHand);
    this.body.use(this.tracksBody);
    if (!this.tracksFace || this.#faceStarted) return;
    this.#faceStarted = true;
    void this.models.facePicture().then((face) => this.#client.start(face));
  }

  /** The name under which this browser's performer plays. */
  get name(): string {
    return this.storage.getItem(NAME_KEY) ?? "";
  }

  /** Why no picture is read; "" where they are. */
  get noPicture(): string {
    if (this.trouble !== null) return this.trouble.title;
    if (this.tracked === "hand") return this.noHand;
    if (this.tracked === "body") return this.noBody;
    if (this.model.kind === "failed") return "The face model does not run here";
    if (this.model.kind === "loading") return "The face model is loading";
    return this.health.length === 0 ? "No picture has come yet" : "";
  }

  /** Why no hand is read; "" where it is. */
  get noHand(): string {
    if (this.trouble !== null) return this.trouble.title;
    if (this.hand.model?.kind === "failed") return "The hand model does not run here";
    if (this.hand.model?.kind !== "ready") return "The hand model is loading";
    return this.hand.reading === null ? "No picture has come yet" : "";
  }

  /** Why no body is read; "" where it is. */
  get noBody(): string {
    if (this.trouble !== null) return this.trouble.title;
    if (this.body.model?.kind === "failed") return "The body model does not run here";
    if (this.body.model?.kind !== "ready") return "The body model is loading";
    return this.body.seen === null ? "No picture has come yet" : "";
  }

  /** Loads the models, asks for the camera and greets the show; who has no name has `fallbackName` at once. */
  async start(fallbackName: string): Promise<void> {
    if (this.name === "") this.storage.setItem(NAME_KEY, fallbackName);
    this.hand.perform(this.name);
    this.#useModels();
    this.#link.perform(this.name);
    await this.#stream.open(this.storage.getItem(CAMERA_KEY) ?? "");
  }

  /** Performs as somebody else. */
  perform(name: string): void {
    const trimmed = name.trim();
    if (trimmed === "") return;
    this.storage.setItem(NAME_KEY, trimmed);
    this.hand.perform(trimmed);
    this.#set({ displaced: false, notice: "" });
    this.#link.perform(trimmed);
  }

  /** Opens a camera, or the same again. */
  async choose(device: string): Promise<void> {
    if (device) this.storage.setItem(CAMERA_KEY, device);
    this.#set({ trouble: null });
    await this.#stream.open(device);
  }

  /** Sends a wish to the show. */
  send(message: FromCamera): void {
    if (message.type === "rename_performer") this.#link.rename(message.name);
    if (message.type === "begin_guide") this.notice = "";
    this.#stopped = message.type === "cancel_guide" && this.status?.guide?.done.length === 0;
    if (!this.#link.send(message)) this.#note("The show does not hear this page now; try again when it does.");
  }

  dismiss(): void {
    this.#set({ notice: "" });
  }

  #setModel(model: ModelState): void {
    this.#set({ model });
  }

  #opened(stream: MediaStream, device: string): void {
    this.#endPictures();
    this.video.srcObject = stream;
    this.#set({ trouble: null, device });
    this.hand.see(stream.getVideoTracks()[0]?.label ?? "");
    void this.video.play().catch(() => undefined); // another camera was chosen before it began
    this.#endPictures = takePictures(stream, this.video, (grab, time) => this.#look(grab, time));
  }

  #lose(trouble: CameraTrouble): void {
    this.#endPictures();
    this.video.srcObject = null;
    this.#set({ trouble, health: [] });
  }

  /** Has a picture looked at, where the worker is free: the newest counts. */
  async #look(grab: () => Promise<ImageBitmap | null>, time: number): Promise<void> {
    const wanted = [this.tracksFace ? this.#client : null, this.hand, this.body];
    for (const model of wanted) {
      const picture = model?.free ? await grab() : null;
      if (picture !== null) model?.look(picture, time);
    }
  }

  #receive(landmarks: Landmarks): void {
    this.#link.sendFrame(writeLandmarkFrame(landmarks));
    this.drawing.face(landmarks);
    const rate = this.#rate.count(landmarks.time);
    if (landmarks.time - this.#noticed > HEALTH_MS) {
      this.#noticed = landmarks.time;
      this.#set({ health: judgeFace(landmarks, rate) });
    }
  }

  #follow(status: CameraStatus): void {
    if (status.performer !== this.name) this.storage.setItem(NAME_KEY, status.performer);
    if (this.status !== null) this.hand.rename(this.status.performer, status.performer);
    this.#link.rename(status.performer);
    const ended = this.#stopped && (status.guide?.of ?? 0) < 2;
    if (ended) this.#stopped = false;
    this.#set({ status, displaced: false, ...(ended && !status.unused ? { notice: STOPPED } : {}) });
  }

  #note(notice: string): void {
    this.#set({ notice });
  }

  #set(values: Partial<CameraSession>): void {
    Object.assign(this, values);
    this.changed();
  }
}

/** More pixels than these cost more and find nothing more. */
const WISH = {
  width: 640,
  height: 480,
  insecure:
    "This page came over plain http from another machine. On the machine with the camera run “omote track --to ADDRESS” with the address of the show, or start the show with https: “omote show --https”.",
};
const STOPPED = "The guided minute is stopped: no face was made, so nothing is kept and nothing has changed.";
const TRACKED_KEY = "omote.camera.tracked";
const BODY_KEY = "omote.camera.body";
const NAME_KEY = "omote.performer";
const HEALTH_MS = 400;
