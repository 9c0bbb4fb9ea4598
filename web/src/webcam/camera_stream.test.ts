import { expect, it } from "vitest";
import { CameraStream, type Cameras, explainTrouble, UNPLUGGED } from "./camera_stream";

const WISH = { width: 1280, height: 720, insecure: "Use https." };

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
  /** What a camera waits for before it comes. */
  allowed: Promise<void> = Promise.resolve();

  addEventListener(_: string, changed: () => void, { signal }: { signal: AbortSignal }): void {
    this.changed = () => {
      if (!signal.aborted) changed();
    };
  }

  async getUserMedia(asked: unknown): Promise<MediaStream> {
    this.asked.push(asked);
    await this.allowed;
    if (this.error) throw Object.assign(new Error("said"), { name: this.error });
    const track = {
      onended: null,
      stopped: false,
      getSettings: () => ({ deviceId: this.plugged[0] }),
      stop: () => {
        track.stopped = true;
      },
    };
    this.tracks.push(track);
    return { getTracks: () => [track], getVideoTracks: () => [track] } as unknown as MediaStream;
  }

  enumerateDevices(): Promise<MediaDeviceInfo[]> {
    const devices = this.plugged.map((deviceId) => ({ kind: "videoinput", deviceId, label: deviceId }));
    return Promise.resolve(devices as unknown as MediaDeviceInfo[]);
  }
}

function open(cameras: FakeCameras | undefined) {
  const events: string[] = [];
  const listener = {
    opened: (_: MediaStream, device: string) => events.push(`opened ${device}`),
    devices: (listedCameras: { label: string }[]) =>
      events.push(`devices ${listedCameras.map(({ label }) => label).join()}`),
    trouble: ({ title }: { title: string }) => events.push(title),
  };
  return { events, stream: new CameraStream(listener, WISH, (cameras ?? null) as unknown as Cameras | null) };
}

const settled = () => new Promise((done) => setTimeout(done));

it("opens the camera that is wanted, and lists all", async () => {
  const cameras = new FakeCameras();
  const { events, stream } = open(cameras);
  await stream.open("front");
  expect(events).toEqual(["opened front", "devices front"]);
  expect(cameras.asked).toMatchObject([
    { audio: false, video: { deviceId: { exact: "front" }, width: { ideal: 1280 }, height: { ideal: 720 } } },
  ]);
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
    const { events, stream } = open(cameras);
    await stream.open("");
    expect(events[0]).toBe(title);
  }
  expect(explainTrouble("odd").advice).toContain("odd");
});

it("says what to do where the page is not secure", async () => {
  const { events, stream } = open(undefined);
  await stream.open("");
  expect(events[0]).toContain("secure pages only");
});

it("lets go of a camera that comes too late", async () => {
  const cameras = new FakeCameras();
  let allow = (): void => undefined;
  cameras.allowed = new Promise((allowed) => {
    allow = allowed;
  });
  const { events, stream } = open(cameras);
  const first = stream.open("");
  const second = stream.open("front");
  allow();
  await Promise.all([first, second]);
  expect(cameras.tracks.map(({ stopped }) => stopped)).toEqual([true, false]);
  expect(events.filter((what) => what.startsWith("opened"))).toHaveLength(1);
});

it("has no camera once it has ended, not even one that is on its way or is plugged in then", async () => {
  const cameras = new FakeCameras();
  const { events, stream } = open(cameras);
  await stream.open("front");
  const another = stream.open("back");
  stream.end();
  await another;
  cameras.changed();
  await settled();
  expect(cameras.tracks.map(({ stopped }) => stopped)).toEqual([true, true]);
  expect(events).toEqual(["opened front", "devices front"]);
});

it("says that a camera was unplugged, and goes on when it comes back", async () => {
  const cameras = new FakeCameras();
  const { events, stream } = open(cameras);
  await stream.open("front");
  events.length = 0;
  cameras.plugged = [];
  cameras.tracks[0]?.onended?.();
  cameras.changed();
  await settled();
  expect(events).toEqual([UNPLUGGED.title, "devices "]);
  cameras.plugged = ["front"];
  cameras.changed();
  await settled();
  expect(events.at(-2)).toBe("opened front");
});
