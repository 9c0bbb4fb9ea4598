/** Draws a scene with smooth edges: by samples, or after it has been drawn. */

import * as THREE from "three";
import { FULLSCREEN_VERTEX, fullscreenTriangle } from "./renderer";

/** Samples of a pixel where edges are drawn from several. */
const SAMPLES = 4;

/**
 * Fast approximate antialiasing (T. Lottes, "FXAA", 2009), in its short form: where the four diagonal neighbours differ,
 * the picture is blurred along the edge that they show. Green and red stand for brightness; alpha is smoothed too.
 */
const FRAGMENT = `
precision highp float;
precision highp sampler2D;
uniform sampler2D picture;
in vec2 place;
out vec4 colour;

float bright(vec4 at) { return at.g + 0.5 * at.r + 0.25 * at.a; } // alpha: so that a dark head on nothing has an edge too

void main() {
#ifdef SAMPLED
  colour = texelFetch(picture, ivec2(gl_FragCoord.xy), 0);
#else
  ivec2 here = ivec2(gl_FragCoord.xy);
  ivec2 last = textureSize(picture, 0) - 1;
  ivec2 low = max(here - 1, ivec2(0)), high = min(here + 1, last);
  float lowLeft = bright(texelFetch(picture, low, 0));
  float lowRight = bright(texelFetch(picture, ivec2(high.x, low.y), 0));
  float highLeft = bright(texelFetch(picture, ivec2(low.x, high.y), 0));
  float highRight = bright(texelFetch(picture, high, 0));
  colour = texelFetch(picture, here, 0);
  float own = bright(colour);
  float least = min(own, min(min(lowLeft, lowRight), min(highLeft, highRight)));
  float most = max(own, max(max(lowLeft, lowRight), max(highLeft, highRight)));
  if (most - least < 0.04 + 0.10 * most) return;
  vec2 along = vec2(highLeft + highRight - lowLeft - lowRight, lowLeft + highLeft - lowRight - highRight);
  along /= min(abs(along.x), abs(along.y)) + max(0.03 * (lowLeft + lowRight + highLeft + highRight), 0.01);
  along = clamp(along, -6.0, 6.0) / vec2(last + 1);
  vec4 near = 0.5 * (texture(picture, place - along / 6.0) + texture(picture, place + along / 6.0));
  vec4 far = 0.5 * near + 0.25 * (texture(picture, place - 0.5 * along) + texture(picture, place + 0.5 * along));
  float wide = bright(far);
  colour = wide < least || wide > most ? near : far; // the far ones lie beyond the edge
#endif
}
`;

/** Draws scenes on a canvas that has one sample a pixel itself, so that a level of quality chooses how its edges are made. */
export class EdgeSmoothing {
  private readonly scene = new THREE.Scene();
  private readonly camera = new THREE.Camera();
  private readonly target = new THREE.WebGLRenderTarget(1, 1, { generateMipmaps: false, resolveDepthBuffer: false });
  private readonly size = new THREE.Vector2();
  private readonly looks = { sampled: this.look({ SAMPLED: "" }), smoothed: this.look({}) };
  private readonly sheet = fullscreenTriangle();

  constructor(private readonly renderer: THREE.WebGLRenderer) {
    this.scene.add(this.sheet);
  }

  /** Draws a scene on the canvas; `multisample`: from several samples a pixel, else smoothed afterwards. */
  render(scene: THREE.Scene, camera: THREE.Camera, multisample: boolean): void {
    const { renderer, target, size } = this;
    renderer.getDrawingBufferSize(size);
    target.setSize(size.x, size.y);
    const samples = multisample ? SAMPLES : 0;
    if (target.samples !== samples) target.dispose(); // made anew when it is drawn into
    target.samples = samples;
    this.sheet.material = multisample ? this.looks.sampled : this.looks.smoothed;
    renderer.setRenderTarget(target);
    renderer.render(scene, camera);
    renderer.setRenderTarget(null);
    renderer.autoClear = false; // the sheet covers all
    renderer.render(this.scene, this.camera);
    renderer.autoClear = true;
  }

  dispose(): void {
    this.target.dispose();
  }

  private look(defines: Record<string, string>): THREE.RawShaderMaterial {
    return new THREE.RawShaderMaterial({
      glslVersion: THREE.GLSL3,
      vertexShader: FULLSCREEN_VERTEX,
      fragmentShader: FRAGMENT,
      defines,
      uniforms: { picture: { value: this.target.texture } },
      depthTest: false,
      depthWrite: false,
      blending: THREE.NoBlending,
    });
  }
}
