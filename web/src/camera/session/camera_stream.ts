/** The camera: asked for, chosen, lost; why there is none, in words and with what to do. */

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

const INSECURE: CameraTrouble = {
  title: "This browser gives cameras to secure pages only",
  advice:
    "This page came over plain http from another machine. On the machine with the camera run “omote track --to ADDRESS” with the address of the show, or start the show with https: “omote show --https”.",
};
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
  const known = TROUBLES[name === "AbortError" ? "NotReadableError" : name];
  const said = error instanceof Error ? error.message : String(error);
  return known ?? { title: "The camera gives no picture", advice: `The browser says: ${said}. Try again.` };
}

/** The camera was there and has gone. */
export const UNPLUGGED: CameraTrouble = {
  title: "The camera was unplugged",
  advice: "Plug it in again: it goes on by itself. Or choose another one.",
};

/** What a browser gives of cameras; it has none on an insecure page. */
export type Cameras = Pick<MediaDevices, "getUserMedia" | "enumerateDevices" | "addEventListener">;

/** What the page is told. */
export interface CameraListener {
  opened(stream: MediaStream, device: string): void;
  devices(found: CameraDevice[]): void;
  trouble(trouble: CameraTrouble): void;
}

/** One camera at a time; one that comes back is taken up again. */
export class CameraStream {
  #stream: MediaStream | null = null;
  #wanted = "";

  constructor(
    private readonly listener: CameraListener,
    private readonly cameras: Cameras | null = navigator.mediaDevices ?? null,
  ) {
    cameras?.addEventListener("devicechange", () => void this.#look());
  }

  /** Opens a camera, by its id, or any for "". */
  async open(device: string): Promise<void> {
    this.#wanted = device;
    this.close();
    if (this.cameras === null) {
      this.listener.trouble(INSECURE);
      return;
    }
    try {
      this.#use(await this.cameras.getUserMedia({ audio: false, video: constraints(device) }));
    } catch (error) {
      this.listener.trouble(explainTrouble(error));
    }
    await this.#list();
  }

  /** Lets go of the camera. */
  close(): void {
    for (const track of this.#stream?.getTracks() ?? []) {
      track.onended = null;
      track.stop();
    }
    this.#stream = null;
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
    const found = all
      .filter(({ kind, deviceId }) => kind === "videoinput" && deviceId !== "")
      .map(({ deviceId, label }, index) => ({ id: deviceId, label: label || `Camera ${index + 1}` }));
    this.listener.devices(found);
    return found;
  }

  /** A device came or went: the wanted one is opened again where there is no picture. */
  async #look(): Promise<void> {
    const found = await this.#list();
    if (this.#stream === null && found.length > 0) {
      await this.open(found.some(({ id }) => id === this.#wanted) ? this.#wanted : "");
    }
  }
}

/** 640 x 480 at 30 a second is what the model needs: more costs and finds nothing more. */
function constraints(device: string): MediaTrackConstraints {
  return {
    ...(device ? { deviceId: { exact: device } } : { facingMode: "user" }),
    width: { ideal: 640 },
    height: { ideal: 480 },
    frameRate: { ideal: 30 },
  };
}
