/** The painted skin of a character as pictures of its own, so that a slow machine mixes its layers only when it changes. */

import * as THREE from "three";
import { coveringMaterial, fullscreenTriangle, type Uniforms } from "../gpu/renderer";
import { PICTURES } from "./picture_mix";
import { SKIN_TRAITS, type SkinUniforms } from "./skin_layers";
import { PAINT_FRAGMENT } from "./skin_paint_shaders";

/** Texels along a side: about one a pixel, where a head of 360 pixels shows. */
const SIDE = 512;

/** The uniforms that say what is painted: all of `PAINT_FRAGMENT`, and no other. */
const PAINT_UNIFORMS = [
  ...["mask", "marks", "patches", "pelt", "skin", "lip", "brow", "blush", "coat"],
  ...SKIN_TRAITS.filter((name) => name !== "scalp"),
  ...[...PICTURES, "pictureWeights", "pictured"],
];

/** What the skin's shader reads of it. */
export const paintUniforms = () => ({
  paint: { value: null } as THREE.IUniform<THREE.Texture | null>,
  sheen: { value: null } as THREE.IUniform<THREE.Texture | null>,
});

export type PaintUniforms = ReturnType<typeof paintUniforms>;

/** Paints a skin anew whenever its look has changed. */
export class SkinPaint {
  private readonly target = new THREE.WebGLRenderTarget(SIDE, SIDE, {
    count: 2,
    depthBuffer: false,
    generateMipmaps: true,
    minFilter: THREE.LinearMipmapNearestFilter,
  });
  private readonly camera = new THREE.Camera();
  private painted = "";
  /** What is drawn to paint it. */
  readonly mesh: THREE.Mesh;

  constructor(private readonly uniforms: SkinUniforms & PaintUniforms) {
    [uniforms.paint.value, uniforms.sheen.value] = this.target.textures as [THREE.Texture, THREE.Texture];
    this.mesh = fullscreenTriangle(
      coveringMaterial(
        PAINT_FRAGMENT,
        Object.fromEntries(
          [...PAINT_UNIFORMS, "hair", "scalp"].map((name) => [name, (uniforms as Uniforms)[name] as THREE.IUniform]),
        ),
      ),
    );
  }

  /** Paints it, where it looks otherwise than before. */
  draw(renderer: THREE.WebGLRenderer): void {
    const look = lookOf(this.uniforms);
    if (look === this.painted) return;
    this.painted = look;
    renderer.setRenderTarget(this.target);
    renderer.render(this.mesh, this.camera);
    renderer.setRenderTarget(null);
  }

  dispose(): void {
    this.target.dispose();
    (this.mesh.material as THREE.Material).dispose();
  }
}

/** All that a skin is painted by, in words. */
export const lookOf = (uniforms: Uniforms): string =>
  PAINT_UNIFORMS.map((name) => textOf(uniforms[name]?.value)).join();

function textOf(value: unknown): string {
  if (value instanceof THREE.Texture) return `${value.id}.${value.version}`;
  if (value instanceof THREE.Color || value instanceof THREE.Vector4) return value.toArray().join();
  return typeof value === "object" && value !== null ? Object.values(value).map(textOf).join() : String(value);
}
