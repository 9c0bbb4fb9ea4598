/** MediaPipe's hands in a worker. */

import { HANDS } from "virtual:hands";
import { type Backend, loadSolution, type MeshPoint, type Solution } from "../face_mesh/solution";
import { type FoundHand, HAND_POINTS } from "./hand_messages";

interface Options {
  maxNumHands?: number;
  modelComplexity?: 0 | 1;
  minDetectionConfidence?: number;
  minTrackingConfidence?: number;
}

interface Results {
  multiHandLandmarks?: MeshPoint[][];
  multiHandWorldLandmarks?: MeshPoint[][];
  multiHandedness?: { label: "Left" | "Right"; score: number }[];
}

const FILES = { folder: HANDS, name: "hands", className: "Hands", more: ["hand_landmark_lite.tflite"] };

/** The model, one picture at a time. */
export class HandModel {
  #results: Results = {};

  private constructor(private readonly solution: Solution<Options, Results>) {
    solution.onResults((results) => {
      this.#results = results;
    });
  }

  /** Loads the model. most: hands that it looks for; progress: called with how much has come, 0..1. */
  static async load(most: number, progress: (share: number) => void): Promise<HandModel> {
    const options: Options = {
      maxNumHands: most,
      modelComplexity: 0,
      minDetectionConfidence: 0.5,
      minTrackingConfidence: 0.5,
    };
    return new HandModel(await loadSolution(FILES, options, progress));
  }

  /** Computes from now on in another place; the next picture takes longer. */
  use(backend: Backend): void {
    this.solution.setOptions({ useCpuInference: backend === "CPU" });
  }

  /** Forgets the picture before: the next is of another film. */
  reset(): void {
    this.solution.reset();
  }

  /** The hands in a picture. */
  async look(image: ImageBitmap): Promise<FoundHand[]> {
    this.#results = {};
    await this.solution.send({ image });
    const { multiHandLandmarks = [], multiHandWorldLandmarks = [], multiHandedness = [] } = this.#results;
    return multiHandLandmarks.flatMap((points, place) => {
      const [world, handedness] = [multiHandWorldLandmarks[place], multiHandedness[place]];
      if (points.length !== HAND_POINTS || world?.length !== HAND_POINTS || handedness === undefined) return [];
      const side = handedness.label === "Left" ? ("right" as const) : ("left" as const);
      return [{ image: flat(points), world: flat(world), side, score: handedness.score }];
    });
  }
}

function flat(points: MeshPoint[]): Float32Array<ArrayBuffer> {
  const values = new Float32Array(3 * points.length);
  points.forEach(({ x, y, z }, index) => {
    values.set([x, y, z], 3 * index);
  });
  return values;
}
