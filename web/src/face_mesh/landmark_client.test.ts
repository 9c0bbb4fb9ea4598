import { expect, it } from "vitest";
import { LandmarkClient, type Messenger } from "./landmark_client";
import type { FromWorker, ToWorker } from "./landmark_messages";

class FakeWorker implements Messenger {
  readonly sent: ToWorker[] = [];
  onmessage: ((event: MessageEvent<FromWorker>) => void) | null = null;
  onerror: ((event: ErrorEvent) => void) | null = null;

  postMessage(message: ToWorker): void {
    this.sent.push(message);
  }

  say(data: FromWorker): void {
    this.onmessage?.({ data } as MessageEvent<FromWorker>);
  }
}

function open() {
  const [worker, events, closed] = [new FakeWorker(), [] as string[], [] as number[]];
  const client = new LandmarkClient(worker, {
    loading: (what, share) => events.push(`loading ${what} ${share}`),
    ready: (backend, cost) => events.push(`ready ${backend} ${cost}`),
    landmarks: ({ time }) => events.push(`landmarks ${time}`),
    failed: (reason) => events.push(`failed ${reason}`),
  });
  const picture = (number: number) => ({ close: () => closed.push(number) }) as unknown as ImageBitmap;
  const message = (time: number): FromWorker => ({
    kind: "landmarks",
    time,
    width: 1,
    height: 1,
    points: new Float32Array(),
    light: 0,
    cost: 0,
  });
  return { worker, events, closed, client, picture, message };
}

it("sends no picture before the model is ready, and then one at a time", () => {
  const { worker, closed, client, picture, message } = open();
  client.start(picture(0));
  client.look(picture(1), 1);
  worker.say({ kind: "loading", what: "the model", share: 1 });
  expect([client.free, closed]).toEqual([false, [1]]);
  worker.say({ kind: "ready", backend: "CPU", cost: 5 });
  client.look(picture(2), 2);
  client.look(picture(3), 3);
  expect([worker.sent.map(({ kind }) => kind), closed]).toEqual([
    ["start", "picture"],
    [1, 3],
  ]);
  worker.say(message(2));
  expect(client.free).toBe(true);
});

it("tells what the worker says, and that its script is missing", () => {
  const { worker, events, message } = open();
  worker.say({ kind: "loading", what: "x", share: 0.5 });
  worker.say({ kind: "ready", backend: "GPU", cost: 5 });
  worker.say(message(9));
  worker.say({ kind: "failed", reason: "no wasm" });
  worker.onerror?.({ message: "" } as ErrorEvent);
  expect(events).toEqual([
    "loading x 0.5",
    "ready GPU 5",
    "landmarks 9",
    "failed no wasm",
    "failed its script could not be loaded",
  ]);
});

it("sends nothing more to a worker that failed", () => {
  const { worker, client, picture } = open();
  worker.say({ kind: "ready", backend: "CPU", cost: 5 });
  client.look(picture(1), 1);
  worker.say({ kind: "failed", reason: "no wasm" });
  expect(client.free).toBe(false);
});
