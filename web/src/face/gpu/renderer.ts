/** three's renderer and the material that every part of the head uses. */

import * as THREE from "three";

/** What people read where no face can be drawn. */
export const NO_WEBGL2 =
  "This browser gives no WebGL2, so no face can be drawn; update the graphics driver or use another browser.";

/** A renderer on a canvas, clear to begin with; an Error with a sentence when the browser gives no WebGL2. */
export function createRenderer(canvas: HTMLCanvasElement | OffscreenCanvas): THREE.WebGLRenderer {
  const context = canvas.getContext("webgl2", {
    alpha: true,
    antialias: false, // `EdgeSmoothing` does it, at every level in its way
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
  blending: THREE.CustomBlending,
  blendSrc: THREE.OneFactor,
  blendDst: THREE.ZeroFactor,
  blendSrcAlpha: THREE.OneFactor,
  blendDstAlpha: THREE.OneFactor,
};

export type Uniforms = Record<string, THREE.IUniform>;

/** Premultiplied colours over what lies behind: for what is not opaque. */
export const LAID_OVER = {
  blending: THREE.CustomBlending,
  blendSrc: THREE.OneFactor,
  blendDst: THREE.OneMinusSrcAlphaFactor,
};

/** A material of the head from its two shaders: opaque; to mix with what is there costs as much as to light it, on llvmpipe. */
export function material(vertexShader: string, fragmentShader: string, uniforms: Uniforms): THREE.RawShaderMaterial {
  return new THREE.RawShaderMaterial({
    glslVersion: THREE.GLSL3,
    vertexShader,
    fragmentShader,
    uniforms,
    blending: THREE.NoBlending,
    transparent: false,
  });
}

/** Tells a ribbon's shader the metres that a pixel covers a metre away, whenever its mesh is drawn. */
export function tellPixel(mesh: THREE.Mesh, pixel: THREE.IUniform<number>): void {
  mesh.onBeforeRender = (renderer, _scene, camera) => {
    const { w: height } = renderer.getCurrentViewport(new THREE.Vector4());
    pixel.value = 2 / ((camera.projectionMatrix.elements[5] as number) * height);
  };
}

/** The vertex shader of a triangle that covers the picture; `place`: 0..1 from its left and from its bottom. */
export const FULLSCREEN_VERTEX = `
precision highp float;
out vec2 place;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;
  place = corner;
  gl_Position = vec4(corner * 2.0 - 1.0, 0.0, 1.0);
}
`;

/** A material of what covers the picture, whatever its depth. */
export const coveringMaterial = (fragment: string, uniforms: Uniforms, vertex = FULLSCREEN_VERTEX) =>
  Object.assign(material(vertex, fragment, uniforms), { depthTest: false, depthWrite: false });

/** A triangle that covers the picture; its vertex shader finds the corners by their numbers. */
export function fullscreenTriangle(look?: THREE.Material): THREE.Mesh {
  const triangle = new THREE.Mesh(new THREE.BufferGeometry().setIndex([0, 1, 2]), look);
  triangle.frustumCulled = false;
  return triangle;
}

/** A texture for a copy of a part of the canvas, between whose pixels is interpolated. */
export function framebufferTexture(width: number, height: number): THREE.FramebufferTexture {
  const texture = new THREE.FramebufferTexture(width, height);
  texture.minFilter = texture.magFilter = THREE.LinearFilter;
  texture.flipY = false; // or three leaves the context flipping what others upload, which 3D textures refuse
  return texture;
}
