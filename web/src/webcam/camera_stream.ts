/** The camera: asked for, chosen, lost; why there is none, in words and with what to do. */

/** Under which a browser keeps the camera that was chosen last, for all pages. */
export const CAMERA_KEY = "omote.camera";

/** A camera that can be chosen. */
export interface CameraDevice {
  id: string;
  label: string;
}

/** Why there is no picture: what is wrong, and what to do. */
export interface CameraTrouble {
  title: string;
  advice: string;
}

const TROUBLES: Record<string, CameraTrouble> = {
  NotAllowedError: {
    title: "The browser may not use the camera",
    advice:
      "Allow the camera for this page: the symbol at the left of the address bar, then “Camera”. Where the system itself asks (macOS, Windows: privacy, camera), allow it for the browser too. Then try again.",
  },
  NotFoundError: { title: "There is no camera", advice: "Plug one in: it is found by itself." },
  NotReadableError: {
    title: "Another program has the camera",
    advice: "Close what uses it (a video call, OBS, another tab), or choose another camera. Then try again.",
  },
  OverconstrainedError: {
    title: "This camera is not there any more",
    advice: "Plug it in again, or choose another one.",
  },
};

/** What a failed request for a camera means to a person. */
export function explainTrouble(error: unknown): CameraTrouble {
  const name = error instanceof Error || error instanceof DOMException ? error.name : "";
  const trouble = TROUBLES[name === "AbortError" ? "NotReadableError" : name];
  const said = error instanceof Error ? error.message : String(error);
  return trouble ?? { title: "The camera gives no picture", advice: `The browser says: ${said}. Try again.` };
}

/** The camera was there and has gone. */
export const UNPLUGGED: CameraTrouble = {
  title: "The camera was unplugged",
  advice: "Plug it in again: it goes on by itself. Or choose another one.",
};

/** What a browser gives of cameras; it has none on an insecure page. */
export type Cameras = Pick<MediaDevices, "getUserMedia" | "enumerateDevices" | "addEventListener">;

/** What a page wants of a camera. */
export interface CameraWish {
  readonly width: number;
  readonly height: number;
  /** What to do where the page is not secure, so that it gets no camera. */
  readonly insecure: string;
}

/** What the page is told. */
export interface CameraListener {
  opened(stream: MediaStream, device: string): void;
  devices(cameras: CameraDevice[]): void;
  trouble(trouble: CameraTrouble): void;
}

/** One camera at a time; one that comes back is taken up again, until it has ended. */
export class CameraStream {
  #stream: MediaStream | null = null;
  #wanted = "";
  /** Counts what was asked for: a camera that comes when another is wanted, or none, is let go. */
  #asked = 0;
  readonly #ending = new AbortController();

  constructor(
    private readonly listener: CameraListener,
    private readonly wish: CameraWish,
    private readonly cameras: Cameras | null = navigator.mediaDevices ?? null,
  ) {
    cameras?.addEventListener("devicechange", () => void this.#look(), { signal: this.#ending.signal });
  }

  /** Opens a camera, by its id, or any for "". */
  async open(device: string): Promise<void> {
    this.#wanted = device;
    this.close();
    if (this.cameras === null) {
      this.listener.trouble({ title: INSECURE, advice: this.wish.insecure });
      return;
    }
    const asked = this.#asked;
    try {
      const stream = await this.cameras.getUserMedia({ audio: false, video: constraints(device, this.wish) });
      if (asked === this.#asked) this.#use(stream);
      else stop(stream);
    } catch (error) {
      if (asked === this.#asked) this.listener.trouble(explainTrouble(error));
    }
    if (!this.#ending.signal.aborted) await this.#list();
  }

  /** Lets go of the camera, also of one that is on its way. */
  close(): void {
    this.#asked += 1;
    if (this.#stream !== null) stop(this.#stream);
    this.#stream = null;
  }

  /** Lets go of the camera for good: none that is plugged in is taken up again. */
  end(): void {
    this.#ending.abort();
    this.close();
  }

  #use(stream: MediaStream): void {
    this.#stream = stream;
    const track = stream.getVideoTracks()[0];
    if (track === undefined) return;
    track.onended = () => {
      this.close();
      this.listener.trouble(UNPLUGGED);
    };
    this.listener.opened(stream, track.getSettings().deviceId ?? "");
  }

  async #list(): Promise<CameraDevice[]> {
    const all = (await this.cameras?.enumerateDevices().catch(() => [])) ?? [];
    const cameras = all
      .filter(({ kind, deviceId }) => kind === "videoinput" && deviceId !== "")
      .map(({ deviceId, label }, index) => ({ id: deviceId, label: label || `Camera ${index + 1}` }));
    this.listener.devices(cameras);
    return cameras;
  }

  /** A device came or went: the wanted one is opened again where there is no picture. */
  async #look(): Promise<void> {
    const cameras = await this.#list();
    if (this.#stream === null && cameras.length > 0) {
      await this.open(cameras.some(({ id }) => id === this.#wanted) ? this.#wanted : "");
    }
  }
}

const INSECURE = "This browser gives cameras to secure pages only";

function stop(stream: MediaStream): void {
  for (const track of stream.getTracks()) {
    track.onended = null;
    track.stop();
  }
}

function constraints(device: string, { width, height }: CameraWish): MediaTrackConstraints {
  return {
    ...(device ? { deviceId: { exact: device } } : { facingMode: "user" }),
    width: { ideal: width },
    height: { ideal: height },
    frameRate: { ideal: 30 },
  };
}
