/** The worker of the face's landmarks: pictures in, landmarks out, one at a time. */

import { faceLight } from "./face_light";
import { FaceMesh } from "./face_mesh";
import type { FaceFound } from "./landmark_messages";
import { serveModel } from "./model_worker";

serveModel<FaceFound>("the face model", async (_, progress) => {
  const mesh = await FaceMesh.load(progress);
  return {
    use: (backend) => mesh.use(backend),
    find: (picture) => mesh.find(picture),
    reset: () => mesh.reset(),
    async look(picture) {
      const points = await mesh.find(picture);
      return { found: { points, light: faceLight(picture, points) }, transfer: [points.buffer] };
    },
  };
});
