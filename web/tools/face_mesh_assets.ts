/** Puts MediaPipe's face mesh into the built pages: its files as they are, but for functions that it makes from strings. */

import { createHash } from "node:crypto";
import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import type { Plugin } from "vite";

const PACKAGE = resolve(import.meta.dirname, "../node_modules/@mediapipe/face_mesh");
const CLOSURES = resolve(import.meta.dirname, "embind_closures.js");
const GLUE = "face_mesh_solution_simd_wasm_bin.js";
/** Every browser that the pages run in knows SIMD (Chromium 91, Firefox 89, Safari 16.4): the other wasm stays out. */
const FILES = [
  "face_mesh.binarypb",
  "face_mesh.js",
  "face_mesh_solution_packed_assets.data",
  "face_mesh_solution_packed_assets_loader.js",
  GLUE,
  "face_mesh_solution_simd_wasm_bin.wasm",
];
/** What the licence asks of whoever passes changed files on. */
const NOTICE = `MediaPipe Face Mesh 0.4.1633559619 (npm @mediapipe/face_mesh), by the MediaPipe authors, under the Apache
License 2.0 (LICENSE beside this file). Omote changed ${GLUE}: three functions that embind made from strings are closures.
`;
const NAME = "virtual:face_mesh";
const REPLACED: readonly (readonly [name: string, next: string])[] = [
  ["createNamedFunction", "var emval_free_list"],
  ["craftInvokerFunction", "function heap32VectorToArray"],
  ["__emval_get_method_caller", "function __emval_incref"],
];

/** The glue with closures in place of functions made from strings; an Error where it is not the glue that we know. */
export function patchGlue(glue: string, closures: string): string {
  let patched = glue;
  for (const [name, next] of REPLACED) {
    const start = patched.indexOf(`function ${name}(`);
    const end = patched.indexOf(next, start);
    if (start < 0 || end < 0) throw new Error(`${GLUE} has no ${name} before ${next}: look at its new version`);
    patched = patched.slice(0, start) + functionText(closures, name) + patched.slice(end);
  }
  if (/new Function\(|new_\(Function|\beval\(/.test(patched)) throw new Error(`${GLUE} still makes code from strings`);
  return patched;
}

function functionText(source: string, name: string): string {
  const found = new RegExp(`^export function ${name}\\([\\s\\S]*?^}\\n`, "m").exec(source);
  if (!found) throw new Error(`embind_closures.js has no ${name}`);
  return found[0].slice("export ".length);
}

function readFiles(): Map<string, Uint8Array | string> {
  const files = new Map<string, Uint8Array | string>();
  for (const name of FILES) files.set(name, readFileSync(resolve(PACKAGE, name)));
  files.set("LICENSE", readFileSync(resolve(import.meta.dirname, "apache-2.0.txt")));
  files.set("NOTICE", NOTICE);
  files.set(GLUE, patchGlue(readFileSync(resolve(PACKAGE, GLUE), "utf8"), readFileSync(CLOSURES, "utf8")));
  return files;
}

/** Built files are kept by browsers for ever: the folder changes with its content. */
function folderOf(files: Map<string, Uint8Array | string>): string {
  const hash = createHash("sha256");
  for (const content of files.values()) hash.update(content);
  return `static/face_mesh-${hash.digest("hex").slice(0, 8)}`;
}

/** The plugin. `virtual:face_mesh` says where the files are; the pages' build (not the worker's) writes them. */
export function faceMeshAssets(role: "pages" | "worker"): Plugin {
  const files = readFiles();
  const folder = folderOf(files);
  return {
    name: "face mesh assets",
    resolveId: (id) => (id === NAME ? NAME : null),
    load: (id) => (id === NAME ? `export const FACE_MESH = ${JSON.stringify(`/${folder}/`)};` : null),
    generateBundle() {
      if (role !== "pages") return;
      for (const [name, source] of files) this.emitFile({ type: "asset", fileName: `${folder}/${name}`, source });
    },
  };
}
