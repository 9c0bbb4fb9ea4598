/** The worker of the body's points: pictures in, points out, one at a time. */

import { serveModel } from "../face_mesh/model_worker";
import type { BodyFound } from "./body_messages";
import { BodyModel } from "./body_model";

serveModel<BodyFound>("the body model", async (_, progress) => {
  const model = await BodyModel.load(progress);
  return {
    use: (backend) => model.use(backend),
    find: (picture) => model.find(picture),
    reset: () => model.reset(),
    async look(picture) {
      const body = await model.find(picture);
      return { found: { body }, transfer: [body.buffer] };
    },
  };
});
