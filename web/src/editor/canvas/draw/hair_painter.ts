/** Draws what the stage draws of a head beside its skin: hair, collar and lashes, in the editor's light. */

import * as THREE from "three";
import type { Anatomy } from "../../../face/anatomy/anatomy";
import { material } from "../../../face/gpu/renderer";
import { ribbons, type StyleUniforms, styleUniforms } from "../../../face/hair/hair_ribbons";
import { fullStrands, offsetsOn } from "../../../face/hair/hair_strands";
import { COLLAR_FRAGMENT, COLLAR_VERTEX, collar } from "../../../face/head/collar";
import { type HeadUniforms, headUniforms } from "../../../face/head/head";
import { lashes } from "../../../face/head/lashes";
import { writeLight } from "../../../face/light/light_uniforms";
import { LIGHTS, type Light } from "../../../face/light/lights";
import type { Triple } from "../../../face/light/tone";
import { definesOf, FEATURES, type Features } from "../../../face/quality/quality_levels";
import type { Look } from "../../../link/messages";
import type { HairStrands } from "../../../link/strands";
import type { Camera } from "../math/camera";
import type { FaceAtlas } from "./face_atlas";
import type { PixelBox } from "./face_painter";

/** Hair as one face wears it. */
export interface FaceHair {
  readonly mesh: THREE.Mesh;
  readonly uniforms: StyleUniforms;
}

/** A face in the atlas, its look, and its hair where it has any. */
export interface HairedFace {
  readonly block: number;
  readonly look: Look;
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
  private readonly lashes = new THREE.Scene();
  private readonly features: Features;

  constructor(
    private readonly gl: WebGL2RenderingContext,
    private readonly faceAtlas: FaceAtlas,
    private readonly anatomy: Anatomy,
    software: boolean,
  ) {
    this.features = { ...FEATURES[software ? "low" : "medium"], shadow: 0, multisample: true };
    const renderer = new THREE.WebGLRenderer({ canvas: gl.canvas as HTMLCanvasElement, context: gl });
    this.renderer = renderer as THREE.WebGLRenderer & FramebufferTaker;
    this.renderer.autoClear = false;
    this.shared = headUniforms(faceAtlas.positions, faceAtlas.normals);
    this.camera.matrixWorldAutoUpdate = false;
    const cloth = material(COLLAR_VERTEX, COLLAR_FRAGMENT, this.shared);
    if (anatomy.rim.length > 0) this.still.add(this.dressed(new THREE.Mesh(collar(anatomy), cloth)));
    const grown = lashes(anatomy, this.shared);
    if (grown !== undefined) this.lashes.add(grown);
    for (const scene of [this.still, this.lashes]) for (const part of scene.children) part.frustumCulled = false;
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
  drawHair(face: HairedFace, camera: Camera, target: Target): void {
    if (face.hair !== undefined) this.still.add(face.hair.mesh);
    this.draw(this.still, face, camera, target);
    face.hair?.mesh.removeFromParent();
  }

  /** Draws lashes over skin and eyes. */
  drawLashes(face: HairedFace, camera: Camera, target: Target): void {
    this.draw(this.lashes, face, camera, target);
  }

  dispose(): void {
    this.renderer.dispose();
  }

  private draw(scene: THREE.Scene, { block, look }: HairedFace, camera: Camera, target: Target): void {
    const { renderer, shared } = this;
    shared.firstLine.value = block * this.faceAtlas.lines;
    shared.lashes.value = look.lashes;
    shared.brow.value.setStyle(look.brow);
    this.look(camera);
    this.aim(target);
    renderer.resetState();
    renderer.setRenderTarget(this.target);
    renderer.render(scene, this.camera);
    renderer.resetState();
    this.gl.bindFramebuffer(this.gl.FRAMEBUFFER, target.framebuffer);
  }

  private look({ projection, stand, right, up, back }: Camera): void {
    this.camera.projectionMatrix.copy(projection);
    this.camera.projectionMatrixInverse.copy(projection).invert();
    this.camera.matrixWorld.copy(stand);
    this.camera.matrixWorldInverse.copy(stand).invert();
    writeLight(turned(LIGHTS.portrait as Light, right, up, back), this.shared);
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

/** A light that goes with the camera: what it has from the right, from above and from ahead. */
function turned(light: Light, right: Triple, up: Triple, back: Triple): Light {
  const from = ([x, y, z]: Triple): Triple =>
    [0, 1, 2].map(
      (axis) => x * (right[axis] as number) + y * (up[axis] as number) + z * (back[axis] as number),
    ) as unknown as Triple;
  const { key, fill, rims } = light;
  return {
    ...light,
    key: { ...key, from: from(key.from) },
    fill: { ...fill, from: from(fill.from) },
    rims: { ...rims, left: from(rims.left), right: from(rims.right) },
  };
}
