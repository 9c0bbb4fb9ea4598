/** The worker of the hand's landmarks: pictures in, hands out, one at a time. */

import { serveModel } from "../face_mesh/model_worker";
import type { HandsFound } from "./hand_messages";
import { HandModel } from "./hand_model";

serveModel<HandsFound>("the hand model", async (most, progress) => {
  const model = await HandModel.load(most, progress);
  return {
    use: (backend) => model.use(backend),
    find: async (picture) => (await model.look(picture))[0]?.image ?? new Float32Array(),
    reset: () => model.reset(),
    async look(picture) {
      const hands = await model.look(picture);
      return { found: { hands }, transfer: hands.flatMap(({ image, world }) => [image.buffer, world.buffer]) };
    },
  };
});
