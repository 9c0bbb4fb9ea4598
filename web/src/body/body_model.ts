/** MediaPipe's pose in a worker. */

import { POSE } from "virtual:pose";
import { type Backend, loadSolution, type MeshPoint, type Solution } from "../face_mesh/solution";
import { BODY_NUMBERS, BODY_POINTS } from "./body_messages";

interface Options {
  modelComplexity?: 0 | 1 | 2;
  smoothLandmarks?: boolean;
  enableSegmentation?: boolean;
  minDetectionConfidence?: number;
  minTrackingConfidence?: number;
}

/** A point of a body, and how visible it is, 0..1. */
interface BodyPoint extends MeshPoint {
  visibility?: number;
}

interface Results {
  poseLandmarks?: BodyPoint[];
  poseWorldLandmarks?: BodyPoint[];
}

const FILES = {
  folder: POSE,
  name: "pose",
  className: "Pose",
  more: ["pose_landmark_lite.tflite"],
  advice:
    "an installed Omote gets it once: “npm pack @mediapipe/pose@0.5.1675469404”, then “omote body-model mediapipe-pose-0.5.1675469404.tgz” at the machine of the show",
};
const OPTIONS: Options = {
  modelComplexity: 0,
  smoothLandmarks: true,
  enableSegmentation: false,
  minDetectionConfidence: 0.5,
  minTrackingConfidence: 0.5,
};

/** The model, one picture at a time. */
export class BodyModel {
  #results: Results = {};

  private constructor(private readonly solution: Solution<Options, Results>) {
    solution.onResults((results) => {
      this.#results = results;
    });
  }

  /** Loads the model; progress: called with how much has come, 0..1. */
  static async load(progress: (share: number) => void): Promise<BodyModel> {
    return new BodyModel(await loadSolution(FILES, OPTIONS, progress));
  }

  /** Computes from now on in another place; the next picture takes longer. */
  use(backend: Backend): void {
    this.solution.setOptions({ useCpuInference: backend === "CPU" });
  }

  /** Forgets the picture before: the next is of another film. */
  reset(): void {
    this.solution.reset();
  }

  /** The points of the body in a picture, `BODY_NUMBERS` of each; none where there is no body. */
  async find(image: ImageBitmap): Promise<Float32Array<ArrayBuffer>> {
    this.#results = {};
    await this.solution.send({ image });
    const { poseLandmarks = [], poseWorldLandmarks = [] } = this.#results;
    if (poseLandmarks.length !== BODY_POINTS || poseWorldLandmarks.length !== BODY_POINTS) return new Float32Array();
    const numbers = new Float32Array(BODY_NUMBERS * BODY_POINTS);
    poseWorldLandmarks.forEach(({ x, y, z, visibility = 0 }, point) => {
      const drawn = poseLandmarks[point];
      numbers.set([x, y, z, visibility, drawn?.x ?? 0, drawn?.y ?? 0], BODY_NUMBERS * point);
    });
    return numbers;
  }
}
