/** three's renderer and the material that every part of the head uses. */

import * as THREE from "three";

/** What people read where no face can be drawn. */
export const NO_WEBGL2 =
  "This browser gives no WebGL2, so no face can be drawn; update the graphics driver or use another browser.";

/** A renderer on a canvas, clear to begin with; an Error with a sentence when the browser gives no WebGL2. */
export function createRenderer(canvas: HTMLCanvasElement | OffscreenCanvas): THREE.WebGLRenderer {
  const context = canvas.getContext("webgl2", {
    alpha: true,
    antialias: false, // `EdgeSmoothing` does it, at every level in its way, and has the depth
    depth: false,
    premultipliedAlpha: true,
    powerPreference: "high-performance",
  }) as WebGL2RenderingContext | null;
  if (context === null) throw new Error(NO_WEBGL2);
  const renderer = new THREE.WebGLRenderer({ canvas, context, alpha: true, premultipliedAlpha: true });
  renderer.setClearColor(0x000000, 0);
  return renderer;
}

/** Edges by samples: alpha says how many of a pixel's samples are covered; the picture's own alpha only grows. */
export const COVERAGE = {
  alphaToCoverage: true,
  blendDst: THREE.ZeroFactor,
  blendSrcAlpha: THREE.OneFactor,
  blendDstAlpha: THREE.OneFactor,
};

export type Uniforms = Record<string, THREE.IUniform>;

/** A material of the head from its two shaders; its colours are premultiplied. */
export function material(vertexShader: string, fragmentShader: string, uniforms: Uniforms): THREE.RawShaderMaterial {
  return new THREE.RawShaderMaterial({
    glslVersion: THREE.GLSL3,
    vertexShader,
    fragmentShader,
    uniforms,
    blending: THREE.CustomBlending,
    blendSrc: THREE.OneFactor,
    blendDst: THREE.OneMinusSrcAlphaFactor,
    transparent: false,
  });
}
