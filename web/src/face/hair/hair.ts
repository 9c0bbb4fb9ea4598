/** Draws the hair of the faces on air as instanced ribbons. */

import * as THREE from "three";
import type { Library } from "../../link/assets";
import type { HairStrands } from "../../link/strands";
import type { Anatomy } from "../anatomy/anatomy";
import { material } from "../gpu/renderer";
import type { HeadUniforms } from "../head/head";
import { definesOf, type Features } from "../quality/quality_levels";
import { type ActiveStyle, HairAssignment } from "./hair_assignment";
import { HAIR_FRAGMENT, HAIR_VERTEX } from "./hair_shaders";
import { drawnStrands } from "./hair_strands";

/** Pieces of a ribbon where its course is drawn round, where all ribbons are drawn, and where few are. */
const PIECES = { round: 20, fine: 11, coarse: 5 };

/** Edges by samples: alpha says how many of a pixel's samples a fibre covers; the picture's own alpha only grows. */
const SOFT = {
  alphaToCoverage: true,
  blendDst: THREE.ZeroFactor,
  blendSrcAlpha: THREE.OneFactor,
  blendDstAlpha: THREE.OneFactor,
};

/** Thin ribbons that follow each strand where hair is drawn in detail, and how wide each is, of the whole. */
const KIN = { count: 3, width: 0.62 };

type StyleUniforms = Record<"strands" | "shape", THREE.IUniform<THREE.DataTexture>> &
  Record<"stations" | "width", THREE.IUniform<number>> & { tint: THREE.IUniform<THREE.Color> };

/** The hair on stage: a mesh of ribbons for each style that is here, in every head that is being drawn. */
export class Hair {
  private readonly assignment: HairAssignment;
  private readonly uniforms = new Map<string, StyleUniforms>();
  private readonly heads = new Map<THREE.Group, { shared: HeadUniforms; features: Features }>();
  private readonly tint: THREE.IUniform<THREE.Color> = { value: new THREE.Color() };
  private readonly versions = new Map<string, number>();
  private readonly colours = new Map<string, THREE.Color>();

  /** `positions`, `traits`: of the face that styles are made on. */
  constructor(
    private readonly library: Library,
    { positions, traits }: Pick<Anatomy, "positions" | "traits">,
  ) {
    this.assignment = new HairAssignment(library, positions, (row) => traits[4 * row + 2] ?? 0);
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

  /** Puts hair on a head that is drawn at a level; styles that come later join it. */
  on(head: THREE.Group, shared: HeadUniforms, features: Features): void {
    this.heads.set(head, { shared, features });
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

  private update(): void {
    this.mixTint();
    for (const style of this.assignment.worn.values()) {
      const own = this.uniformsOf(style);
      this.write(style, own);
      for (const [head, { shared, features }] of this.heads) {
        const mesh = head.getObjectByName(style.name) ?? ribbons(style, shared, own, features);
        if (mesh.parent === null) head.add(mesh);
        mesh.visible = style.grown > 0;
      }
    }
  }

  /** All styles take the mixed colour, so that one passes into the other as one head of hair. */
  private mixTint(): void {
    const { wearers } = this.assignment;
    const total = [...wearers.values()].reduce((sum, weight) => sum + weight, 0);
    if (total <= 0) return;
    this.tint.value.setRGB(0, 0, 0);
    for (const [face, weight] of wearers) {
      const { r, g, b } = this.colour(face);
      const { value } = this.tint;
      value.setRGB(value.r + (r * weight) / total, value.g + (g * weight) / total, value.b + (b * weight) / total);
    }
  }

  private colour(face: string): THREE.Color {
    const known = this.colours.get(face);
    if (known !== undefined) return known;
    const colour = new THREE.Color().setStyle(this.library.faces.get(face)?.look.hair ?? "#000000");
    this.colours.set(face, colour);
    return colour;
  }

  private write(style: ActiveStyle, into: StyleUniforms): void {
    if (this.versions.get(style.name) === style.version) return;
    this.versions.set(style.name, style.version);
    into.strands.value.needsUpdate = true;
  }

  private uniformsOf(style: ActiveStyle): StyleUniforms {
    const known = this.uniforms.get(style.name) ?? styleUniforms(style, this.tint);
    this.uniforms.set(style.name, known);
    return known;
  }
}

function styleUniforms({ hair, strands }: ActiveStyle, tint: THREE.IUniform<THREE.Color>): StyleUniforms {
  const count = hair.anchors.length;
  const shape = new Uint8Array(4 * count * hair.stations);
  for (let place = 0; place < count * hair.stations; place++) {
    for (let axis = 0; axis < 3; axis++) shape[4 * place + axis] = (hair.facing[3 * place + axis] as number) + 128;
    shape[4 * place + 3] = hair.light[place] as number;
  }
  return {
    strands: { value: texture(strands, hair.stations, count, THREE.FloatType) },
    shape: { value: texture(shape, hair.stations, count, THREE.UnsignedByteType) },
    stations: { value: hair.stations },
    width: { value: hair.width },
    tint,
  };
}

function texture(
  data: Float32Array | Uint8Array,
  width: number,
  height: number,
  type: THREE.TextureDataType,
): THREE.DataTexture {
  const made = new THREE.DataTexture(data as Uint8Array<ArrayBuffer>, width, height, THREE.RGBAFormat, type);
  made.needsUpdate = true;
  return made;
}

/** Fewer ribbons are wider, so that they cover the head as all of them do. */
function ribbons(style: ActiveStyle, shared: HeadUniforms, own: StyleUniforms, features: Features): THREE.Mesh {
  const kin = features.detail ? KIN.count : 1;
  const geometry = ribbon(style.hair, piecesOf(features), kin);
  const count = drawnStrands(style.hair, features.hair);
  const share = count / style.hair.anchors.length;
  geometry.instanceCount = kin * count;
  const look = material(HAIR_VERTEX, HAIR_FRAGMENT, {
    ...shared,
    ...own,
    width: { value: (style.hair.width / 2) * share ** -0.6 * (features.detail ? KIN.width : 1) },
  });
  look.defines = { ...definesOf(features), KIN: kin, ...(features.multisample ? { SOFT: "" } : {}) };
  look.side = THREE.DoubleSide;
  Object.assign(look, features.multisample ? SOFT : { blending: THREE.NoBlending });
  const mesh = new THREE.Mesh(geometry, look);
  mesh.name = style.name;
  mesh.frustumCulled = false;
  mesh.castShadow = true;
  return mesh;
}

function piecesOf(features: Features): number {
  if (features.detail) return PIECES.round;
  return features.hair < 0.5 ? PIECES.coarse : PIECES.fine;
}

function ribbon(hair: HairStrands, pieces: number, kin: number): THREE.InstancedBufferGeometry {
  const geometry = new THREE.InstancedBufferGeometry();
  const place: number[] = [];
  const index: number[] = [];
  for (let piece = 0; piece <= pieces; piece++) {
    place.push(-1, piece / pieces, 1, piece / pieces);
    const first = 2 * piece;
    if (piece < pieces) index.push(first, first + 1, first + 2, first + 2, first + 1, first + 3);
  }
  geometry.setIndex(index);
  geometry.setAttribute("place", new THREE.Float32BufferAttribute(place, 2));
  geometry.setAttribute("source", new THREE.InstancedBufferAttribute(Float32Array.from(hair.anchors), 1, false, kin));
  return geometry;
}
