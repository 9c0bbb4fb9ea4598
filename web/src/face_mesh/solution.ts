/**
 * A model of MediaPipe's in a worker. The packages' own way for workers is broken; their way for windows works behind a
 * window, a document and a canvas that do what they ask of them.
 */

/** Where a model computes. */
export type Backend = "CPU" | "GPU";

/** A point as the packages give it. */
export interface MeshPoint {
  x: number;
  y: number;
  z: number;
}

/** A package, as its types say it, and one option that they leave out. */
export interface Solution<Options, Results> {
  setOptions(options: Options & { useCpuInference?: boolean }): void;
  onResults(listener: (results: Results) => void): void;
  initialize(): Promise<void>;
  reset(): void;
  send(input: { image: OffscreenCanvas | ImageBitmap }): Promise<void>;
}

/**
 * Which package: the folder of its files at the server, how these begin, its class, large files of its own, and what to
 * do where the server has none of them.
 */
export interface SolutionFiles {
  readonly folder: string;
  readonly name: string;
  readonly className: string;
  readonly more: readonly string[];
  readonly advice?: string;
}

declare const importScripts: (...addresses: string[]) => void;

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

/** Gives a package the window and the document that it asks for. */
function provideWindow(): void {
  const body = { appendChild: (script: ScriptElement) => script.load() };
  const createElement = (name: string) => (name === "canvas" ? new OffscreenCanvas(1, 1) : new ScriptElement());
  Object.assign(globalThis, { window: globalThis, document: { createElement, body } });
}

const BUILD_AGAIN = "build the pages again: make web";

/** Reads the large files once, so that the browser has them when the package asks. progress: called with how much has come, 0..1. */
async function fetchFiles(
  { folder, name, more, advice }: SolutionFiles,
  progress: (share: number) => void,
): Promise<void> {
  const large = [
    `${name}_solution_simd_wasm_bin.wasm`,
    `${name}_solution_packed_assets.data`,
    `${name}_solution_simd_wasm_bin.js`,
  ];
  const answers = await Promise.all([...large, ...more].map((file) => fetch(folder + file)));
  const missing = answers.find((answer) => !answer.ok);
  if (missing) throw new Error(`the server has no ${missing.url} (${missing.status}); ${advice ?? BUILD_AGAIN}`);
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

/** Loads a model; options: what it is set to, on the processor; progress: called with how much has come, 0..1. */
export async function loadSolution<Options, Results>(
  files: SolutionFiles,
  options: Options,
  progress: (share: number) => void,
): Promise<Solution<Options, Results>> {
  await fetchFiles(files, progress);
  provideWindow();
  importScripts(`${files.folder}${files.name}.js`);
  const scope = globalThis as unknown as Record<string, new (config: object) => Solution<Options, Results>>;
  const Named = scope[files.className];
  if (Named === undefined) throw new Error(`${files.name}.js has no ${files.className}: look at its new version`);
  const solution = new Named({ locateFile: (file: string) => files.folder + file });
  solution.setOptions({ ...options, useCpuInference: true });
  await solution.initialize();
  return solution;
}
