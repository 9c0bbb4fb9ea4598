/** Draws the tiles of the canvas: each face with its eyes, lashes, hair and collar, and what lies over the work. */

import * as THREE from "three";
import { framebufferTexture, fullscreenTriangle, material } from "../../../face/gpu/renderer";
import type { DrawnFace } from "../draw/drawn_face";
import type { Box } from "../math/boxes";
import type { Camera } from "../math/camera";
import type { Overlay } from "./overlay";

/** Left, bottom, width and height in pixels. */
type PixelBox = readonly [number, number, number, number];

/** A face in its tile, and what of it is drawn. */
export interface CanvasTile {
  readonly n: number;
  readonly drawn: DrawnFace;
  readonly camera: Camera;
  readonly ground: readonly [number, number, number];
  /** What of the tile changes. */
  readonly part: Box;
  /** No row goes further than so many metres from its base; undefined: the head is drawn whole. */
  readonly reach: number | undefined;
  /** Rises when the face's rows move: hair that was drawn before has stood still since. */
  readonly version: number;
}

/** What a drag does not move, kept as pictures: collar and hair alone, and less what the skin covers. */
interface StillLayers {
  /** What they were made for; other views need others. */
  readonly key: string;
  /** The rows that they were made for, and whether the tile's picture has smooth edges. */
  readonly version: number;
  smooth: boolean;
  readonly behind: THREE.FramebufferTexture;
  readonly before: THREE.FramebufferTexture;
}

/** As far away as depth goes. */
const LAYER_VERTEX = `
void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 1.0, 1.0); }
`;

const LAYER_FRAGMENT = `
precision highp float;
uniform sampler2D layer; // in alpha what is left of what lies under it
uniform vec2 corner; // of the face's box in the picture
uniform vec3 ground;
out vec4 colour;
void main() {
  colour = texelFetch(layer, ivec2(gl_FragCoord.xy - corner), 0);
  colour.rgb += colour.a * ground;
}
`;

const SAMPLES = 4;

export class TilePainter {
  private readonly scene = new THREE.Scene();
  private readonly stillScene = new THREE.Scene();
  private readonly camera = new THREE.Camera();
  /** Several samples a pixel, as large as the largest tile. */
  private readonly target = new THREE.WebGLRenderTarget(1, 1, { samples: SAMPLES, resolveDepthBuffer: false });
  private readonly under = layer({ depthFunc: THREE.AlwaysDepth });
  private readonly over = layer({
    depthTest: false,
    depthWrite: false,
    blending: THREE.CustomBlending,
    blendSrc: THREE.OneFactor,
    blendDst: THREE.SrcAlphaFactor,
    blendSrcAlpha: THREE.ZeroFactor,
    blendDstAlpha: THREE.OneFactor,
  });
  private readonly layers = new Map<number, StillLayers>();

  /** pixels: a box of the page in pixels of the canvas; rough: the canvas itself has one sample a pixel. */
  constructor(
    private readonly renderer: THREE.WebGLRenderer,
    private readonly overlay: Pick<Overlay, "object" | "draw">,
    private readonly pixels: (box: Box) => PixelBox,
    private readonly rough: boolean,
  ) {
    this.camera.matrixWorldAutoUpdate = false;
    this.over.renderOrder = 2; // after heads and their lashes
    this.under.renderOrder = -1;
    this.scene.add(this.under, this.over, overlay.object);
  }

  /** Empties the whole canvas. */
  clear(ground: readonly [number, number, number]): void {
    const { renderer } = this;
    renderer.setRenderTarget(null);
    renderer.setScissorTest(false);
    renderer.setClearColor(new THREE.Color().setRGB(...ground, THREE.SRGBColorSpace), 1);
    renderer.clear();
  }

  /** Draws parts of tiles as a hand moves what is in them: hair stands still, edges are as the canvas has them. */
  drawParts(tiles: readonly CanvasTile[]): void {
    for (const tile of tiles) {
      const layers = this.layersOf(tile);
      this.paint(tile, layers, null, this.pixels(tile.camera.box), this.pixels(tile.part));
      layers.smooth = !this.rough;
    }
  }

  /** Draws a whole tile with smooth edges, and its hair where the face has it now. */
  drawWhole(tile: CanvasTile): void {
    const whole = { ...tile, part: tile.camera.box, reach: undefined };
    const layers = this.layersOf(whole, tile.version);
    const box = this.pixels(tile.camera.box);
    if (this.rough) {
      const own = this.roomFor(box);
      this.paint(whole, layers, this.target, own, own);
      this.aim(null, box, box);
      tell(this.under, this.target.texture, box, [0, 0, 0]);
      this.renderer.render(this.under, this.camera);
    } else this.paint(whole, layers, null, box, box);
    layers.smooth = true;
  }

  /** Whether a tile is as well drawn as can be. */
  finished({ n, version }: Pick<CanvasTile, "n" | "version">): boolean {
    const layers = this.layers.get(n);
    return layers?.smooth === true && layers.version === version;
  }

  dispose(): void {
    this.target.dispose();
    for (const { behind, before } of this.layers.values()) for (const texture of [behind, before]) texture.dispose();
  }

  /** The pictures of a face's collar and hair from where it is seen; with a version, as they are on its rows now. */
  private layersOf(tile: CanvasTile, version?: number): StillLayers {
    const { n, drawn, camera } = tile;
    const cached = this.layers.get(n);
    const box = this.pixels(camera.box);
    const [, , width, height] = box;
    const key = [drawn.source, drawn.dressed, width, height, ...camera.matrix].join();
    if (cached?.key === key && (version ?? cached.version) === cached.version) return cached;
    const fits = cached?.behind.image.width === width && cached.behind.image.height === height;
    if (!fits) for (const texture of [cached?.behind, cached?.before]) texture?.dispose();
    const [behind, before] = fits
      ? [cached.behind, cached.before]
      : [framebufferTexture(width, height), framebufferTexture(width, height)];
    const own = this.roomFor(box);
    this.see(tile);
    drawn.whole(camera);
    this.stillScene.add(drawn.still);
    this.draw(behind, own);
    this.stillScene.add(drawn.mask);
    this.draw(before, own);
    drawn.unmask();
    this.stillScene.clear();
    const layers = { key, version: tile.version, smooth: false, behind, before };
    this.layers.set(n, layers);
    return layers;
  }

  /** Draws what stands still into a layer. */
  private draw(into: THREE.FramebufferTexture, [left, bottom, width, height]: PixelBox): void {
    const { renderer, target } = this;
    this.aim(target, [left, bottom, width, height], [left, bottom, width, height]);
    renderer.setClearColor(0x000000, 1);
    renderer.clear();
    renderer.render(this.stillScene, this.camera);
    const all = new THREE.Box2(new THREE.Vector2(), new THREE.Vector2(width, height));
    renderer.copyTextureToTexture(target.texture, into, all);
  }

  private paint(
    tile: CanvasTile,
    layers: StillLayers,
    target: THREE.WebGLRenderTarget | null,
    box: PixelBox,
    part: PixelBox,
  ): void {
    const { n, drawn, camera, ground, reach } = tile;
    this.see(tile);
    if (reach === undefined) drawn.whole(camera);
    else drawn.only(tile.part, camera, reach);
    tell(this.under, layers.behind, box, ground);
    tell(this.over, layers.before, box, [0, 0, 0]);
    this.overlay.object.visible = n === 0;
    if (n === 0) this.overlay.draw(drawn, camera);
    this.scene.add(drawn.head);
    this.aim(target, box, part);
    this.renderer.render(this.scene, this.camera);
    drawn.head.removeFromParent();
  }

  private see({ drawn, camera }: CanvasTile): void {
    drawn.see(camera);
    this.camera.projectionMatrix.copy(camera.projection);
    this.camera.projectionMatrixInverse.copy(camera.projection).invert();
    this.camera.matrixWorldInverse.copy(camera.view);
    this.camera.matrixWorld.copy(camera.view).invert();
  }

  /** A box of this size in the lower left corner of the target, which becomes as large at least. */
  private roomFor([, , width, height]: PixelBox): PixelBox {
    const { target } = this;
    target.setSize(Math.max(width, target.width), Math.max(height, target.height));
    return [0, 0, width, height];
  }

  /** Draws from now on into a box of the canvas (null) or a target; only what lies in `part` changes. */
  private aim(target: THREE.WebGLRenderTarget | null, box: PixelBox, part: PixelBox): void {
    const { renderer } = this;
    if (target !== null) {
      target.viewport.set(...box);
      target.scissor.set(...part);
      target.scissorTest = true;
    }
    renderer.setRenderTarget(target);
    if (target !== null) return;
    renderer.setViewport(...box);
    renderer.setScissor(...part);
    renderer.setScissorTest(true);
  }
}

function layer(how: THREE.ShaderMaterialParameters): THREE.Mesh<THREE.BufferGeometry, THREE.RawShaderMaterial> {
  const uniforms = {
    layer: { value: null },
    corner: { value: new THREE.Vector2() },
    ground: { value: new THREE.Vector3() },
  };
  return fullscreenTriangle(Object.assign(material(LAYER_VERTEX, LAYER_FRAGMENT, uniforms), how)) as ReturnType<
    typeof layer
  >;
}

function tell(
  { material: { uniforms } }: ReturnType<typeof layer>,
  texture: THREE.Texture,
  [left, bottom]: PixelBox,
  ground: readonly [number, number, number],
): void {
  Object.assign(uniforms.layer as THREE.IUniform, { value: texture });
  uniforms.corner?.value.set(left, bottom);
  uniforms.ground?.value.set(...ground);
}
