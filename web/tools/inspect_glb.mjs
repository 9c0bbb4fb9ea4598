// What others make of GLB files: Khronos' validator, and three.js' loader. One line of JSON for each file.
import { readFile } from "node:fs/promises";
import validator from "gltf-validator";
import { Texture } from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

const MOST_ISSUES = 100;

globalThis.self ??= globalThis; // the loader looks for a browser

/** The validator's verdict: how many of each severity, and what it says. */
async function validated(bytes) {
  const { issues } = await validator.validateBytes(new Uint8Array(bytes), { maxIssues: MOST_ISSUES });
  const said = issues.messages.map(({ code, severity, message, pointer }) => ({ code, severity, message, pointer }));
  const { numErrors: errors, numWarnings: warnings, numInfos: infos, numHints: hints } = issues;
  return { errors, warnings, infos, hints, said };
}

/** Every mesh as three.js has it: vertices, targets by name, where its node stands. */
async function loaded(bytes) {
  const loader = new GLTFLoader();
  loader.register(() => ({ name: "without pictures", loadTexture: async () => new Texture() })); // no canvas here
  const data = bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength);
  const { scene } = await loader.parseAsync(data, "");
  const meshes = {};
  scene.traverse((node) => {
    if (!node.isMesh) return;
    const { position } = node.geometry.attributes;
    const targets = node.morphTargetDictionary ?? {};
    const rows = node.geometry.attributes._vid?.count ?? 0;
    meshes[node.name] = { vertices: position.count, targets, rows, place: node.position.toArray() };
  });
  return { root: scene.children.map((child) => child.name), meshes };
}

for (const path of process.argv.slice(2)) {
  const bytes = await readFile(path);
  console.log(JSON.stringify({ path, validator: await validated(bytes), three: await loaded(bytes) }));
}
