/** Draws a scan and its fitted face, one through the other, into boxes of a canvas. */

import { rowTriangles } from "../../../face/anatomy/topology";
import { createProgram, uniformAt } from "../../../face/gpu/gl";
import type { Mesh } from "../../../link/assets";
import type { Box } from "../../canvas/math/boxes";
import type { Camera } from "../../canvas/math/camera";
import { add, times } from "../../canvas/math/vectors";
import { type Drawable, normalsOf, type ScanSurface } from "../data/scan_document";
import { heatOf } from "./heat_scale";

const VERTEX = `#version 300 es
in vec3 position; in vec3 normal; in vec3 colour;
uniform mat4 matrix; uniform float size;
out vec3 shade; out vec3 facing;
void main() {
  gl_Position = matrix * vec4(position, 1.0);
  gl_PointSize = size;
  shade = colour; facing = normal;
}`;

const FRAGMENT = `#version 300 es
precision highp float;
in vec3 shade; in vec3 facing;
uniform vec3 key; uniform vec3 back; uniform float opacity;
out vec4 drawn;
void main() {
  float far = length(facing);
  vec3 n = far > 0.0 ? facing / far : back;
  if (dot(n, back) < 0.0) n = -n;
  float light = 0.32 + 0.5 * max(dot(n, key), 0.0) + 0.22 * max(dot(n, back), 0.0);
  drawn = vec4(shade * light, opacity);
}`;

const CLAY = [196, 190, 182];
const SKIN = [205, 168, 146];
const TINTS: Readonly<Record<string, readonly number[]>> = {
  tongue: [150, 80, 80],
  teeth_upper: [220, 214, 200],
  teeth_lower: [214, 208, 194],
};
const [WHITE, IRIS] = [
  [232, 230, 226],
  [70, 62, 58],
];
/** Of an eyeball's radius: what lies further ahead is drawn as iris. */
const IRIS_DEPTH = 0.87;
/** Pixels of a cloud's points. */
const POINT = 2.5;

/** Left, bottom, width and height in pixels. */
type PixelBox = [number, number, number, number];

interface Drawn {
  readonly array: WebGLVertexArrayObject;
  readonly buffers: readonly WebGLBuffer[];
  readonly count: number;
  readonly cloud: boolean;
}

/** What of the two is seen: `share` 0 the scan, 1 the face; `heat`: the face in the colours of its distance. */
export interface ScanMix {
  readonly share: number;
  readonly heat: boolean;
}

export class ScanPainter {
  private readonly program: WebGLProgram;
  private scan: Drawn | null = null;
  private parts: Drawn | null = null;
  private face: Drawn | null = null;
  private heat: Drawn | null = null;

  constructor(private readonly gl: WebGL2RenderingContext) {
    this.program = createProgram(gl, VERTEX, FRAGMENT);
  }

  /** Takes in what is drawn from now on; meshes: those of the head. */
  load({ surface, face, bare = false }: Drawable, meshes: readonly Mesh[]): void {
    this.dispose();
    const colours = surface.colours ?? evenly(surface.positions.length / 3, CLAY);
    this.scan = this.build(surface, colours);
    if (face === null) return;
    const drawn = meshes.filter(({ name }) => !name.includes("lash"));
    const triangles = Uint32Array.from(drawn.flatMap((mesh) => [...rowTriangles(mesh)]));
    const whole = { positions: face.positions, triangles, normals: normalsOf(face.positions, triangles) };
    const natural = coloursOf(face.positions, drawn);
    const warm = natural.slice();
    face.residual.forEach((away, row) => {
      warm.set(heatOf(away), 3 * row);
    });
    const parts = Uint32Array.from(drawn.flatMap((mesh) => (mesh.name === "skin" ? [] : [...rowTriangles(mesh)])));
    this.parts = bare ? this.build({ ...whole, triangles: parts }, natural) : null;
    this.face = this.build(whole, natural);
    this.heat = this.build(whole, warm);
  }

  /** Draws into a box of the canvas, CSS pixels, `ratio` pixels of the canvas each. */
  paint(box: Box, camera: Camera, { share, heat }: ScanMix, ratio: number): void {
    const { gl } = this;
    const bottom = gl.canvas.height - ratio * (box.top + box.height);
    const place = [ratio * box.left, bottom, ratio * box.width, ratio * box.height].map(Math.round) as PixelBox;
    gl.viewport(...place);
    gl.scissor(...place);
    gl.enable(gl.SCISSOR_TEST);
    gl.enable(gl.DEPTH_TEST);
    gl.clearColor(0.03, 0.035, 0.04, 1);
    gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
    const face = heat ? this.heat : this.face;
    for (const drawn of [this.scan, this.parts])
      if (drawn !== null && (share < 1 || face === null)) this.draw(drawn, camera, 1, ratio);
    if (face === null || share <= 0) return;
    if (share < 1) gl.clear(gl.DEPTH_BUFFER_BIT);
    this.draw(face, camera, share, ratio);
  }

  dispose(): void {
    for (const drawn of [this.scan, this.parts, this.face, this.heat]) {
      if (drawn === null) continue;
      this.gl.deleteVertexArray(drawn.array);
      for (const buffer of drawn.buffers) this.gl.deleteBuffer(buffer);
    }
    [this.scan, this.parts, this.face, this.heat] = [null, null, null, null];
  }

  /** What is seen through lies over what is behind once: its depth comes first. */
  private draw(drawn: Drawn, camera: Camera, opacity: number, ratio: number): void {
    const { gl } = this;
    this.use(camera, opacity, ratio);
    gl.bindVertexArray(drawn.array);
    gl.depthFunc(gl.LEQUAL);
    if (opacity < 1) {
      gl.colorMask(false, false, false, false);
      this.once(drawn);
      gl.colorMask(true, true, true, true);
      gl.enable(gl.BLEND);
      gl.blendFunc(gl.SRC_ALPHA, gl.ONE_MINUS_SRC_ALPHA);
    }
    this.once(drawn);
    gl.disable(gl.BLEND);
    gl.bindVertexArray(null);
  }

  private use({ matrix, back, up, right }: Camera, opacity: number, ratio: number): void {
    const { gl, program } = this;
    const key = add(add(times(back, 0.6), times(up, 0.55)), times(right, -0.58));
    gl.useProgram(program);
    gl.uniformMatrix4fv(uniformAt(gl, program, "matrix"), false, matrix);
    gl.uniform3fv(uniformAt(gl, program, "back"), back);
    gl.uniform3fv(uniformAt(gl, program, "key"), key);
    gl.uniform1f(uniformAt(gl, program, "opacity"), opacity);
    gl.uniform1f(uniformAt(gl, program, "size"), POINT * ratio);
  }

  private once({ cloud, count }: Drawn): void {
    const { gl } = this;
    if (cloud) gl.drawArrays(gl.POINTS, 0, count);
    else gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 0);
  }

  private build({ positions, normals, triangles }: Omit<ScanSurface, "colours">, colours: Uint8Array): Drawn {
    const { gl, program } = this;
    const array = gl.createVertexArray();
    gl.bindVertexArray(array);
    const buffers = (
      [
        ["position", positions, gl.FLOAT],
        ["normal", normals, gl.FLOAT],
        ["colour", colours, gl.UNSIGNED_BYTE],
      ] as const
    ).map(([name, values, kind]) => {
      const buffer = gl.createBuffer();
      gl.bindBuffer(gl.ARRAY_BUFFER, buffer);
      gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
      const place = gl.getAttribLocation(program, name);
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, 3, kind, kind === gl.UNSIGNED_BYTE, 0, 0);
      return buffer;
    });
    const cloud = triangles.length === 0;
    if (!cloud) {
      const buffer = gl.createBuffer();
      gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, buffer);
      gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, triangles, gl.STATIC_DRAW);
      buffers.push(buffer);
    }
    gl.bindVertexArray(null);
    return { array, buffers, count: cloud ? positions.length / 3 : triangles.length, cloud };
  }
}

const evenly = (count: number, colour: readonly number[]): Uint8Array =>
  Uint8Array.from({ length: 3 * count }, (_, at) => colour[at % 3] as number);

/** The colours (v, 3) of a face's rows: skin, teeth, tongue, and eyes with an iris ahead. */
function coloursOf(positions: Float32Array, meshes: readonly Mesh[]): Uint8Array {
  const colours = evenly(positions.length / 3, SKIN);
  for (const { name, source } of meshes) {
    const tint = TINTS[name];
    if (tint !== undefined) for (const row of source) colours.set(tint, 3 * row);
    if (!name.startsWith("eye_")) continue;
    const depths = [...source].map((row) => positions[3 * row + 2] as number);
    const [low, high] = [Math.min(...depths), Math.max(...depths)];
    for (const row of source) {
      const ahead = ((positions[3 * row + 2] as number) - (low + high) / 2) / Math.max((high - low) / 2, 1e-9);
      colours.set(ahead > IRIS_DEPTH ? IRIS : WHITE, 3 * row);
    }
  }
  return colours;
}
