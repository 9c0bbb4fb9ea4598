/** Draws the stage's hair and collar on a face of the atlas, in the light that goes with the camera. */

import * as THREE from "three";
import type { Anatomy } from "../../../face/anatomy/anatomy";
import { material } from "../../../face/gpu/renderer";
import { ribbons, type StyleUniforms, styleUniforms } from "../../../face/hair/hair_geometry";
import { fullStrands, offsetsOn } from "../../../face/hair/hair_strands";
import { COLLAR_FRAGMENT, COLLAR_VERTEX, collar } from "../../../face/head/collar";
import { type HeadUniforms, headUniforms } from "../../../face/head/head";
import { writeLight } from "../../../face/light/light_uniforms";
import { LIGHTS, type Light, lightAlong } from "../../../face/light/lights";
import { definesOf, FEATURES, type Features } from "../../../face/quality/quality_levels";
import type { HairStrands } from "../../../link/strands";
import type { Camera } from "../math/camera";
import type { FaceAtlas } from "./face_atlas";
import type { PixelBox } from "./face_painter";

/** Hair as one face wears it. */
export interface FaceHair {
  readonly mesh: THREE.Mesh;
  readonly uniforms: StyleUniforms;
}

/** A face in the atlas, and its hair where it has any. */
export interface HairedFace {
  readonly block: number;
  readonly hair: FaceHair | undefined;
}

/** Where is drawn: a framebuffer (null: the canvas), the face's box in it, and what of it changes. */
export interface Target {
  readonly framebuffer: WebGLFramebuffer | null;
  readonly box: PixelBox;
  readonly part: PixelBox;
}

/** What three's renderer can and its types do not say: a target may be a framebuffer that somebody else made. */
interface FramebufferTaker {
  setRenderTargetFramebuffer(target: THREE.WebGLRenderTarget, framebuffer: WebGLFramebuffer | null): void;
}

/** Colours as they are, and in alpha what is left of the background: samples that are covered leave nothing of it. */
const COVERING = { blendSrcAlpha: THREE.ZeroFactor, blendDstAlpha: THREE.ZeroFactor };

export class HairPainter {
  private readonly renderer: THREE.WebGLRenderer & FramebufferTaker;
  private readonly shared: HeadUniforms;
  private readonly target = new THREE.WebGLRenderTarget(1, 1);
  private readonly camera = new THREE.Camera();
  private readonly still = new THREE.Scene(); // collar and hair: what an expression does not move
  private readonly features: Features;

  constructor(
    private readonly gl: WebGL2RenderingContext,
    private readonly faceAtlas: FaceAtlas,
    private readonly anatomy: Anatomy,
    software: boolean,
  ) {
    this.features = { ...FEATURES[software ? "low" : "good"], shadow: 0, multisample: true };
    const renderer = new THREE.WebGLRenderer({ canvas: gl.canvas as HTMLCanvasElement, context: gl });
    this.renderer = renderer as THREE.WebGLRenderer & FramebufferTaker;
    this.renderer.autoClear = false;
    this.shared = headUniforms(faceAtlas.positions, faceAtlas.normals);
    this.camera.matrixWorldAutoUpdate = false;
    const cloth = material(COLLAR_VERTEX, COLLAR_FRAGMENT, this.shared);
    if (anatomy.rim.length > 0) this.still.add(this.dressed(new THREE.Mesh(collar(anatomy), cloth)));
    for (const part of this.still.children) part.frustumCulled = false;
    this.renderer.resetState();
  }

  /** Hair of a style as a face (rest: (rows, 3) metres) wears it. */
  make(name: string, hair: HairStrands, rest: Float32Array, colour: string): FaceHair {
    const tint = { value: new THREE.Color().setStyle(colour) };
    const style = { name, hair, strands: fullStrands(hair, offsetsOn(hair, this.anatomy.positions, rest)) };
    const uniforms = styleUniforms(style, tint);
    return { mesh: this.dressed(ribbons(style, this.shared, uniforms, this.features)), uniforms };
  }

  /** Frees what `make` made. */
  drop({ mesh, uniforms }: FaceHair): void {
    mesh.geometry.dispose();
    (mesh.material as THREE.Material).dispose();
    for (const { value } of [uniforms.strands, uniforms.shape]) value.dispose();
  }

  /** Draws collar and hair: colours as they are, in alpha what is left of the background. */
  draw({ block, hair }: HairedFace, camera: Camera, target: Target): void {
    const { renderer } = this;
    this.shared.firstLine.value = block * this.faceAtlas.lines;
    this.look(camera);
    this.aim(target);
    if (hair !== undefined) this.still.add(hair.mesh);
    renderer.resetState();
    renderer.setRenderTarget(this.target);
    renderer.render(this.still, this.camera);
    renderer.resetState();
    hair?.mesh.removeFromParent();
    this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, target.framebuffer);
  }

  dispose(): void {
    this.renderer.dispose();
  }

  private look({ projection, view, right, up, back, eye }: Camera): void {
    this.camera.projectionMatrix.copy(projection);
    this.camera.projectionMatrixInverse.copy(projection).invert();
    this.camera.matrixWorldInverse.copy(view);
    this.camera.matrixWorld.copy(view).invert();
    this.shared.viewPoint.value.fromArray(eye);
    writeLight(lightAlong(LIGHTS.portrait as Light, [right, up, back]), this.shared);
  }

  private aim({ framebuffer, box, part }: Target): void {
    this.renderer.setRenderTargetFramebuffer(this.target, framebuffer);
    this.target.viewport.set(...box);
    this.target.scissor.set(...part);
    this.target.scissorTest = true;
  }

  private dressed(mesh: THREE.Mesh): THREE.Mesh {
    const look = mesh.material as THREE.RawShaderMaterial;
    look.defines = { ...definesOf(this.features), ...look.defines };
    Object.assign(look, COVERING);
    return mesh;
  }
}
