/** What lies over a face's skin: lines along it, and needles out of it. */

import * as THREE from "three";
import { material } from "../../../face/gpu/renderer";
import type { HeadUniforms } from "../../../face/head/head";
import { VERTEX_HEAD } from "../../../face/light/shader_prelude";
import type { Triple } from "../math/vectors";
import { SLACK } from "../model/needles";

/** The rows of the face that lies under it. */
export type UnderUniforms = Pick<HeadUniforms, "positions" | "normals">;

/** Lines over the skin: edges of the mesh, muscles. \`lift\`: metres off the skin. */
const LINE_VERTEX = `${VERTEX_HEAD}
uniform float lift;
in vec4 colour;
out vec4 vColour;
void main() {
  vColour = colour;
  gl_Position = project(fetchRow(positions) + lift * fetchRow(normals));
}
`;

const LINE_FRAGMENT = `
precision highp float;
in vec4 vColour;
out vec4 colour;
void main() { colour = vColour; }
`;

/** A needle: a shaft out of the skin and a head on it; corners 0..3 the shaft's, 4..7 the head's. */
const NEEDLE_VERTEX = `${VERTEX_HEAD}
uniform vec2 box; // of the picture, pixels
uniform float long_; // metres
uniform float wide; // pixels of a head's radius
uniform vec3 back;
in vec3 outward; // zero: as the skin points
in vec4 colour;
in float scale;
out vec4 vColour;
out vec2 vDisc;
void main() {
  vec3 foot = fetchRow(positions);
  vec3 way = dot(outward, outward) > 0.0 ? outward : fetchRow(normals);
  vec3 tip = foot + long_ * way;
  vec4 a = project(foot), b = project(tip);
  int corner = gl_VertexID;
  vec2 side = vec2((corner & 1) * 2 - 1, ((corner >> 1) & 1) * 2 - 1);
  vColour = colour;
  if (corner < 4) {
    vec2 along = (b.xy / b.w - a.xy / a.w) * box;
    vec2 across = normalize(vec2(-along.y, along.x) + vec2(1e-6, 0.0));
    gl_Position = side.y < 0.0 ? a : b;
    gl_Position.xy += across * side.x * 1.6 * gl_Position.w / box;
    vColour.rgb *= 0.7;
    vDisc = vec2(0.0);
  } else {
    gl_Position = b;
    gl_Position.xy += side * 2.0 * wide * scale * b.w / box;
    vDisc = side;
  }
  vec4 nearer = project((corner < 4 && side.y < 0.0 ? foot : tip) + ${SLACK} * back); // by so much skin may lie before a needle
  gl_Position.z = nearer.z / nearer.w * gl_Position.w;
}
`;

const NEEDLE_FRAGMENT = `
precision highp float;
in vec4 vColour;
in vec2 vDisc;
out vec4 colour;
void main() {
  float out_ = dot(vDisc, vDisc);
  if (out_ > 1.0) discard;
  float glance = max(0.0, 1.0 - 1.3 * dot(vDisc - vec2(-0.35, 0.4), vDisc - vec2(-0.35, 0.4)));
  vec3 seen = vColour.rgb * (1.0 - 0.45 * out_) + 0.35 * glance * glance;
  colour = vec4(mix(seen, seen * 0.25, smoothstep(0.62, 0.95, out_)), vColour.a);
}
`;

/** Lines between rows, two each, in one colour each (0..1, four numbers a line), `lift` metres off the skin under them. */
export function skinLines(
  rows: readonly number[],
  colours: readonly number[],
  lift: number,
  under: UnderUniforms,
): THREE.LineSegments {
  const geometry = new THREE.BufferGeometry();
  const spread = Float32Array.from({ length: 4 * rows.length }, (_, at) => colours[4 * (at >> 3) + (at & 3)] as number);
  geometry.setAttribute("source", new THREE.Float32BufferAttribute(rows, 1));
  geometry.setAttribute("colour", new THREE.BufferAttribute(spread, 4));
  geometry.setDrawRange(0, rows.length);
  const look = material(LINE_VERTEX, LINE_FRAGMENT, { ...under, lift: { value: lift } });
  Object.assign(look, { depthWrite: false, blending: THREE.NormalBlending, transparent: true });
  const lines = new THREE.LineSegments(geometry, look);
  lines.frustumCulled = false;
  return lines;
}

/** How a needle looks: "still", under the pointer, chosen, taken along by a drag, out of reach of the region. */
export type NeedleState = "still" | "hovered" | "selected" | "taken" | "barred";

const COLOURS: Readonly<Record<NeedleState, readonly [number, number, number, number, number]>> = {
  still: [0.95, 0.93, 0.88, 1, 1],
  hovered: [1, 0.86, 0.42, 1, 1.35],
  selected: [1, 0.62, 0.12, 1, 1.25],
  taken: [0.45, 0.82, 1, 1, 1.1],
  barred: [0.45, 0.45, 0.46, 0.6, 0.8],
};
/** Triangles of a needle's eight corners: shaft and head. */
const CORNERS = [0, 1, 2, 2, 1, 3, 4, 5, 6, 6, 5, 7];
/** The attributes of a needle, and how many numbers each is: together `NUMBERS`. */
const NEEDLE_ATTRIBUTES = { source: 1, outward: 3, colour: 4, scale: 1 };
const NUMBERS = 9;
/** CSS pixels of a head's radius. */
export const HEAD = 4.2;

/** Needles as they are drawn. */
export interface ShownNeedles {
  /** The rows under them. */
  readonly rows: readonly number[];
  readonly states: readonly NeedleState[];
  /** How large each head is; 1: ordinary. */
  readonly scales?: readonly number[];
  /** Where they point. */
  readonly outward: readonly Triple[];
  /** Metres. */
  readonly length: number;
}

/** All needles of a face. */
export class NeedleMesh {
  readonly mesh: THREE.Mesh<THREE.InstancedBufferGeometry, THREE.RawShaderMaterial>;
  private values = new Float32Array();

  constructor(under: UnderUniforms) {
    const values = { box: new THREE.Vector2(), long_: 0, wide: 0, back: new THREE.Vector3() };
    const uniforms = Object.fromEntries(Object.entries(values).map(([name, value]) => [name, { value }]));
    const look = material(NEEDLE_VERTEX, NEEDLE_FRAGMENT, { ...under, ...uniforms });
    this.mesh = new THREE.Mesh(new THREE.InstancedBufferGeometry(), Object.assign(look, { side: THREE.DoubleSide }));
    this.mesh.frustumCulled = false;
  }

  /** Shows needles; box: the width and height of the picture, pixels; ratio: pixels of the canvas per CSS pixel; back: towards the camera. */
  show(
    { rows, states, scales, outward, length }: ShownNeedles,
    box: readonly [number, number],
    ratio: number,
    back: Triple,
  ): void {
    const { uniforms } = this.mesh.material;
    uniforms.box?.value.set(...box);
    uniforms.back?.value.set(...back);
    Object.assign(uniforms.long_ as THREE.IUniform, { value: length });
    Object.assign(uniforms.wide as THREE.IUniform, { value: HEAD * ratio });
    if (NUMBERS * rows.length > this.values.length) this.grow(rows.length);
    rows.forEach((row, n) => {
      const [red, green, blue, alpha, scale] = COLOURS[states[n] ?? "still"];
      const way = outward[n] ?? [0, 0, 0];
      this.values.set([row, ...way, red, green, blue, alpha, scale * (scales?.[n] ?? 1)], NUMBERS * n);
    });
    (this.mesh.geometry.getAttribute("source") as THREE.InterleavedBufferAttribute).data.needsUpdate = true;
    this.mesh.geometry.instanceCount = rows.length;
  }

  /** Makes room for so many. */
  private grow(count: number): void {
    this.mesh.geometry.dispose();
    this.values = new Float32Array(NUMBERS * count);
    const [geometry, values] = [
      new THREE.InstancedBufferGeometry().setIndex(CORNERS),
      new THREE.InstancedInterleavedBuffer(this.values, NUMBERS),
    ];
    let from = 0;
    for (const [name, size] of Object.entries(NEEDLE_ATTRIBUTES)) {
      geometry.setAttribute(name, new THREE.InterleavedBufferAttribute(values, size, from));
      from += size;
    }
    this.mesh.geometry = geometry as THREE.InstancedBufferGeometry;
  }
}
