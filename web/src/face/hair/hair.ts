/** Draws the hair of the faces on air as instanced ribbons. */

import * as THREE from "three";
import type { Library } from "../../link/assets";
import type { Anatomy } from "../anatomy/anatomy";
import type { HeadUniforms } from "../head/head";
import type { Features } from "../quality/quality_levels";
import { mixHairColour } from "../skin/scalp";
import { type ActiveStyle, HairAssignment, type HairStock } from "./hair_assignment";
import { ribbons, type StyleUniforms, strandsTexture, styleUniforms } from "./hair_geometry";
import { rootsTexture } from "./hair_roots";
import { drawnStrands } from "./hair_strands";
import { HairSwing } from "./hair_swing";

/** Between styles, in the order of drawing: half way they lie on each other, and who is first shows there. */
const ONE_AFTER_OTHER = 0.01;

/** The hair of a character: a mesh of ribbons for each style that is here, in every head that is being drawn. */
export class Hair {
  private readonly assignment: HairAssignment;
  private readonly uniforms = new Map<string, StyleUniforms>();
  private readonly heads = new Map<THREE.Group, { shared: HeadUniforms; features: Features }>();
  private readonly swing = new HairSwing();
  private readonly swung: THREE.IUniform<THREE.Vector3> = { value: this.swing.offset };
  private readonly tint: THREE.IUniform<THREE.Color> = { value: new THREE.Color() };
  private readonly roots: THREE.DataTexture;
  private rooted = 0;
  private readonly versions = new Map<string, number>();

  /** `positions`: of the face that styles are made on. */
  constructor(
    private readonly library: Library,
    { positions }: Pick<Anatomy, "positions">,
    stock: HairStock,
  ) {
    this.assignment = new HairAssignment(library, positions, stock);
    this.roots = rootsTexture(positions.length / 3);
  }

  /** Fetches the hair of these faces. */
  want(faces: Iterable<string>): void {
    this.assignment.want(faces);
  }

  /** Waits until all hair that was ever wanted has come, or was refused. */
  complete(): Promise<void> {
    return this.assignment.complete();
  }

  /** Whether all hair that was wanted has come, or was refused. */
  get here(): boolean {
    return this.assignment.here;
  }

  /** Whether all hair that was wanted shows in full. */
  get settled(): boolean {
    return this.assignment.settled;
  }

  /** Whether it hangs at rest: a head that lives moves it all the time. */
  get still(): boolean {
    return this.swing.still;
  }

  /** Lets it follow a head that turned so far, `seconds` after the last frame; `atOnce`: it hangs at rest. */
  follow(turn: readonly [number, number, number], seconds: number, atOnce: boolean): void {
    this.swing.follow(turn, seconds, atOnce);
  }

  /** Puts hair on a head that is drawn at a level; styles that come later join it. */
  on(head: THREE.Group, shared: HeadUniforms, features: Features): void {
    this.heads.set(head, { shared, features });
    shared.roots.value = this.roots;
    this.update();
  }

  /** Forgets a head that is drawn no more. */
  drop(head: THREE.Group): void {
    this.heads.delete(head);
  }

  /** Dresses the faces on air, by weight, `seconds` after the last frame; `atOnce`: in full. */
  dress(faces: ReadonlyMap<string, number>, seconds: number, atOnce: boolean): void {
    this.assignment.detail = Math.max(0, ...[...this.heads.values()].map(({ features }) => features.hair));
    this.assignment.dress(faces, seconds, atOnce);
    this.update();
  }

  /** Frees what no other character shares. */
  dispose(): void {
    for (const { strands } of this.uniforms.values()) strands.value.dispose();
    this.roots.dispose();
  }

  private update(): void {
    this.mixTint();
    this.writeRoots();
    for (const [place, style] of [...this.assignment.worn.values()].entries()) {
      const own = this.uniformsOf(style);
      this.write(style, own);
      for (const [head, { shared, features }] of this.heads) {
        const mesh = head.getObjectByName(style.name) ?? ribbons(style, shared, own, features);
        if (mesh.parent === null) head.add(mesh);
        mesh.visible = style.grown > 0;
        mesh.renderOrder = ONE_AFTER_OTHER * (place + 1);
      }
    }
  }

  /** All styles take the mixed colour, so that one passes into the other as one head of hair. */
  private mixTint(): void {
    const looks = [...this.assignment.dressed].flatMap(([face, weight]) => {
      const look = this.library.faces.get(face)?.look;
      return look === undefined ? [] : [[look, weight] as const];
    });
    mixHairColour(looks, this.tint.value);
  }

  private writeRoots(): void {
    if (this.rooted === this.assignment.rooted) return;
    this.rooted = this.assignment.rooted;
    (this.roots.image.data as Float32Array).set(this.assignment.roots);
    this.roots.needsUpdate = true;
  }

  private write(style: ActiveStyle, into: StyleUniforms): void {
    if (this.versions.get(style.name) === style.version) return;
    this.versions.set(style.name, style.version);
    const count = drawnStrands(style.hair, this.assignment.detail);
    if (into.strands.value.image.height === count) into.strands.value.needsUpdate = true;
    else {
      into.strands.value.dispose();
      into.strands.value = strandsTexture(style, count);
    }
  }

  private uniformsOf(style: ActiveStyle): StyleUniforms {
    const uniforms = this.uniforms.get(style.name) ?? styleUniforms(style, this.tint, this.swung);
    this.uniforms.set(style.name, uniforms);
    return uniforms;
  }
}
