/** Lays the grounds of all faces' pictures in one call: a clearance each costs a software renderer more than the faces. */

import { createProgram } from "../../../face/gpu/gl";
import type { PixelBox } from "./face_painter";

/** A part of the canvas that is drawn anew, and the colour behind the face there. */
export interface Background {
  part: PixelBox;
  colour: readonly [number, number, number];
}

const VERTEX = `#version 300 es
in vec4 part; // left, bottom, width, height: shares of the canvas
in vec3 colour;
out vec3 vColour;
void main() {
  vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
  vColour = colour;
  gl_Position = vec4((part.xy + corner * part.zw) * 2.0 - 1.0, 1.0, 1.0); // as far as depth goes
}
`;

const FRAGMENT = `#version 300 es
precision mediump float;
in vec3 vColour;
out vec4 result;
void main() { result = vec4(vColour, 1.0); }
`;

const NUMBERS = 7; // of a ground: its part, its colour

/** The grounds as numbers, seven each: parts as shares of a canvas of this size. */
export const packed = (backgrounds: readonly Background[], width: number, height: number): Float32Array =>
  Float32Array.from(
    backgrounds.flatMap(({ part: [left, bottom, across, up], colour }) => [
      left / width,
      bottom / height,
      across / width,
      up / height,
      ...colour,
    ]),
  );

export class Backgrounds {
  private readonly program: WebGLProgram;
  private readonly array: WebGLVertexArrayObject;
  private readonly buffer: WebGLBuffer;

  constructor(private readonly gl: WebGL2RenderingContext) {
    this.program = createProgram(gl, VERTEX, FRAGMENT);
    [this.array, this.buffer] = [gl.createVertexArray(), gl.createBuffer()];
    gl.bindVertexArray(this.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
    for (const [name, size, from] of [
      ["part", 4, 0],
      ["colour", 3, 4],
    ] as const) {
      const place = gl.getAttribLocation(this.program, name);
      gl.enableVertexAttribArray(place);
      gl.vertexAttribPointer(place, size, gl.FLOAT, false, 4 * NUMBERS, 4 * from);
      gl.vertexAttribDivisor(place, 1);
    }
    gl.bindVertexArray(null);
  }

  /** Paints grounds, as far away as can be: what was there is gone. */
  lay(backgrounds: readonly Background[]): void {
    const { gl } = this;
    const { drawingBufferWidth: width, drawingBufferHeight: height } = gl;
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.viewport(0, 0, width, height);
    for (const feature of [gl.SCISSOR_TEST, gl.CULL_FACE, gl.BLEND]) gl.disable(feature);
    gl.enable(gl.DEPTH_TEST);
    gl.depthFunc(gl.ALWAYS);
    gl.useProgram(this.program);
    gl.bindVertexArray(this.array);
    gl.bindBuffer(gl.ARRAY_BUFFER, this.buffer);
    gl.bufferData(gl.ARRAY_BUFFER, packed(backgrounds, width, height), gl.STREAM_DRAW);
    gl.drawArraysInstanced(gl.TRIANGLE_STRIP, 0, 4, backgrounds.length);
    gl.depthFunc(gl.LESS);
    gl.bindVertexArray(null);
  }
}
