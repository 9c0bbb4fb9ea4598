/** The shadow map of the key light. */

import * as THREE from "three";
import { material } from "../gpu/renderer";
import type { Light } from "./lights";
import { DEPTH, HEIGHT_FRAGMENT, REACH } from "./shadow_shaders";

/** The key of a geometry's user data that holds the triangles which cast a shadow, where not all do. */
export const CASTING = "casting";

/** The middle of the head and its neck, metres, where nothing carries the head elsewhere. */
export const SHADOW_CENTRE = new THREE.Vector3(0, -0.02, 0.03);
/** From the shadow's camera to the middle, metres. */
const AWAY = 0.3;
const UPRIGHT = new THREE.Vector3(0, 1, 0);
/** Metres a pixel is wide one metre from the lamp, for what is drawn no narrower than its pixels: a stage of 720 lines has
 * about this. Were it the picture's own, a shadow would wait a frame for it, and the first would differ from all others. */
const PIXEL = 0.0005;

/** What `shadow` in the shaders reads; the pictures stay empty where no shadow is drawn. */
export const shadowUniforms = () => ({
  shadowHeights: { value: null } as THREE.IUniform<THREE.Texture | null>,
  shadowDepths: { value: null } as THREE.IUniform<THREE.Texture | null>,
  shadowCentre: { value: SHADOW_CENTRE.clone() },
  shadowSide: { value: new THREE.Vector3(1, 0, 0) },
  shadowUp: { value: UPRIGHT.clone() },
  KEY_SIZE: { value: 0.05 },
});

export type ShadowUniforms = ReturnType<typeof shadowUniforms>;

/** The head as the key light sees it; every mesh with `castShadow` stands in the light. */
export class Shadow {
  private readonly target: THREE.WebGLRenderTarget;
  private readonly camera = new THREE.OrthographicCamera(
    -REACH,
    REACH,
    REACH,
    -REACH,
    AWAY - DEPTH / 2,
    AWAY + DEPTH / 2,
  );
  private readonly scene = new THREE.Scene();

  private drawn = false;
  private readonly casters = new Map<THREE.Mesh, THREE.Mesh>();

  constructor(private readonly uniforms: ShadowUniforms) {
    const depths = new THREE.DepthTexture(1, 1, THREE.UnsignedIntType);
    depths.compareFunction = THREE.LessEqualCompare;
    depths.minFilter = depths.magFilter = THREE.LinearFilter;
    this.target = new THREE.WebGLRenderTarget(1, 1, {
      format: THREE.RedFormat,
      type: THREE.FloatType,
      minFilter: THREE.NearestFilter,
      magFilter: THREE.NearestFilter,
      depthTexture: depths,
    });
    uniforms.shadowHeights.value = this.target.texture;
    uniforms.shadowDepths.value = depths;
  }

  /** Draws the shadow map of this light for the head as it is now, `size` texels along a side; 0: none. */
  draw(renderer: THREE.WebGLRenderer, light: Light, head: THREE.Object3D, size: number): void {
    const dark = Math.max(...light.key.colour) <= 0;
    if (size === 0 || (dark && this.drawn)) return; // nobody asks, but the shaders want to hold a map
    this.drawn = true;
    this.target.setSize(size, size);
    this.look(light);
    this.gather(head);
    renderer.setRenderTarget(this.target);
    renderer.render(this.scene, this.camera);
    renderer.setRenderTarget(null);
  }

  private look({ key, size }: Light): void {
    this.camera.position
      .set(...key.direction)
      .multiplyScalar(AWAY)
      .add(this.uniforms.shadowCentre.value);
    this.camera.lookAt(this.uniforms.shadowCentre.value);
    this.camera.updateMatrixWorld();
    this.uniforms.shadowSide.value.setFromMatrixColumn(this.camera.matrixWorld, 0);
    this.uniforms.shadowUp.value.setFromMatrixColumn(this.camera.matrixWorld, 1);
    this.uniforms.KEY_SIZE.value = size;
  }

  /** Takes what came onto the head into the light, and what left it out. */
  private gather(head: THREE.Object3D): void {
    const standing = new Set<THREE.Mesh>();
    head.traverse((part) => {
      if (part instanceof THREE.Mesh && part.castShadow && part.visible) standing.add(part);
    });
    for (const [mesh, drawn] of this.casters)
      if (!standing.has(mesh)) {
        this.scene.remove(drawn);
        (drawn.material as THREE.Material).dispose();
        if (drawn.geometry !== mesh.geometry) drawn.geometry.dispose();
        this.casters.delete(mesh);
      }
    for (const mesh of standing)
      if (!this.casters.has(mesh)) {
        const drawn = caster(mesh, this.camera.position);
        this.casters.set(mesh, drawn);
        this.scene.add(drawn);
      }
  }

  dispose(): void {
    this.target.dispose();
    this.target.depthTexture?.dispose();
  }
}

/**
 * The same mesh, moved by the same vertex shader as the lamp sees it, that leaves its height instead of its colour. It
 * must not read the shadow map, as hair does at its vertices: WebGL draws nothing that reads what it is drawn into.
 */
function caster(mesh: THREE.Mesh, lamp: THREE.Vector3): THREE.Mesh {
  const look = mesh.material as THREE.RawShaderMaterial;
  const { SHADOW: _, ...defines } = look.defines ?? {};
  const depth = material(look.vertexShader, HEIGHT_FRAGMENT, {
    ...look.uniforms,
    viewPoint: { value: lamp },
    ...("pixel" in look.uniforms ? { pixel: { value: PIXEL } } : {}),
  });
  depth.defines = { ...defines, ...("strands" in look.uniforms ? { STRANDS: "" } : {}) };
  depth.side = THREE.DoubleSide;
  const drawn = new THREE.Mesh(castingOf(mesh.geometry), depth);
  drawn.frustumCulled = false;
  return drawn;
}

/** The geometry with those triangles alone that cast a shadow. */
function castingOf(geometry: THREE.BufferGeometry): THREE.BufferGeometry {
  const triangles = geometry.userData[CASTING] as THREE.BufferAttribute | undefined;
  if (triangles === undefined) return geometry;
  const casting = new THREE.BufferGeometry();
  for (const [name, attribute] of Object.entries(geometry.attributes)) casting.setAttribute(name, attribute);
  return casting.setIndex(triangles);
}
