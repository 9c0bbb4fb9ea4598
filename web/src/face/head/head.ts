/** Builds the head as a scene of three, and its uniforms. */

import * as THREE from "three";
import type { Mesh } from "../../link/assets";
import type { Anatomy } from "../anatomy/anatomy";
import { rowTriangles } from "../anatomy/topology";
import { bodyParts } from "../figure/body_mesh";
import { floor, floorUniforms } from "../figure/floor";
import { type GarmentUniforms, garmentUniforms } from "../figure/garments";
import type { SharedFigures } from "../figure/shared_figures";
import { material, type Uniforms } from "../gpu/renderer";
import { type LightUniforms, lightUniforms } from "../light/light_uniforms";
import { type ShadowUniforms, shadowUniforms } from "../light/shadow";
import { definesOf, type Features } from "../quality/quality_levels";
import { type BloodUniforms, bloodUniforms } from "../skin/blood";
import { type SkinUniforms, skinUniforms } from "../skin/skin_layers";
import { type PaintUniforms, paintUniforms } from "../skin/skin_paint";
import { skinParts } from "../skin/skin_parts";
import { brows } from "./brows";
import { COLLAR_FRAGMENT, COLLAR_VERTEX, collar } from "./collar";
import type { EyeTraits } from "./eye_traits";
import { eyeball } from "./eyeballs";
import { fur } from "./fur";
import { lashes } from "./lashes";
import { mouthParts } from "./mouth";
import { type Cages, cagesOf } from "./teeth_cage";

/** The colours of a look, which the shaders take in linear light. */
export const LOOK_COLOURS = ["skin", "lip", "brow", "blush", "iris", "hair", "coat", "cloth", "trim"] as const;
type LookColours = Record<(typeof LOOK_COLOURS)[number], THREE.IUniform<THREE.Color>>;
type EyeNumbers = Record<keyof EyeTraits, THREE.IUniform<number>>;

/** The uniforms all materials share; written once a frame. */
export interface HeadUniforms
  extends Uniforms,
    LightUniforms,
    ShadowUniforms,
    SkinUniforms,
    PaintUniforms,
    BloodUniforms,
    LookColours,
    GarmentUniforms,
    EyeNumbers {
  positions: THREE.IUniform<THREE.Texture>;
  normals: THREE.IUniform<THREE.Texture>;
  strains: THREE.IUniform<THREE.Texture>;
  /** How much of the skin's folds shows; 0 where nothing presses it. */
  folds: THREE.IUniform<number>;
  /** 1 where strains say how skin is pressed. */
  pressed: THREE.IUniform<number>;
  headTurn: THREE.IUniform<THREE.Matrix3>;
  pivot: THREE.IUniform<THREE.Vector3>;
  /** Where the pivot is. */
  headPlace: THREE.IUniform<THREE.Vector3>;
  /** Rows of skin and body as a figure is posed, and their normals. */
  figurePositions: THREE.IUniform<THREE.Texture | null>;
  figureNormals: THREE.IUniform<THREE.Texture | null>;
  /** How far the floor is seen, 0..1. */
  floorSeen: THREE.IUniform<number>;
  /** Where feet and hips are, and the height of the soles of a figure that stands. */
  contacts: THREE.IUniform<THREE.Vector3[]>;
  soles: THREE.IUniform<number>;
  viewPoint: THREE.IUniform<THREE.Vector3>;
  grain: THREE.IUniform<THREE.Texture>;
  /** How densely hair grows at each row, 0..1. */
  roots: THREE.IUniform<THREE.Texture | null>;
}

/** What differs between the two eyeballs. */
export interface EyeUniforms extends Uniforms {
  centre: THREE.IUniform<THREE.Vector3>;
  radius: THREE.IUniform<number>;
  eyeTurn: THREE.IUniform<THREE.Matrix3>;
}

/** Where the head turns: the top of the spine, metres. */
/** Where a head alone turns: in the neck, metres. */
export const PIVOT = new THREE.Vector3(0, -0.075, 0.03);

/** The uniforms of a head; `common`: of another, whose grain and layers of the skin it shares. */
export function headUniforms(
  positions: WebGLTexture | null,
  normals: WebGLTexture | null,
  common?: HeadUniforms,
  strains: WebGLTexture | null = null,
): HeadUniforms {
  return {
    ...lightUniforms(),
    ...skinUniforms(common),
    ...paintUniforms(),
    ...shadowUniforms(),
    ...bloodUniforms(),
    positions: { value: new THREE.ExternalTexture(positions) },
    normals: { value: new THREE.ExternalTexture(normals) },
    strains: { value: new THREE.ExternalTexture(strains) },
    folds: { value: 0 },
    pressed: { value: 0 },
    headTurn: { value: new THREE.Matrix3() },
    pivot: { value: PIVOT.clone() },
    headPlace: { value: PIVOT.clone() },
    figurePositions: { value: null },
    figureNormals: { value: null },
    ...floorUniforms(),
    ...garmentUniforms(),
    viewPoint: { value: new THREE.Vector3() },
    grain: common?.grain ?? { value: grainTexture() },
    ...(Object.fromEntries(LOOK_COLOURS.map((part) => [part, { value: new THREE.Color() }])) as LookColours),
    roots: { value: null },
    irisSize: { value: 1 },
    slit: { value: 0 },
    lashes: { value: 1 },
    pupil: { value: 0 },
  };
}

export const eyeUniforms = (): EyeUniforms => ({
  centre: { value: new THREE.Vector3() },
  radius: { value: 0.015 },
  eyeTurn: { value: new THREE.Matrix3() },
});

/** What a head is built from. */
export interface HeadParts {
  meshes: readonly Mesh[];
  anatomy: Anatomy;
  shared: HeadUniforms;
  eyes: [EyeUniforms, EyeUniforms];
  /** What the picture may cost. */
  features: Features;
  /** What bodies share, where heads have one. */
  figures?: SharedFigures | undefined;
  /** Whether the floor that they stand on is drawn. */
  onFloor?: boolean;
}

/** The whole head as a scene. */
export function buildHead(from: HeadParts): THREE.Group {
  const head = new THREE.Group();
  const cages = cagesOf(from.meshes, from.anatomy.positions);
  for (const mesh of from.meshes)
    if (mesh.name !== "lashes")
      for (const part of drawn(mesh, from, cages)) head.add(Object.assign(part, { name: mesh.name }));
  const fast = !from.features.pixelLight;
  const grown = lashes(from.anatomy, from.shared, fast);
  if (grown !== undefined) head.add(Object.assign(grown, { name: "lashes" }));
  const hairs = from.features.detail ? brows(from.meshes, from.anatomy.positions, from.shared) : undefined;
  if (hairs !== undefined) head.add(Object.assign(hairs, { name: "brows" }));
  const skin = from.meshes.find(({ name }) => name === "skin");
  if (from.features.detail && skin !== undefined)
    head.add(Object.assign(fur(skin, from.anatomy, from.shared), { name: "fur" }));
  for (const part of belowHead(from)) head.add(part);
  for (const child of head.children) {
    child.frustumCulled = false; // the vertices are where the GPU puts them
    const look = (child as THREE.Mesh).material as THREE.RawShaderMaterial;
    look.defines = { ...look.defines, ...definesOf(from.features) };
  }
  return head;
}

/** The body of a figure, or a collar around the neck of a head alone. */
function belowHead({ anatomy, meshes, shared, features, figures, onFloor }: HeadParts): THREE.Mesh[] {
  const skin = meshes.find(({ name }) => name === "skin");
  if (features.figure && figures !== undefined && skin !== undefined)
    return [
      ...bodyParts(figures, rowTriangles(skin), anatomy, shared, features.multisample),
      ...(onFloor ? [floor(shared)] : []),
    ];
  if (anatomy.rim.length === 0) return [];
  return [new THREE.Mesh(collar(anatomy, !features.pixelLight), material(COLLAR_VERTEX, COLLAR_FRAGMENT, shared))];
}

function drawn(mesh: Mesh, from: HeadParts, cages: Cages): THREE.Mesh[] {
  const { anatomy, shared, eyes, features } = from;
  switch (mesh.name) {
    case "eye_left":
    case "eye_right": {
      const side = mesh.name === "eye_left" ? 0 : 1;
      return [eyeball(side, anatomy, { ...shared, ...eyes[side] }, !features.pixelLight)];
    }
    case "teeth_upper":
    case "teeth_lower":
    case "tongue":
      return mouthParts(geometryOf(mesh), mesh, anatomy, cages, shared, features);
    default:
      return skinParts(geometryOf(mesh), mesh, anatomy, shared, features.detail);
  }
}

/** The triangles of a mesh, and the row of the positions of each of its vertices. */
export function geometryOf(mesh: Mesh): THREE.BufferGeometry {
  const geometry = new THREE.BufferGeometry();
  geometry.setIndex(new THREE.BufferAttribute(mesh.triangles, 1));
  geometry.setAttribute("source", new THREE.BufferAttribute(Float32Array.from(mesh.source), 1));
  return geometry;
}

/** Four channels of seeded noise that tile: pores, blotches, fibres. */
function grainTexture(size = 256): THREE.DataTexture {
  const data = new Uint8Array(4 * size * size);
  let seed = 0x2545f491;
  for (let index = 0; index < data.length; index++) {
    seed ^= seed << 13;
    seed ^= seed >>> 17;
    seed ^= seed << 5;
    data[index] = seed & 255;
  }
  const texture = new THREE.DataTexture(blurred(data, size), size, size);
  texture.wrapS = texture.wrapT = THREE.RepeatWrapping;
  texture.magFilter = THREE.LinearFilter;
  texture.minFilter = THREE.LinearMipmapNearestFilter;
  texture.generateMipmaps = true;
  texture.needsUpdate = true;
  return texture;
}

/** Box-blurs the channels over 1, 2, 4 and 1 texels and stretches them back to full contrast. */
function blurred(data: Uint8Array, size: number): Uint8Array {
  const out = new Uint8Array(data.length);
  [1, 2, 4, 1].forEach((reach, channel) => {
    for (let y = 0; y < size; y++)
      for (let x = 0; x < size; x++) {
        let sum = 0;
        for (let dy = 0; dy < 2 * reach; dy++)
          for (let dx = 0; dx < 2 * reach; dx++)
            sum += data[4 * (((y + dy) % size) * size + ((x + dx) % size)) + channel] as number;
        const mean = sum / (4 * reach * reach);
        out[4 * (y * size + x) + channel] = Math.min(255, Math.max(0, 127.5 + (mean - 127.5) * 1.6 * reach));
      }
  });
  return out;
}
