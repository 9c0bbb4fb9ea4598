import { LandmarkClient } from "./landmark_client";
import warmUp from "./warm_up_face.jpg?no-inline";

const worker = new Worker(new URL("./landmark_worker.ts", import.meta.url));
const log: unknown[] = [];
Object.assign(window, { log });
const client = new LandmarkClient(worker as never, {
  loading: (what, share) => log.push(["loading", what, share]),
  ready: (backend, cost) => log.push(["ready", backend, cost]),
  landmarks: (found) =>
    log.push(["landmarks", found.points.length, found.cost, found.light, Array.from(found.points.slice(0, 6))]),
  failed: (reason) => log.push(["failed", reason]),
});
const picture = async () => createImageBitmap(await (await fetch(warmUp)).blob());
client.start(await picture());
Object.assign(window, { look: async () => client.look(await picture(), performance.now()) });
