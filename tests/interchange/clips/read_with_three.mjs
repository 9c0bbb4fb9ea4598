// Reads a file of motion with loaders that Omote did not write, and prints its curves as JSON.
import { readFileSync } from "node:fs";
import { BVHLoader } from "three/examples/jsm/loaders/BVHLoader.js";
import { GLTFLoader } from "three/examples/jsm/loaders/GLTFLoader.js";
import { VRMAnimationLoaderPlugin } from "@pixiv/three-vrm-animation";

globalThis.self = globalThis;
globalThis.createImageBitmap = async () => ({ width: 1, height: 1, close() {} });
const [, file] = process.argv;
const curves = (tracks) =>
  Object.fromEntries(tracks.map((track) => [track.name, { times: [...track.times], values: [...track.values] }]));

if (file.endsWith(".bvh")) {
  const { clip, skeleton } = new BVHLoader().parse(readFileSync(file, "utf8"));
  console.log(JSON.stringify({ duration: clip.duration, bones: skeleton.bones.map((bone) => bone.name), curves: curves(clip.tracks) }));
} else {
  const loader = new GLTFLoader();
  loader.register((parser) => new VRMAnimationLoaderPlugin(parser));
  const data = readFileSync(file);
  const gltf = await loader.parseAsync(data.buffer.slice(data.byteOffset, data.byteOffset + data.byteLength), "");
  const [vrm] = gltf.userData.vrmAnimations ?? [];
  const targets = {};
  gltf.scene.traverse((node) => {
    if (node.morphTargetDictionary) targets[node.name] = node.morphTargetDictionary;
  });
  const named = (map) => Object.fromEntries([...map].map(([name, track]) => [name, [...track.values]]));
  console.log(
    JSON.stringify({
      targets,
      curves: curves(gltf.animations.flatMap((animation) => animation.tracks)),
      vrm: vrm && {
        duration: vrm.duration,
        rotations: named(vrm.humanoidTracks.rotation),
        preset: named(vrm.expressionTracks.preset),
        custom: named(vrm.expressionTracks.custom),
        lookAt: [...(vrm.lookAtTrack?.values ?? [])],
      },
    }),
  );
}
