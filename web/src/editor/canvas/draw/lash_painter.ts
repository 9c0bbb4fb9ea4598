/** Draws the stage's lashes on a face of the atlas: in every frame of a drag that touches the eyes, so without three. */

import type { Anatomy } from "../../../face/anatomy/anatomy";
import { createProgram, vertexArray } from "../../../face/gpu/gl";
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
    const [rows, { strands, bends, triangles }] = [lashRows(anatomy), ribbons()];
    const attributes = [["strand", strands, 4] as const, ["bend", bends, 4] as const];
    this.array = vertexArray(gl, this.program, attributes, Uint16Array.from(triangles));
    this.count = rows === undefined ? 0 : triangles.length;
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
    gl.uniformMatrix4fv(this.at("modelViewMatrix"), false, camera.view.elements);
    gl.uniform3fv(this.at("viewPoint"), camera.eye);
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

  private at(name: string): WebGLUniformLocation | null {
    if (!this.places.has(name)) this.places.set(name, this.gl.getUniformLocation(this.program, name));
    return this.places.get(name) ?? null;
  }
}
