/** Draws the stage's lashes on a face of the atlas: in every frame of a drag that touches the eyes, so without three. */

import type { Anatomy } from "../../../face/anatomy/anatomy";
import { createProgram } from "../../../face/gpu/gl";
import { LASH_FRAGMENT, LASH_VERTEX } from "../../../face/head/lash_shaders";
import { lashRows, ribbons } from "../../../face/head/lashes";
import { decodeSrgb } from "../../../face/light/tone";
import type { Look } from "../../../link/messages";
import type { Camera } from "../math/camera";
import type { FaceAtlas } from "./face_atlas";

const VERSION = "#version 300 es\n";

export class LashPainter {
  private readonly program: WebGLProgram;
  private readonly array: WebGLVertexArrayObject;
  private readonly count: number;
  private readonly places = new Map<string, WebGLUniformLocation | null>();

  constructor(
    private readonly gl: WebGL2RenderingContext,
    private readonly faceAtlas: FaceAtlas,
    anatomy: Anatomy,
  ) {
    this.program = createProgram(gl, VERSION + LASH_VERTEX, VERSION + LASH_FRAGMENT);
    this.array = gl.createVertexArray();
    const rows = lashRows(anatomy);
    this.count = rows === undefined ? 0 : this.upload();
    if (rows === undefined) return;
    gl.useProgram(this.program);
    gl.uniform1iv(this.at("edgeRows"), rows.edgeRows);
    gl.uniform1iv(this.at("ballRows"), rows.ballRows);
    gl.uniform1i(this.at("positions"), 0);
    gl.uniform1f(this.at("EXPOSURE"), 1);
    gl.uniformMatrix3fv(this.at("headTurn"), false, [1, 0, 0, 0, 1, 0, 0, 0, 1]);
  }

  /** Draws the lashes of a face of the atlas into the bound framebuffer; `height`: pixels of the face's box. */
  draw(block: number, { lashes, brow }: Look, camera: Camera, height: number): void {
    const { gl } = this;
    if (this.count === 0 || lashes === 0) return;
    gl.useProgram(this.program);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, this.faceAtlas.positions);
    gl.uniform1i(this.at("firstLine"), block * this.faceAtlas.lines);
    gl.uniform1f(this.at("lashes"), lashes);
    gl.uniform3fv(this.at("brow"), [...decodeSrgb(brow)]);
    gl.uniform1f(this.at("pixel"), 2 / ((camera.projection.elements[5] as number) * height));
    gl.uniformMatrix4fv(this.at("projectionMatrix"), false, camera.projection.elements);
    gl.uniformMatrix4fv(this.at("viewMatrix"), false, camera.view.elements);
    gl.uniform3fv(this.at("cameraPosition"), camera.eye);
    gl.enable(gl.DEPTH_TEST);
    gl.disable(gl.CULL_FACE);
    gl.enable(gl.BLEND);
    gl.blendFunc(gl.ONE, gl.ONE_MINUS_SRC_ALPHA);
    gl.depthMask(false);
    gl.bindVertexArray(this.array);
    gl.drawElements(gl.TRIANGLES, this.count, gl.UNSIGNED_SHORT, 0);
    gl.bindVertexArray(null);
    gl.depthMask(true);
    gl.disable(gl.BLEND);
  }

  private upload(): number {
    const { gl, program } = this;
    const { strands, bends, triangles } = ribbons();
    gl.bindVertexArray(this.array);
    for (const [name, values] of [
      ["strand", strands],
      ["bend", bends],
    ] as const) {
      const place = gl.getAttribLocation(program, name);
      gl.bindBuffer(gl.ARRAY_BUFFER, gl.createBuffer());
      gl.bufferData(gl.ARRAY_BUFFER, values, gl.STATIC_DRAW);
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, 4, gl.FLOAT, false, 0, 0);
    }
    gl.bindBuffer(gl.ELEMENT_ARRAY_BUFFER, gl.createBuffer());
    gl.bufferData(gl.ELEMENT_ARRAY_BUFFER, Uint16Array.from(triangles), gl.STATIC_DRAW);
    gl.bindVertexArray(null);
    return triangles.length;
  }

  private at(name: string): WebGLUniformLocation | null {
    if (!this.places.has(name)) this.places.set(name, this.gl.getUniformLocation(this.program, name));
    return this.places.get(name) ?? null;
  }
}
