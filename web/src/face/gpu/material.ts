import * as THREE from "three";

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
