import { expect, it } from "vitest";
import { CameraStream, type Cameras, explainTrouble, UNPLUGGED } from "./camera_stream";

interface Track {
  onended: (() => void) | null;
  stopped: boolean;
}

/** Cameras that the test plugs in and pulls out. */
class FakeCameras {
  plugged: string[] = ["front"];
  error: string | null = null;
  asked: unknown[] = [];
  tracks: Track[] = [];
  changed: () => void = () => undefined;

  addEventListener(_: string, changed: () => void): void {
    this.changed = changed;
  }

  getUserMedia(asked: unknown): Promise<MediaStream> {
    this.asked.push(asked);
    if (this.error) return Promise.reject(Object.assign(new Error("said"), { name: this.error }));
    const track = {
      onended: null,
      stopped: false,
      getSettings: () => ({ deviceId: this.plugged[0] }),
      stop: () => undefined,
    };
    this.tracks.push(track);
    return Promise.resolve({ getTracks: () => [track], getVideoTracks: () => [track] } as unknown as MediaStream);
  }

  enumerateDevices(): Promise<MediaDeviceInfo[]> {
    const devices = this.plugged.map((deviceId) => ({ kind: "videoinput", deviceId, label: deviceId }));
    return Promise.resolve(devices as unknown as MediaDeviceInfo[]);
  }
}

function open(cameras: FakeCameras | undefined) {
  const told: string[] = [];
  const listener = {
    opened: (_: MediaStream, device: string) => told.push(`opened ${device}`),
    devices: (found: { label: string }[]) => told.push(`devices ${found.map(({ label }) => label).join()}`),
    trouble: ({ title }: { title: string }) => told.push(title),
  };
  return { told, stream: new CameraStream(listener, (cameras ?? null) as unknown as Cameras | null) };
}

const settled = () => new Promise((done) => setTimeout(done));

it("opens the camera that is wanted, and lists all", async () => {
  const cameras = new FakeCameras();
  const { told, stream } = open(cameras);
  await stream.open("front");
  expect(told).toEqual(["opened front", "devices front"]);
  expect(cameras.asked).toMatchObject([{ audio: false, video: { deviceId: { exact: "front" } } }]);
});

it("says why there is none", async () => {
  for (const [error, title] of [
    ["NotAllowedError", "The browser may not use the camera"],
    ["NotFoundError", "There is no camera"],
    ["NotReadableError", "Another program has the camera"],
    ["AbortError", "Another program has the camera"],
    ["OverconstrainedError", "This camera is not there any more"],
    ["WeirdError", "The camera gives no picture"],
  ] as const) {
    const cameras = new FakeCameras();
    cameras.error = error;
    const { told, stream } = open(cameras);
    await stream.open("");
    expect(told[0]).toBe(title);
  }
  expect(explainTrouble("odd").advice).toContain("odd");
});

it("says what to do where the page is not secure", async () => {
  const { told, stream } = open(undefined);
  await stream.open("");
  expect(told[0]).toContain("secure pages only");
});

it("says that a camera was unplugged, and goes on when it comes back", async () => {
  const cameras = new FakeCameras();
  const { told, stream } = open(cameras);
  await stream.open("front");
  told.length = 0;
  cameras.plugged = [];
  cameras.tracks[0]?.onended?.();
  cameras.changed();
  await settled();
  expect(told).toEqual([UNPLUGGED.title, "devices "]);
  cameras.plugged = ["front"];
  cameras.changed();
  await settled();
  expect(told.at(-2)).toBe("opened front");
});
