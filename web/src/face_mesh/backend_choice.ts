/** Chooses where the model computes, by a short race before the first picture of the camera. */

import type { Backend } from "./solution";

/** What is chosen for: a model. */
export interface Raced {
  use(backend: Backend): void;
  find(picture: ImageBitmap): Promise<Float32Array>;
}

/** Looks at each place, of which the first loads what it needs and does not count. */
const LOOKS = 3;
/** A graphics processor that draws at all is faster than this: others are not tried for longer. */
const HOPELESS_MS = 4000;

/** The faster of the two places and what a look takes there, ms; clock: ms. */
export async function chooseBackend(
  mesh: Raced,
  picture: ImageBitmap,
  clock: () => number,
  gpu: () => boolean = hasGpu,
): Promise<{ backend: Backend; cost: number }> {
  const cpu = await cost(mesh, "CPU", picture, clock);
  const graphics = gpu() ? await cost(mesh, "GPU", picture, clock) : Number.POSITIVE_INFINITY;
  if (graphics < cpu) return { backend: "GPU", cost: graphics };
  if (Number.isFinite(graphics)) {
    mesh.use("CPU");
    await mesh.find(picture);
  }
  return { backend: "CPU", cost: cpu };
}

/** What a look takes, ms, the least of some; infinite where it cannot be done or finds nothing. */
async function cost(mesh: Raced, backend: Backend, picture: ImageBitmap, clock: () => number): Promise<number> {
  let least = Number.POSITIVE_INFINITY;
  try {
    mesh.use(backend);
    for (let look = 0; look < LOOKS; look++) {
      const began = clock();
      const seesFace = (await mesh.find(picture)).length > 0;
      const took = clock() - began;
      if (look > 0 && seesFace) least = Math.min(least, took);
      if (look > 0 && took > HOPELESS_MS) break;
    }
  } catch (error) {
    if (backend === "CPU") throw error;
    return Number.POSITIVE_INFINITY;
  }
  return least;
}

/** Whether a graphics processor draws, not the processor in its place. */
function hasGpu(): boolean {
  const context = new OffscreenCanvas(1, 1).getContext("webgl2");
  if (context === null) return false;
  const named = context.getExtension("WEBGL_debug_renderer_info");
  const renderer = String(context.getParameter(named ? named.UNMASKED_RENDERER_WEBGL : context.RENDERER));
  context.getExtension("WEBGL_lose_context")?.loseContext();
  return !/swiftshader|llvmpipe|software|basic render/i.test(renderer);
}
