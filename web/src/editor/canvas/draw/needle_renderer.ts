/** Draws needles out of a face's skin. */

import { createProgram } from "../../../face/gpu/gl";
import type { Camera } from "../math/camera";
import type { Triple } from "../math/vectors";
import { SLACK } from "../model/needles";
import type { FacePainter } from "./face_painter";
import { NEEDLE_FRAGMENT, NEEDLE_VERTEX } from "./face_shaders";

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
const CORNERS = Uint16Array.from([0, 1, 2, 2, 1, 3, 4, 5, 6, 6, 5, 7]);
/** CSS pixels of a head's radius. */
export const HEAD = 4.2;

export class NeedleRenderer {
  private readonly program: WebGLProgram;
  private readonly array: WebGLVertexArrayObject;
  private readonly rows: WebGLBuffer;
  private readonly looks: WebGLBuffer;
  private readonly ways: WebGLBuffer;
  private count = 0;

  constructor(
    private readonly gl: WebGL2RenderingContext,
    private readonly painter: FacePainter,
  ) {
    this.program = createProgram(gl, NEEDLE_VERTEX, NEEDLE_FRAGMENT);
    [this.array, this.rows] = [gl.createVertexArray(), gl.createBuffer()];
    [this.looks, this.ways] = [gl.createBuffer(), gl.createBuffer()];
    const at = (name: string) => gl.getAttribLocation(this.program, name);
    gl.bindVertexArray(this.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.rows);
    gl.enableVertexAttribArray(at("row"));
    gl.vertexAttribIPointer(at("row"), 1, gl.UNSIGNED_SHORT, 0, 0);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.looks);
    for (const [name, width, offset] of [
      ["colour", 4, 0],
      ["scale", 1, 16],
    ] as const) {
      gl.enableVertexAttribArray(at(name));
      gl.vertexAttribPointer(at(name), width, gl.FLOAT, false, 20, offset);
    }
    gl.bindBuffer(gl.ARRAY_BUFFER, this.ways);
    gl.enableVertexAttribArray(at("outward"));
    gl.vertexAttribPointer(at("outward"), 3, gl.FLOAT, false, 0, 0);
    for (const name of ["row", "colour", "scale", "outward"]) gl.vertexAttribDivisor(at(name), 1);
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, CORNERS, gl.STATIC_DRAW);
    gl.bindVertexArray(null);
  }

  /**
   * The rows under the needles, how each looks, how large its head is (1: ordinary) and where it points
   * (as the skin does, where nothing is said). */
  set(
    rows: readonly number[],
    states: readonly NeedleState[],
    scales?: readonly number[],
    outward?: readonly Triple[],
  ): void {
    const { gl } = this;
    const looks = Float32Array.from(states.flatMap((state) => COLOURS[state]));
    scales?.forEach((scale, n) => {
      looks[5 * n + 4] = (looks[5 * n + 4] as number) * scale;
    });
    const ways = Float32Array.from(
      { length: 3 * rows.length },
      (_, at) => outward?.[Math.floor(at / 3)]?.[at % 3] ?? 0,
    );
    gl.bindBuffer(gl.ARRAY_BUFFER, this.ways);
    gl.bufferData(gl.ARRAY_BUFFER, ways, gl.DYNAMIC_DRAW);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.rows);
    gl.bufferData(gl.ARRAY_BUFFER, Uint16Array.from(rows), gl.DYNAMIC_DRAW);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.looks);
    gl.bufferData(gl.ARRAY_BUFFER, looks, gl.DYNAMIC_DRAW);
    this.count = rows.length;
  }

  /** Draws them; `length`: metres; `ratio`: pixels of the canvas per CSS pixel. */
  draw(block: number, camera: Camera, length: number, ratio: number): void {
    const { gl, painter, program } = this;
    if (this.count === 0) return;
    gl.enable(gl.DEPTH_TEST);
    gl.disable(gl.CULL_FACE);
    gl.disable(gl.BLEND);
    painter.use(program, camera);
    painter.atlas(program, block);
    gl.uniform2f(painter.at(program, "box"), camera.box.width * ratio, camera.box.height * ratio);
    gl.uniform1f(painter.at(program, "long_"), length);
    gl.uniform1f(painter.at(program, "slack"), SLACK);
    gl.uniform1f(painter.at(program, "wide"), HEAD * ratio);
    gl.bindVertexArray(this.array);
    gl.drawElementsInstanced(gl.TRIANGLES, CORNERS.length, gl.UNSIGNED_SHORT, 0, this.count);
    gl.bindVertexArray(null);
  }
}
