/** Draws a scene with smooth edges: by samples, or after it has been drawn. */

import * as THREE from "three";
import { coveringMaterial, framebufferTexture, fullscreenTriangle } from "./renderer";

/** Samples of a pixel where edges are drawn from several. */
const SAMPLES = 4;

/** Pixels that the smoothed columns begin and end at whole multiples of, so that their copy is seldom made anew. */
const STEP = 16;

const SAMPLED_FRAGMENT = `
precision highp float;
precision highp sampler2D;
uniform sampler2D picture;
out vec4 colour;
void main() { colour = texelFetch(picture, ivec2(gl_FragCoord.xy), 0); }
`;

/** Covers the columns that `picture` was copied from, less one pixel all around: each has all its neighbours. */
const COLUMNS_VERTEX = `
precision highp float;
precision highp sampler2D;
uniform vec2 whole; // pixels of the canvas
uniform float left; // pixels
uniform sampler2D picture;
void main() {
  vec2 size = vec2(textureSize(picture, 0));
  vec2 at = vec2(left, 0.0) + mix(vec2(1.0), size - 1.0, vec2(gl_VertexID & 1, gl_VertexID >> 1));
  gl_Position = vec4(2.0 * at / whole - 1.0, 0.0, 1.0);
}
`;

/**
 * Fast approximate antialiasing (T. Lottes, "FXAA", 2009), in its short form: where the four diagonal neighbours differ,
 * the picture is blurred along the edge that they show. Green and red stand for brightness; alpha is smoothed too.
 */
const COLUMNS_FRAGMENT = `
precision highp float;
precision highp sampler2D;
uniform sampler2D picture;
uniform vec2 texel;
uniform float left;
out vec4 colour;

float bright(vec4 at) { return at.g + 0.5 * at.r + 0.25 * at.a; } // alpha: so that a dark head on nothing has an edge too

void main() {
  ivec2 here = ivec2(gl_FragCoord.xy) - ivec2(int(left), 0);
  float lowLeft = bright(texelFetch(picture, here - 1, 0));
  float lowRight = bright(texelFetch(picture, here + ivec2(1, -1), 0));
  float highLeft = bright(texelFetch(picture, here + ivec2(-1, 1), 0));
  float highRight = bright(texelFetch(picture, here + 1, 0));
  float own = bright(texelFetch(picture, here, 0));
  float least = min(own, min(min(lowLeft, lowRight), min(highLeft, highRight)));
  float most = max(own, max(max(lowLeft, lowRight), max(highLeft, highRight)));
  if (most - least < 0.04 + 0.10 * most) discard; // no edge: the canvas has this pixel already
  vec2 along = vec2(highLeft + highRight - lowLeft - lowRight, lowLeft + highLeft - lowRight - highRight);
  along /= min(abs(along.x), abs(along.y)) + max(0.03 * (lowLeft + lowRight + highLeft + highRight), 0.01);
  along = clamp(along, -6.0, 6.0) * texel;
  vec2 place = (vec2(here) + 0.5) * texel;
  vec4 near = 0.5 * (texture(picture, place - along / 6.0) + texture(picture, place + along / 6.0));
  vec4 far = 0.5 * near + 0.25 * (texture(picture, place - 0.5 * along) + texture(picture, place + 0.5 * along));
  float wide = bright(far);
  colour = wide < least || wide > most ? near : far; // the far ones lie beyond the edge
}
`;

/** The columns of a canvas of `width` pixels that a part of it (shares of its width, left to right) lies in: first, and past the last. */
export function wholeColumns([from, to]: readonly [number, number], width: number): [number, number] {
  const inside = (at: number): number => Math.min(width, Math.max(0, at));
  return [inside(STEP * Math.floor((from * width) / STEP)), inside(STEP * Math.ceil((to * width) / STEP))];
}

/** Draws scenes on a canvas that has one sample a pixel itself, so that a level of quality chooses how its edges are made. */
export class EdgeSmoothing {
  private readonly camera = new THREE.Camera();
  private readonly target = new THREE.WebGLRenderTarget(1, 1, { generateMipmaps: false, samples: SAMPLES });
  private readonly size = new THREE.Vector2();
  private readonly picture: THREE.IUniform<THREE.Texture | null> = { value: null };
  private readonly place = { whole: { value: this.size }, left: { value: 0 }, texel: { value: new THREE.Vector2() } };
  private readonly uniforms = { picture: this.picture, ...this.place };
  private readonly sampled = fullscreenTriangle(coveringMaterial(SAMPLED_FRAGMENT, this.uniforms));
  private readonly smoothed = new THREE.Mesh(
    new THREE.BufferGeometry().setIndex([0, 1, 2, 2, 1, 3]),
    coveringMaterial(COLUMNS_FRAGMENT, this.uniforms, COLUMNS_VERTEX),
  );
  private copy: THREE.FramebufferTexture | undefined;

  constructor(private readonly renderer: THREE.WebGLRenderer) {
    this.target.resolveDepthBuffer = false;
    this.smoothed.frustumCulled = false;
  }

  /**
   * Draws a scene on the canvas; `multisample`: from several samples a pixel, else smoothed afterwards in a part of its
   * columns alone (shares of its width): on a software renderer, what is smoothed costs as much as what is drawn.
   */
  render(scene: THREE.Scene, camera: THREE.Camera, multisample: boolean, part: readonly [number, number]): void {
    this.renderer.getDrawingBufferSize(this.size);
    if (multisample) this.sample(scene, camera);
    else {
      this.renderer.render(scene, camera);
      this.smooth(wholeColumns(part, this.size.x));
    }
  }

  dispose(): void {
    this.target.dispose();
    this.copy?.dispose();
  }

  private sample(scene: THREE.Scene, camera: THREE.Camera): void {
    const { renderer, target, size } = this;
    target.setSize(size.x, size.y);
    renderer.setRenderTarget(target);
    renderer.render(scene, camera);
    renderer.setRenderTarget(null);
    this.picture.value = target.texture;
    this.lay(this.sampled);
  }

  private smooth([first, end]: [number, number]): void {
    if (end <= first) return;
    const { place, size, renderer } = this;
    const copy = this.copyOf(end - first, size.y);
    renderer.copyFramebufferToTexture(copy, new THREE.Vector2(first, 0));
    this.picture.value = copy;
    place.left.value = first;
    place.texel.value.set(1 / (end - first), 1 / size.y);
    this.lay(this.smoothed);
  }

  /** Draws over what the canvas shows. */
  private lay(mesh: THREE.Mesh): void {
    this.renderer.autoClear = false;
    this.renderer.render(mesh, this.camera);
    this.renderer.autoClear = true;
  }

  private copyOf(width: number, height: number): THREE.FramebufferTexture {
    const { copy } = this;
    if (copy?.image.width === width && copy.image.height === height) return copy;
    copy?.dispose();
    this.copy = framebufferTexture(width, height);
    return this.copy;
  }
}
