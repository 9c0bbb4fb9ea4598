/** A turn of the head before the webcam: pictures to the landmark worker, the best of them kept, news to the page. */

import { LandmarkClient, warmUpPicture } from "../../../face_mesh/landmark_client";
import type { Landmarks } from "../../../face_mesh/landmark_messages";
import { CAMERA_KEY, type CameraDevice, CameraStream, type CameraTrouble } from "../../../webcam/camera_stream";
import { takePictures } from "../../../webcam/picture_stream";
import { FrameChoice } from "./frame_choice";
import { BLURRED, judgeFrame, MOVING, NOT_SHARP } from "./frame_faults";
import { measureHead } from "./head_measures";
import { greyOfFace, sharpnessOf } from "./sharpness";
import { type DirectionName, directionAt } from "./turn_directions";
import { guideTo, HOLD } from "./turn_words";

/** What the page is told. */
export interface TurnListener {
  /** What is said has changed. */
  changed(): void;
  /** Landmarks were found, or none. */
  drawn(landmarks: Landmarks): void;
  /** A direction has a better picture. */
  kept(name: DirectionName, picture: ImageBitmap, points: Float32Array): void;
  /** All are taken. */
  complete(): void;
}

/** How far the model is: 0..1 while it loads. */
export type TurnModel =
  | { readonly kind: "loading"; readonly share: number }
  | { readonly kind: "ready" }
  | { readonly kind: "failed"; readonly reason: string };

/** From its start to its end it has the camera, and a worker with the model. */
export class TurnSession {
  trouble: CameraTrouble | null = null;
  devices: readonly CameraDevice[] = [];
  device = "";
  model: TurnModel = { kind: "loading", share: 0 };
  /** What to do now; empty: no picture has been looked at yet. */
  sentence = "";
  /** Whether the sentence says what is wrong. */
  faulty = false;
  /** The direction in which the head is turned now. */
  here: DirectionName | null = null;
  readonly video = document.createElement("video");
  readonly choice = new FrameChoice<ImageBitmap>((picture) => picture.close());
  readonly #client: LandmarkClient;
  readonly #stream: CameraStream;
  #endPictures: () => void = () => undefined;
  #grabbing = false;
  /** The picture, as the camera gave it, whose landmarks are being looked for. */
  #looked: ImageBitmap | null = null;
  #before: Landmarks | null = null;
  #said = Number.NEGATIVE_INFINITY;
  #ended = false;

  constructor(
    private readonly worker: Worker,
    private readonly listener: TurnListener,
  ) {
    this.#client = new LandmarkClient(worker, {
      loading: (_, share) => this.#set({ model: { kind: "loading", share } }),
      ready: () => this.#set({ model: { kind: "ready" } }),
      landmarks: (landmarks) => this.#receive(landmarks),
      failed: (reason) => this.#set({ model: { kind: "failed", reason } }),
    });
    this.#stream = new CameraStream(
      {
        opened: (stream, device) => this.#opened(stream, device),
        devices: (devices) => this.#set({ devices }),
        trouble: (trouble) => this.#lose(trouble),
      },
      WISH,
    );
  }

  /** Loads the model and asks for the camera. */
  async start(): Promise<void> {
    const opening = this.#stream.open(localStorage.getItem(CAMERA_KEY) ?? "");
    const face = await warmUpPicture();
    if (!this.#ended) this.#client.start(face);
    await opening;
  }

  /** Opens a camera, or the same again. */
  async open(device: string): Promise<void> {
    if (device !== "") localStorage.setItem(CAMERA_KEY, device);
    this.#set({ trouble: null });
    await this.#stream.open(device);
  }

  /** The pictures that are kept, as the camera gave them. */
  async files(): Promise<File[]> {
    return await Promise.all(this.choice.all.map(([name, picture]) => fileOf(name, picture)));
  }

  /** Lets go of the camera, the model and all pictures. */
  end(): void {
    this.#ended = true;
    this.#stream.end();
    this.#endPictures();
    this.video.srcObject = null;
    this.worker.terminate();
    this.#forget();
    this.choice.clear();
  }

  #opened(stream: MediaStream, device: string): void {
    this.#endPictures();
    this.video.srcObject = stream;
    this.#set({ trouble: null, device });
    void this.video.play().catch(() => undefined); // another camera was chosen before it began
    this.#endPictures = takePictures(stream, this.video, (grab, time) => this.#look(grab, time));
  }

  #lose(trouble: CameraTrouble): void {
    this.#endPictures();
    this.video.srcObject = null;
    this.#set({ trouble, sentence: "", here: null });
  }

  /** Has a picture looked at where the worker is free; it is kept as it is until that is done. */
  async #look(grab: () => Promise<ImageBitmap | null>, time: number): Promise<void> {
    if (!this.#client.free || this.#grabbing || this.#looked !== null) return;
    this.#grabbing = true;
    const picture = await grab();
    const small = picture === null ? null : await smaller(picture);
    this.#grabbing = false;
    if (small === null || this.#ended) {
      picture?.close();
      small?.close();
      return;
    }
    this.#looked = picture;
    this.#client.look(small, time);
  }

  #receive(landmarks: Landmarks): void {
    const [picture, before] = [this.#looked, this.#before];
    [this.#looked, this.#before] = [null, landmarks];
    this.listener.drawn(landmarks);
    if (picture === null) return;
    const judged = judgeFrame(landmarks, before);
    if (judged.fault === null) this.#offer(picture, landmarks, judged);
    else {
      picture.close();
      this.#say(landmarks, judged.fault);
    }
  }

  /** A picture without a fault, but for its sharpness. */
  #offer(
    picture: ImageBitmap,
    landmarks: Landmarks,
    { head: { yaw }, speed }: { head: { yaw: number }; speed: number },
  ) {
    const sharpness = directionAt(yaw) === null ? 1 : sharpnessOf(greyOfFace(picture, landmarks.points));
    if (sharpness < BLURRED) {
      picture.close();
      this.#say(landmarks, NOT_SHARP);
      return;
    }
    const waited = this.choice.wanted.size;
    const name = this.choice.offer(picture, { yaw, sharpness, stillness: 1 - speed / MOVING });
    if (name !== null) this.listener.kept(name, picture, landmarks.points);
    this.#say(landmarks, "");
    if (waited > 0 && this.choice.wanted.size === 0) this.listener.complete();
  }

  /** Says what is wrong, or what to do next; what was said stays long enough to be read. */
  #say(landmarks: Landmarks, fault: string): void {
    const yaw = landmarks.points.length === 0 ? null : measureHead(landmarks).yaw;
    const sentence = fault === "" ? guideTo(this.choice.wanted, yaw ?? 0) : fault;
    const here = yaw === null ? null : (directionAt(yaw)?.name ?? null);
    if (sentence === this.sentence || landmarks.time - this.#said < READ_MS) this.#set({ here });
    else {
      this.#said = landmarks.time;
      this.#set({ here, sentence, faulty: fault !== "" && fault !== HOLD });
    }
  }

  #forget(): void {
    this.#looked?.close();
    [this.#looked, this.#before] = [null, null];
  }

  #set(values: Partial<TurnSession>): void {
    Object.assign(this, values);
    if (!this.#ended) this.listener.changed();
  }
}

/** A copy for the model; null where the picture cannot be read. */
async function smaller(picture: ImageBitmap): Promise<ImageBitmap | null> {
  const share = Math.min(1, LOOKED_SIDE / Math.max(picture.width, picture.height));
  const options = { resizeWidth: Math.round(share * picture.width), resizeHeight: Math.round(share * picture.height) };
  return await createImageBitmap(picture, options).catch(() => null);
}

/** Without loss, as a photograph from the desk. */
async function fileOf(name: DirectionName, picture: ImageBitmap): Promise<File> {
  const canvas = new OffscreenCanvas(picture.width, picture.height);
  canvas.getContext("2d")?.drawImage(picture, 0, 0);
  const type = "image/png";
  const file = name === "front" ? "front.png" : `turned ${name}.png`;
  return new File([await canvas.convertToBlob({ type })], file, { type });
}

/** Milliseconds for which a sentence stands. */
const READ_MS = 500;
/** Pixels of the longer side that the model looks at: it finds nothing more in more. */
const LOOKED_SIDE = 640;
/** As large as webcams give without being slow. */
const WISH = {
  width: 1920,
  height: 1080,
  insecure:
    "This page came over plain http from another machine. Open the editor on the show's own computer, start the show with https (“omote show --https”), or choose photographs instead.",
};
