/**
 * MediaPipe's face mesh in a worker. The package's own way for workers is broken; its way for windows works behind a
 * window, a document and a canvas that do what it asks of them.
 */

import { FACE_MESH } from "virtual:face_mesh";

/** Points of MediaPipe's face mesh with irises. */
export const LANDMARK_COUNT = 478;

/** Where the model computes. */
export type Backend = "CPU" | "GPU";

interface MeshPoint {
  x: number;
  y: number;
  z: number;
}

interface Results {
  multiFaceLandmarks?: MeshPoint[][];
}

/** The package, as its types say it, and one option that they leave out. */
interface Solution {
  setOptions(options: { refineLandmarks?: boolean; maxNumFaces?: number; useCpuInference?: boolean }): void;
  onResults(listener: (results: Results) => void): void;
  initialize(): Promise<void>;
  reset(): void;
  send(input: { image: OffscreenCanvas | ImageBitmap }): Promise<void>;
}

declare const importScripts: (...addresses: string[]) => void;

/** The files that are loaded, by size: what a page says of how far it is. */
const LARGE_FILES = [
  "face_mesh_solution_simd_wasm_bin.wasm",
  "face_mesh_solution_packed_assets.data",
  "face_mesh_solution_simd_wasm_bin.js",
];

/** A script element: it is loaded when it is put into the document. */
class ScriptElement {
  #address = "";
  #heard: (() => void)[] = [];

  setAttribute(name: string, value: string): void {
    if (name === "src") this.#address = value;
  }

  addEventListener(name: string, heard: () => void): void {
    if (name === "load") this.#heard.push(heard);
  }

  load(): void {
    importScripts(this.#address);
    for (const listener of this.#heard) listener();
  }
}

/** Gives the package the window and the document that it asks for. */
function provideWindow(): void {
  const body = { appendChild: (script: ScriptElement) => script.load() };
  const createElement = (name: string) => (name === "canvas" ? new OffscreenCanvas(1, 1) : new ScriptElement());
  Object.assign(globalThis, { window: globalThis, document: { createElement, body } });
}

/** Reads the large files once, so that the browser has them when the package asks. progress: called with how much has come, 0..1. */
async function fetchFiles(progress: (share: number) => void): Promise<void> {
  const answers = await Promise.all(LARGE_FILES.map((name) => fetch(FACE_MESH + name)));
  const missing = answers.find((answer) => !answer.ok);
  if (missing) throw new Error(`the server has no ${missing.url} (${missing.status}); build the pages again: make web`);
  const total = answers.reduce((sum, answer) => sum + Number(answer.headers.get("Content-Length") ?? 0), 0);
  let done = 0;
  const read = async (reader: ReadableStreamDefaultReader<Uint8Array>): Promise<void> => {
    for (let chunk = await reader.read(); !chunk.done; chunk = await reader.read()) {
      done += chunk.value.length;
      progress(total > 0 ? done / total : 0);
    }
  };
  await Promise.all(answers.flatMap((answer) => (answer.body ? [read(answer.body.getReader())] : [])));
}

/** The model, one picture at a time. */
export class FaceMesh {
  #landmarks: MeshPoint[] | null = null;

  private constructor(private readonly solution: Solution) {
    solution.onResults((results) => {
      this.#landmarks = results.multiFaceLandmarks?.[0] ?? null;
    });
  }

  /** Loads the model; progress: called with how much has come, 0..1. */
  static async load(progress: (share: number) => void): Promise<FaceMesh> {
    await fetchFiles(progress);
    provideWindow();
    importScripts(`${FACE_MESH}face_mesh.js`);
    const scope = globalThis as unknown as { FaceMesh: new (config: object) => Solution };
    const solution = new scope.FaceMesh({ locateFile: (name: string) => FACE_MESH + name });
    solution.setOptions({ refineLandmarks: true, maxNumFaces: 1, useCpuInference: true });
    await solution.initialize();
    return new FaceMesh(solution);
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
