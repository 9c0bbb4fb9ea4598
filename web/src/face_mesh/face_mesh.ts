/** MediaPipe's face mesh in a worker. */

import { FACE_MESH } from "virtual:face_mesh";
import { type Backend, loadSolution, type MeshPoint, type Solution } from "./solution";

/** Points of MediaPipe's face mesh with irises. */
export const LANDMARK_COUNT = 478;

interface Options {
  refineLandmarks?: boolean;
  maxNumFaces?: number;
}

interface Results {
  multiFaceLandmarks?: MeshPoint[][];
}

const FILES = { folder: FACE_MESH, name: "face_mesh", className: "FaceMesh", more: [] };

/** The model, one picture at a time. */
export class FaceMesh {
  #landmarks: MeshPoint[] | null = null;

  private constructor(private readonly solution: Solution<Options, Results>) {
    solution.onResults((results) => {
      this.#landmarks = results.multiFaceLandmarks?.[0] ?? null;
    });
  }

  /** Loads the model; progress: called with how much has come, 0..1. */
  static async load(progress: (share: number) => void): Promise<FaceMesh> {
    return new FaceMesh(await loadSolution(FILES, { refineLandmarks: true, maxNumFaces: 1 }, progress));
  }

  /** Computes from now on in another place; the next picture takes longer. */
  use(backend: Backend): void {
    this.solution.setOptions({ useCpuInference: backend === "CPU" });
  }

  /** Forgets the picture before: the next is of another film. */
  reset(): void {
    this.solution.reset();
  }

  /** The points of the face in a picture, x, y and z of each; none where there is no face. */
  async find(image: ImageBitmap): Promise<Float32Array<ArrayBuffer>> {
    this.#landmarks = null;
    await this.solution.send({ image });
    const landmarks = this.#landmarks as MeshPoint[] | null;
    if (landmarks === null || landmarks.length !== LANDMARK_COUNT) return new Float32Array();
    const points = new Float32Array(3 * LANDMARK_COUNT);
    landmarks.forEach(({ x, y, z }, index) => {
      points.set([x, y, z], 3 * index);
    });
    return points;
  }
}
