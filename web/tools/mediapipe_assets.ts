/** Puts MediaPipe's models into the built pages: their files as they are, but for functions that one makes from strings. */

import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import type { Plugin } from "vite";

const CLOSURES = resolve(import.meta.dirname, "embind_closures.js");

/** A model's package. */
interface Model {
  /** Of the package below `@mediapipe`, and of its files. */
  readonly name: string;
  readonly title: string;
  readonly version: string;
  /** The file of its graph. */
  readonly graph: string;
  /** What of it is served, beside its script, its graph and what all have. */
  readonly files: readonly string[];
  /** The constant of the virtual module that says where the files are. */
  readonly constant: string;
}

const FACE_MESH: Model = {
  name: "face_mesh",
  title: "Face Mesh",
  version: "0.4.1633559619",
  graph: "face_mesh.binarypb",
  files: [],
  constant: "FACE_MESH",
};
/** The lite model alone: the full one takes twice as long, and misses one in twenty hands of two. */
const HANDS: Model = {
  name: "hands",
  title: "Hands",
  version: "0.4.1675469240",
  graph: "hands.binarypb",
  files: ["hand_landmark_lite.tflite"],
  constant: "HANDS",
};
/** The lite model alone: the full one has 3.6 MB more and takes longer than a face and a body together may. */
const POSE: Model = {
  name: "pose",
  title: "Pose",
  version: "0.5.1675469404",
  graph: "pose_web.binarypb",
  files: ["pose_landmark_lite.tflite"],
  constant: "POSE",
};

const glueOf = ({ name }: Model): string => `${name}_solution_simd_wasm_bin.js`;

/** Every browser that the pages run in knows SIMD (Chromium 91, Firefox 89, Safari 16.4): the other wasm stays out. */
const filesOf = (model: Model): string[] => [
  model.graph,
  `${model.name}.js`,
  `${model.name}_solution_packed_assets.data`,
  `${model.name}_solution_packed_assets_loader.js`,
  glueOf(model),
  `${model.name}_solution_simd_wasm_bin.wasm`,
  ...model.files,
];

const CHANGED = ` Omote changed ${glueOf(FACE_MESH)}: three functions that embind made from strings are closures.`;
/** What the licence asks of whoever passes files on, and of whoever has changed them. */
const noticeOf = (model: Model): string =>
  `MediaPipe ${model.title} ${model.version} (npm @mediapipe/${model.name}), by the MediaPipe authors, under the Apache
License 2.0 (LICENSE beside this file).${model === FACE_MESH ? CHANGED : ""}
`;
const REPLACED: readonly (readonly [name: string, next: string])[] = [
  ["createNamedFunction", "var emval_free_list"],
  ["craftInvokerFunction", "function heap32VectorToArray"],
  ["__emval_get_method_caller", "function __emval_incref"],
];

const FROM_STRINGS = /new Function\(|new_\(Function|\beval\(/;

/** The glue with closures in place of functions made from strings, where it has such; an Error where it is not the glue that we know. */
export function patchGlue(glue: string, closures: string): string {
  let patched = glue;
  if (!FROM_STRINGS.test(glue)) return glue; // a newer embind
  for (const [name, next] of REPLACED) {
    const start = patched.indexOf(`function ${name}(`);
    const end = patched.indexOf(next, start);
    if (start < 0 || end < 0) throw new Error(`the glue has no ${name} before ${next}: look at its new version`);
    patched = patched.slice(0, start) + functionText(closures, name) + patched.slice(end);
  }
  if (FROM_STRINGS.test(patched)) throw new Error("the glue still makes code from strings");
  return patched;
}

function functionText(source: string, name: string): string {
  const found = new RegExp(`^export function ${name}\\([\\s\\S]*?^}\\n`, "m").exec(source);
  if (!found) throw new Error(`embind_closures.js has no ${name}`);
  return found[0].slice("export ".length);
}

function readFiles(model: Model): Map<string, Uint8Array | string> {
  const folder = resolve(import.meta.dirname, "../node_modules/@mediapipe", model.name);
  const files = new Map<string, Uint8Array | string>();
  for (const name of filesOf(model)) files.set(name, readFileSync(resolve(folder, name)));
  files.set("LICENSE", readFileSync(resolve(import.meta.dirname, "apache-2.0.txt")));
  files.set("NOTICE", noticeOf(model));
  if (model === POSE) files.set("files.json", sumsOf(files, filesOf(model)));
  const glue = glueOf(model);
  files.set(glue, patchGlue(readFileSync(resolve(folder, glue), "utf8"), readFileSync(CLOSURES, "utf8")));
  return files;
}

/** The SHA-256 of some files: a wheel has these alone of a model, and `omote body-model` the files. */
function sumsOf(files: Map<string, Uint8Array | string>, names: readonly string[]): string {
  const sum = (name: string): string =>
    createHash("sha256")
      .update(files.get(name) ?? "")
      .digest("hex");
  return JSON.stringify(Object.fromEntries(names.map((name) => [name, sum(name)])));
}

/** Built files are kept by browsers for ever: the folder changes with its content. */
function folderOf({ name }: Model, files: Map<string, Uint8Array | string>): string {
  const hash = createHash("sha256");
  for (const content of files.values()) hash.update(content);
  return `static/${name}-${hash.digest("hex").slice(0, 8)}`;
}

function modelAssets(model: Model, role: "pages" | "worker"): Plugin {
  const files = readFiles(model);
  const folder = folderOf(model, files);
  const virtual = `virtual:${model.name}`;
  return {
    name: `${model.name} assets`,
    resolveId: (id) => (id === virtual ? virtual : null),
    load: (id) => (id === virtual ? `export const ${model.constant} = ${JSON.stringify(`/${folder}/`)};` : null),
    generateBundle() {
      if (role !== "pages") return;
      for (const [name, source] of files) this.emitFile({ type: "asset", fileName: `${folder}/${name}`, source });
    },
  };
}

/** The plugins. `virtual:face_mesh`, `virtual:hands` and `virtual:pose` say where the files are; the pages' build (not the worker's) writes them. */
export const mediapipeAssets = (role: "pages" | "worker"): Plugin[] =>
  [FACE_MESH, HANDS, POSE].map((model) => modelAssets(model, role));
