import * as THREE from "three";
import { material } from "../gpu/material";
import type { Light } from "../light/lights";
import { encoded } from "../light/tone";
import { BACKDROP_FRAGMENT, BACKDROP_VERTEX } from "./setting_shaders";

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
    look.depthTest = false;
    look.depthWrite = false;
    this.mesh = new THREE.Mesh(new THREE.BufferGeometry().setIndex([0, 1, 2]), look);
    this.mesh.frustumCulled = false;
    this.mesh.renderOrder = -1;
  }

  /** Where this picture lies in its wall's: the view of `tileView`, pixels. */
  place([fullWidth, fullHeight, left, top, width, height]: readonly [
    number,
    number,
    number,
    number,
    number,
    number,
  ]): void {
    const { window, aspect } = this.uniforms;
    window.value.set(left / fullWidth, 1 - (top + height) / fullHeight, width / fullWidth, height / fullHeight);
    aspect.value = fullWidth / fullHeight;
  }

  /** Takes the colours of a light: exactly, without the film, so that a keyer finds what it was told. */
  light({ backdrop }: Light): void {
    this.uniforms.edge.value.set(...encoded(backdrop.edge));
    this.uniforms.glow.value.set(...encoded(backdrop.glow));
  }
}
