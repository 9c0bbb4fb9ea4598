/** What a drag does not move, kept as pictures: collar and hair of each face, behind its skin and before it. */

import { createProgram, nearestTexture } from "../../../face/gpu/gl";
import type { Multisampled } from "../../../face/gpu/multisampled";
import type { PixelBox } from "./face_painter";

const VERTEX = `#version 300 es
void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }
`;

/** In alpha what is left of the picture under it. */
const FRAGMENT = `#version 300 es
precision mediump float;
uniform sampler2D layer;
uniform ivec2 corner; // of the face's box in the framebuffer
out vec4 colour;
void main() { colour = texelFetch(layer, ivec2(gl_FragCoord.xy) - corner, 0); }
`;

/** The pictures of one face in its box. */
interface Layers {
  /** What they were made for; other views need others. */
  key: string;
  behind: WebGLTexture;
  before: WebGLTexture;
  width: number;
  height: number;
}

/** Makes the pictures of a face: of collar and hair alone, or, `masked`, less what its skin covers. */
export type DrawLayer = (masked: boolean) => void;

/** Hair costs more than all the rest of a face: it is drawn when the view changes, and laid under and over what moves. */
export class HairLayers {
  private readonly layers = new Map<number, Layers>();
  private readonly program: WebGLProgram;
  private readonly empty: WebGLVertexArrayObject;
  private readonly at: Record<"layer" | "corner", WebGLUniformLocation | null>;

  constructor(
    private readonly gl: WebGL2RenderingContext,
    private readonly multisampled: Multisampled,
  ) {
    this.program = createProgram(gl, VERTEX, FRAGMENT);
    this.empty = gl.createVertexArray();
    const place = (name: string) => gl.getUniformLocation(this.program, name);
    this.at = { layer: place("layer"), corner: place("corner") };
  }

  /** Whether face `n` has pictures made for this key. */
  has(n: number, key: string): boolean {
    return this.layers.get(n)?.key === key;
  }

  /** Makes the pictures of face `n`, so many pixels large; `draw` draws into the multisampled framebuffer. */
  make(n: number, key: string, width: number, height: number, draw: DrawLayer): void {
    const { gl, multisampled } = this;
    multisampled.fit(width, height);
    const layers = this.fit(n, width, height);
    for (const [texture, masked] of [
      [layers.behind, false],
      [layers.before, true],
    ] as const) {
      gl.bindFramebuffer(gl.FRAMEBUFFER, multisampled.framebuffer);
      gl.disable(gl.SCISSOR_TEST);
      gl.clearColor(0, 0, 0, 1);
      gl.clear(gl.COLOR_BUFFER_BIT | gl.DEPTH_BUFFER_BIT);
      draw(masked);
      multisampled.copyTo(texture, width, height);
    }
    layers.key = key;
  }

  /** Lays a picture of face `n` over what its part of the bound framebuffer shows; the box is that of the whole face. */
  lay(n: number, which: "behind" | "before", [left, bottom]: PixelBox, part: PixelBox): void {
    const layers = this.layers.get(n);
    if (layers === undefined) return;
    const { gl, at } = this;
    gl.viewport(...part);
    for (const feature of [gl.DEPTH_TEST, gl.CULL_FACE]) gl.disable(feature);
    gl.enable(gl.BLEND);
    gl.blendFuncSeparate(gl.ONE, gl.SRC_ALPHA, gl.ZERO, gl.ONE);
    gl.useProgram(this.program);
    gl.bindVertexArray(this.empty);
    gl.activeTexture(gl.TEXTURE0);
    gl.bindTexture(gl.TEXTURE_2D, layers[which]);
    gl.uniform1i(at.layer, 0);
    gl.uniform2i(at.corner, left, bottom);
    gl.drawArrays(gl.TRIANGLES, 0, 3);
    gl.disable(gl.BLEND);
    gl.bindVertexArray(null);
  }

  /** Forgets the pictures from face `first` on. */
  forget(first = 0): void {
    for (const [n, layers] of this.layers) {
      if (n < first) continue;
      this.free(layers);
      this.layers.delete(n);
    }
  }

  private fit(n: number, width: number, height: number): Layers {
    const known = this.layers.get(n);
    if (known?.width === width && known.height === height) return known;
    if (known !== undefined) this.free(known);
    const [behind, before] = [0, 1].map(() => nearestTexture(this.gl, this.gl.RGBA8, width, height)) as [
      WebGLTexture,
      WebGLTexture,
    ];
    const made = { key: "", behind, before, width, height };
    this.layers.set(n, made);
    return made;
  }

  private free({ behind, before }: Layers): void {
    for (const texture of [behind, before]) this.gl.deleteTexture(texture);
  }
}
