/** Copies of a head for each character: the same geometries and shaders, with uniforms of their own. */

import * as THREE from "three";
import type { Uniforms } from "../gpu/renderer";
import { buildHead, type EyeUniforms, eyeUniforms, type HeadParts, type HeadUniforms, headUniforms } from "./head";

/** The uniforms of one character's head. */
export interface CharacterUniforms {
  shared: HeadUniforms;
  eyes: [EyeUniforms, EyeUniforms];
}

/** A head that is never drawn itself; its copies share its geometries, and its textures that hold for everybody. */
export interface HeadTemplate extends CharacterUniforms {
  head: THREE.Group;
}

/** The head of a level of quality, for all characters. */
export function headTemplate(parts: Omit<HeadParts, "shared" | "eyes">, shared: HeadUniforms): HeadTemplate {
  const eyes: HeadTemplate["eyes"] = [eyeUniforms(), eyeUniforms()];
  return { head: buildHead({ ...parts, shared, eyes }), shared, eyes };
}

/** The textures that a character is blended into. */
interface Blended {
  readonly positions: WebGLTexture;
  readonly normals: WebGLTexture;
  readonly strains: WebGLTexture;
}

/** Uniforms of one more character; grain and layers of the skin are those of `common`. */
export function characterUniforms({ positions, normals, strains }: Blended, common: HeadUniforms): CharacterUniforms {
  const shared = headUniforms(positions, normals, common, strains);
  return { shared, eyes: [eyeUniforms(), eyeUniforms()] };
}

/** A copy of a template for a character. */
export function copyHead(template: HeadTemplate, own: CharacterUniforms): THREE.Group {
  const theirs = new Map<THREE.IUniform, THREE.IUniform>();
  const pair = (from: Uniforms, to: Uniforms): void => {
    for (const [name, uniform] of Object.entries(from)) theirs.set(uniform, to[name] as THREE.IUniform);
  };
  pair(template.shared, own.shared);
  for (const side of [0, 1] as const) pair(template.eyes[side], own.eyes[side]);
  const head = new THREE.Group();
  head.matrixAutoUpdate = false;
  for (const part of template.head.children as THREE.Mesh[]) head.add(copyPart(part, theirs));
  return head;
}

function copyPart(part: THREE.Mesh, theirs: ReadonlyMap<THREE.IUniform, THREE.IUniform>): THREE.Mesh {
  const look = part.material as THREE.RawShaderMaterial;
  const { uniforms } = look;
  look.uniforms = {}; // three would copy every texture
  const own = look.clone();
  look.uniforms = uniforms;
  own.uniforms = Object.fromEntries(
    Object.entries(uniforms).map(([name, uniform]) => [name, theirs.get(uniform) ?? uniform]),
  );
  const mesh = new THREE.Mesh(part.geometry, own);
  mesh.name = part.name;
  mesh.frustumCulled = part.frustumCulled;
  mesh.castShadow = part.castShadow;
  mesh.renderOrder = part.renderOrder;
  mesh.onBeforeRender = part.onBeforeRender;
  return mesh;
}
