/** Teeth and tongue. */

import * as THREE from "three";
import type { Mesh } from "../../link/assets";
import { ARCH, ARCH_DEPTH, TOOTH_REACH } from "../../link/constants";
import type { Anatomy } from "../anatomy/anatomy";
import { type Opening, opening, outline } from "../anatomy/openings";
import { extent } from "../anatomy/topology";
import { COVERAGE, material, type Uniforms } from "../gpu/renderer";
import type { Features } from "../quality/quality_levels";
import { edgeUniforms } from "./eyeballs";
import { TEETH_FRAGMENT, TEETH_VERTEX } from "./mouth_shaders";
import type { Cages, Column } from "./teeth_cage";
import { SHEET_FRAGMENT, SHEET_VERTEX } from "./teeth_shaders";
import { type Sheet, teethSheet } from "./teeth_sheet";
import { tongueParts } from "./tongue";

/** Teeth or tongue, lit through the lips. */
export function mouthParts(
  geometry: THREE.BufferGeometry,
  mesh: Mesh,
  anatomy: Anatomy,
  cages: Cages,
  uniforms: Uniforms,
  features: Features,
): THREE.Mesh[] {
  const lit = { ...uniforms, ...edgeUniforms(lips(mesh, anatomy)) };
  if (mesh.name === "tongue") return tongueParts(geometry, mesh, anatomy, cages, lit, features);
  const upper = mesh.name === "teeth_upper";
  const cage = upper ? cages.upper : cages.lower;
  if (cage === undefined || !features.detail) return [strip(geometry, mesh, anatomy, lit, features)];
  return [sheetPart(teethSheet(cage, anatomy.positions, upper), cage, lit)];
}

/** Teeth as the cast has them. */
function strip(
  geometry: THREE.BufferGeometry,
  mesh: Mesh,
  anatomy: Anatomy,
  uniforms: Uniforms,
  { multisample }: Features,
): THREE.Mesh {
  geometry.setAttribute("place", new THREE.BufferAttribute(places(mesh, anatomy.positions), 4));
  const look = material(TEETH_VERTEX, TEETH_FRAGMENT, uniforms);
  look.side = THREE.DoubleSide;
  if (multisample) Object.assign(look, COVERAGE, { defines: { SOFT: "" } });
  return new THREE.Mesh(geometry, look);
}

/** Teeth, gums and palate or floor in the cage of a jaw. */
function sheetPart(sheet: Sheet, columns: readonly Column[], uniforms: Uniforms): THREE.Mesh {
  const geometry = new THREE.BufferGeometry();
  geometry.setIndex(new THREE.BufferAttribute(sheet.triangles, 1));
  const put = (name: string, values: Float32Array) => geometry.setAttribute(name, new THREE.BufferAttribute(values, 3));
  for (const whose of ["person", "milk", "carnivore"] as const) {
    put(`${whose}Place`, sheet[whose].places);
    put(`${whose}Facing`, sheet[whose].facings);
  }
  geometry.setAttribute("marks", new THREE.BufferAttribute(sheet.marks, 4));
  const look = material(SHEET_VERTEX, SHEET_FRAGMENT, {
    ...uniforms,
    cage: { value: Int32Array.from(columns.flat()) },
  });
  look.side = THREE.DoubleSide;
  return new THREE.Mesh(geometry, look);
}

/** The lips' edges; where the cast names none the part's own outline, so that light comes in. */
function lips(mesh: Mesh, anatomy: Anatomy): Opening {
  const line = anatomy.lines.get("lips") ?? outline([...mesh.source], anatomy.positions);
  return opening([...line], anatomy.positions);
}

/** Where each vertex of a part lies: depth behind its front (0..1), angle on the arch, height from gum to edge, jaw. */
export function places(mesh: Mesh, positions: Float32Array): Float32Array {
  const at = (row: number, axis: number) => positions[3 * row + axis] as number;
  const [, ahead] = extent(positions, 2, mesh.source);
  const rows = [...mesh.source];
  const angles = rows.map((row) => Math.atan2(at(row, 0), at(row, 2) - ahead + ARCH));
  const upper = mesh.name === "teeth_upper" ? 1 : 0;
  const out = new Float32Array(4 * rows.length);
  rows.forEach((row, index) => {
    const angle = angles[index] as number;
    const beside = rows
      .filter((_, other) => Math.abs((angles[other] as number) - angle) < TOOTH_REACH)
      .map((neighbour) => at(neighbour, 1));
    const [low, high] = [Math.min(...beside), Math.max(...beside)];
    const level = high > low ? (at(row, 1) - low) / (high - low) : 0;
    out.set([(ahead - at(row, 2)) / ARCH_DEPTH, angle, upper ? 1 - level : level, upper], 4 * index);
  });
  return out;
}
