/** Crossfades from the last picture of one level of quality to the next. */

import * as THREE from "three";
import { coveringMaterial, framebufferTexture, fullscreenTriangle } from "./renderer";

const FRAGMENT = `
precision mediump float;
uniform sampler2D before;
in vec2 place;
out vec4 colour;
void main() { colour = texture(before, place); }
`;

/** Seconds in which a picture gives way to its successor. */
const LENGTH = 0.4;
/** Seconds that one frame may take of it: where frames are long, too, there are pictures in between. */
const STEP = LENGTH / 8;

/** The picture of before over the picture of now, less and less: so a change of the level does not pop. */
export class PictureCrossfade {
  private readonly scene = new THREE.Scene();
  private readonly camera = new THREE.Camera();
  private readonly look = Object.assign(coveringMaterial(FRAGMENT, { before: { value: null } }), {
    blending: THREE.CustomBlending, // a mix, alpha too, so that a transparent stage fades as an opaque one does
    blendSrc: THREE.ConstantAlphaFactor,
    blendDst: THREE.OneMinusConstantAlphaFactor,
  });
  private before: THREE.FramebufferTexture | undefined;
  private left = 0;

  constructor(private readonly renderer: THREE.WebGLRenderer) {
    this.scene.add(fullscreenTriangle(this.look));
  }

  /** Keeps the picture that has just been drawn. */
  begin(): void {
    const { x, y } = this.renderer.getDrawingBufferSize(new THREE.Vector2());
    this.before?.dispose();
    this.before = framebufferTexture(x, y); // the successor may have another size
    this.renderer.copyFramebufferToTexture(this.before);
    (this.look.uniforms.before as THREE.IUniform).value = this.before;
    this.left = LENGTH;
  }

  /** Draws what is left of it over the new picture, `seconds` after the last frame. */
  paint(seconds: number): void {
    if (this.before === undefined) return;
    const part = this.left / LENGTH;
    this.look.blendAlpha = part * part * (3 - 2 * part);
    this.renderer.autoClear = false;
    this.renderer.render(this.scene, this.camera);
    this.renderer.autoClear = true;
    this.left -= Math.min(seconds, STEP);
    if (this.left > 0) return;
    this.before.dispose();
    this.before = undefined;
  }

  /** Whether a picture of before still shows. */
  get running(): boolean {
    return this.before !== undefined;
  }
}
