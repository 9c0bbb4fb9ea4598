import { readFileSync } from "node:fs";
import { resolve } from "node:path";
import { expect, it } from "vitest";
import { patchGlue } from "./mediapipe_assets.ts";

const read = (path: string): string => readFileSync(resolve(import.meta.dirname, path), "utf8");
const glueOf = (name: string): string => read(`../node_modules/@mediapipe/${name}/${name}_solution_simd_wasm_bin.js`);
const glue = glueOf("face_mesh");
const closures = read("embind_closures.js");

it("leaves no function that is made from a string, and the rest as it is", () => {
  const patched = patchGlue(glue, closures);
  expect(patched).not.toMatch(/new Function\(|new_\(Function/);
  expect(() => new Function(patched)).not.toThrow();
  const end = glue.indexOf("function __emval_incref");
  expect(patched.endsWith(glue.slice(end))).toBe(true);
  expect(patched.startsWith(glue.slice(0, glue.indexOf("function createNamedFunction")))).toBe(true);
});

it.each(["hands", "pose"])("leaves the glue of %s as it is, which makes no code from strings", (name) => {
  expect(patchGlue(glueOf(name), closures)).toBe(glueOf(name));
});

it("stops the build for another glue", () => {
  expect(() => patchGlue("new Function()", closures)).toThrow("has no createNamedFunction");
  expect(() => patchGlue(glue, "")).toThrow("embind_closures.js has no createNamedFunction");
  expect(() => patchGlue(`${glue};eval("1")`, closures)).toThrow("still makes code from strings");
});
