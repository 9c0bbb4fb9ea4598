/** The backdrop behind the head. */

import * as THREE from "three";
import { fullscreenTriangle, material } from "../gpu/renderer";
import type { Light } from "./lights";
import { encodeSrgb } from "./tone";

/** The stage behind the head: one colour at the edge, one around the head, so that the silhouette reads. */
const BACKDROP_VERTEX = `
precision highp float;
uniform vec4 window; // this picture's part of the wall's: left, bottom, width, height
out vec2 vPlace;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0;
  vPlace = window.xy + corner * window.zw;
  gl_Position = vec4(corner * 2.0 - 1.0, 1.0, 1.0); // behind all
}
`;

const BACKDROP_FRAGMENT = `
precision highp float;
uniform float aspect;
uniform vec3 edge;
uniform vec3 glow;
in vec2 vPlace;
out vec4 colour;
void main() {
  vec2 from = (vPlace - vec2(0.5, 0.58)) * vec2(aspect, 1.0);
  vec3 light = mix(edge, glow, exp(-dot(from, from) * 3.2));
  float dither = fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5;
  colour = vec4(light + 0.98 * dither / 255.0, 1.0);
}
`;

/** The view of `tileView`, pixels: whole width and height, left, top, width, height. */
type TileView = readonly [number, number, number, number, number, number];

/** The stage behind the head; it fills the picture. */
export class Backdrop {
  readonly mesh: THREE.Mesh;
  private readonly uniforms = {
    window: { value: new THREE.Vector4(0, 0, 1, 1) },
    aspect: { value: 1 },
    edge: { value: new THREE.Vector3() },
    glow: { value: new THREE.Vector3() },
  };

  constructor() {
    const look = material(BACKDROP_VERTEX, BACKDROP_FRAGMENT, this.uniforms);
    look.depthWrite = false;
    this.mesh = fullscreenTriangle(look);
  }

  /**
   * Draws it first, or where no head is, before the lashes: cheaper, but samples of a pixel that are covered by alpha need
   * it under them.
   */
  get first(): boolean {
    return this.mesh.renderOrder < 0;
  }

  set first(first: boolean) {
    this.mesh.renderOrder = first ? -1 : 0.5;
  }

  /** Where this picture lies in its wall's: the view of `tileView`, pixels. */
  place([fullWidth, fullHeight, left, top, width, height]: TileView): void {
    const { window, aspect } = this.uniforms;
    window.value.set(left / fullWidth, 1 - (top + height) / fullHeight, width / fullWidth, height / fullHeight);
    aspect.value = fullWidth / fullHeight;
  }

  /** Takes the colours of a light: exactly, without the film, so that a keyer finds what it was told. */
  light({ backdrop }: Light): void {
    this.uniforms.edge.value.set(...encodeSrgb(backdrop.edge));
    this.uniforms.glow.value.set(...encodeSrgb(backdrop.glow));
  }
}
