import { expect, it } from "vitest";
import { PhotographFinder, type PhotographMessenger } from "./photograph_finder";
import type { FromPhotographWorker } from "./photograph_worker";

class FakeWorker implements PhotographMessenger {
  readonly sent: ImageBitmap[] = [];
  ended = false;
  onmessage: ((event: MessageEvent<FromPhotographWorker>) => void) | null = null;
  onerror: ((event: ErrorEvent) => void) | null = null;

  postMessage(picture: ImageBitmap): void {
    this.sent.push(picture);
  }

  terminate(): void {
    this.ended = true;
  }

  say(data: FromPhotographWorker): void {
    this.onmessage?.({ data } as MessageEvent<FromPhotographWorker>);
  }
}

function open() {
  const [workers, shares] = [[] as FakeWorker[], [] as number[]];
  const finder = new PhotographFinder(
    (share) => shares.push(share),
    () => {
      workers.push(new FakeWorker());
      return workers.at(-1) as FakeWorker;
    },
  );
  return { workers, shares, finder, picture: {} as ImageBitmap };
}

it("makes its worker for the first picture, tells how it loads, and keeps it for the next", async () => {
  const { workers, shares, finder, picture } = open();
  expect(workers).toHaveLength(0);
  const first = finder.find(picture);
  workers[0]?.say({ kind: "loading", share: 0.5 });
  workers[0]?.say({ kind: "found", points: new Float32Array(3) });
  expect(await first).toHaveLength(3);
  const second = finder.find(picture);
  workers[0]?.say({ kind: "found", points: new Float32Array() });
  expect(await second).toHaveLength(0);
  expect([workers.length, workers[0]?.sent.length, shares]).toEqual([1, 2, [0.5]]);
  finder.close();
  expect(workers[0]?.ended).toBe(true);
});

it("says why where the model does not run", async () => {
  const { workers, finder, picture } = open();
  const first = finder.find(picture);
  workers[0]?.say({ kind: "failed", reason: "no memory" });
  await expect(first).rejects.toThrow("The face model does not run here: no memory.");
  const second = finder.find(picture);
  workers[0]?.onerror?.({ message: "" } as ErrorEvent);
  await expect(second).rejects.toThrow("its script could not be loaded");
});
