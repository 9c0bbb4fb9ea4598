/** A face's skin as one picture, painted once: the cast's layers in the face's colours, and over them the picture of a
 * certain person's skin, as the stage has them. */

import type { Anatomy } from "../../../face/anatomy/anatomy";
import { createProgram, vertexArray } from "../../../face/gpu/gl";
import { decodeSrgb } from "../../../face/light/tone";
import { SKIN_COLOURS } from "../../../face/skin/skin_colour_shaders";
import type { Library, Mesh } from "../../../link/assets";
import { SKIN_LAYERS } from "../../../link/constants";
import type { FaceDocument, Look } from "../../../link/messages";
import { loadPicture } from "../../session/asset_loading";

const COLOURS = ["skin", "lip", "brow", "blush", "hair", "coat"] as const;
const TRAITS = [
  "pores",
  "age",
  "freckles",
  "stubble",
  "brows",
  "makeup",
  "fur",
  "stripes",
  "lacquer",
  "scalp",
] as const;
const LAYERS = ["mask", "marks", "patches", "pelt"] as const;
/** Pictures of skin that are remembered, 4 or 16 MB each: most edits of a face leave its picture as it is. */
const REMEMBERED = 4;

/** Twice: over the whole picture, so that no seam is bare, then the head itself with what is known by its rows. */
const PAINT_VERTEX = `#version 300 es
in vec2 uv;
in vec2 trait; // hair, open sky
out vec2 vUv;
out vec2 vTrait;
void main() {
  vUv = uv;
  vTrait = trait;
  gl_Position = vec4(uv * 2.0 - 1.0, 0.0, 1.0);
}
`;

/** Stored as square roots, so that eight bits are enough for dark skin. */
const PAINT_FRAGMENT = `#version 300 es
precision highp float;
in vec2 vUv;
in vec2 vTrait;
out vec4 colour;
vec4 layer(sampler2D picture) { return texture(picture, vUv); }
${SKIN_COLOURS}
void main() {
  Layers layers = Layers(texture(mask, vUv), texture(marks, vUv), texture(patches, vUv), vec4(0.45, 0.2, 1.0, 0.5), texture(pelt, vUv));
  Ground at = ground(layers, vTrait.x);
  float open = smoothstep(-0.25, 0.75, vTrait.y);
  vec3 shade = mix(vec3(0.34, 0.24, 0.22), vec3(1.0), open); // hollows stay warm
  colour = vec4(sqrt(clamp(at.albedo * shade, 0.0, 1.0)), clamp(at.lips + 0.6 * at.leather + 0.5 * lacquer, 0.0, 1.0));
}
`;

export class SkinTextures {
  private readonly program: WebGLProgram;
  private readonly layers: WebGLTexture[];
  private readonly head: WebGLVertexArrayObject;
  private readonly sheet: WebGLVertexArrayObject;
  private readonly count: number;
  private readonly pictures = new Map<string, Promise<ImageBitmap>>();

  private constructor(
    private readonly gl: WebGL2RenderingContext,
    pictures: readonly ImageBitmap[],
    skin: Mesh,
    traits: Float32Array,
  ) {
    this.program = createProgram(gl, PAINT_VERTEX, PAINT_FRAGMENT);
    this.layers = LAYERS.map((name) => layerTexture(gl, pictures[SKIN_LAYERS.indexOf(name)] as ImageBitmap));
    const pairs = new Float32Array(2 * skin.source.length);
    skin.source.forEach((row, n) => {
      pairs.set([traits[4 * row + 2] as number, traits[4 * row + 1] as number], 2 * n);
    });
    this.head = this.array(skin.uv, pairs, skin.triangles);
    this.count = skin.triangles.length;
    const square = Float32Array.from([0, 0, 1, 0, 0, 1, 1, 1]);
    this.sheet = this.array(square, Float32Array.from([0, 1, 0, 1, 0, 1, 0, 1]), Uint32Array.from([0, 1, 2, 2, 1, 3]));
  }

  /** The textures with the layers of the cast; undefined layers are waited for. */
  static async open(gl: WebGL2RenderingContext, library: Library, anatomy: Anatomy, skin: Mesh): Promise<SkinTextures> {
    return new SkinTextures(gl, await library.layers(), skin, anatomy.traits);
  }

  /** The picture on a face's skin; undefined where it has none, or where that cannot be had. */
  async picture(document: FaceDocument): Promise<ImageBitmap | undefined> {
    const { albedo } = document;
    if (albedo === "") return undefined;
    const asked = this.pictures.get(albedo) ?? loadPicture(document);
    this.pictures.delete(albedo); // the last in the order is the newest
    this.pictures.set(albedo, asked);
    for (const oldest of [...this.pictures.keys()].slice(0, -REMEMBERED)) this.pictures.delete(oldest);
    try {
      return await asked;
    } catch (error) {
      this.pictures.delete(albedo); // it may be asked again
      console.warn(`${document.label} shows without its picture: ${String(error)}`);
      return undefined;
    }
  }

  /** The skin of a look under a picture, `side` texels square, with smaller copies of itself. */
  paint(look: Look, picture: ImageBitmap | undefined, side: number): WebGLTexture {
    const { gl } = this;
    const laid = picture === undefined ? null : pictureTexture(gl, picture);
    const texture = gl.createTexture();
    gl.bindTexture(gl.TEXTURE_2D, texture);
    gl.texStorage2D(gl.TEXTURE_2D, Math.floor(Math.log2(side)) + 1, gl.RGBA8, side, side);
    const target = gl.createFramebuffer();
    gl.bindFramebuffer(gl.FRAMEBUFFER, target);
    gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
    gl.viewport(0, 0, side, side);
    for (const feature of [gl.BLEND, gl.DEPTH_TEST, gl.SCISSOR_TEST, gl.CULL_FACE]) gl.disable(feature);
    this.dress(look, laid);
    for (const [array, count] of [
      [this.sheet, 6],
      [this.head, this.count],
    ] as const) {
      gl.bindVertexArray(array);
      gl.drawElements(gl.TRIANGLES, count, gl.UNSIGNED_INT, 0);
    }
    gl.bindVertexArray(null);
    gl.bindFramebuffer(gl.FRAMEBUFFER, null);
    gl.deleteFramebuffer(target);
    gl.deleteTexture(laid);
    gl.bindTexture(gl.TEXTURE_2D, texture);
    makeSmaller(gl);
    return texture;
  }

  private dress(look: Look, picture: WebGLTexture | null): void {
    const { gl, program } = this;
    gl.useProgram(program);
    gl.activeTexture(gl.TEXTURE0 + LAYERS.length);
    gl.bindTexture(gl.TEXTURE_2D, picture);
    gl.uniform1i(gl.getUniformLocation(program, "picture0"), LAYERS.length);
    gl.uniform4f(gl.getUniformLocation(program, "pictureWeights"), picture === null ? 0 : 1, 0, 0, 0);
    LAYERS.forEach((name, unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, this.layers[unit] as WebGLTexture);
      gl.uniform1i(gl.getUniformLocation(program, name), unit);
    });
    gl.activeTexture(gl.TEXTURE0);
    // The look has the paint alone already, less what its picture covers: `pictured` is the look itself.
    for (const name of COLOURS)
      for (const uniform of [name, `pictured.${name}`])
        gl.uniform3fv(gl.getUniformLocation(program, uniform), [...decodeSrgb(look[name])]);
    for (const name of TRAITS)
      for (const uniform of [name, `pictured.${name}`])
        gl.uniform1f(gl.getUniformLocation(program, uniform), look[name]);
  }

  private array(uv: Float32Array, traits: Float32Array, triangles: Uint32Array): WebGLVertexArrayObject {
    const attributes = [["uv", uv, 2] as const, ["trait", traits, 2] as const];
    return vertexArray(this.gl, this.program, attributes, triangles);
  }
}

/** A picture in sRGB, read and made smaller in linear light. */
function pictureTexture(gl: WebGL2RenderingContext, picture: ImageBitmap): WebGLTexture {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.SRGB8_ALPHA8, gl.RGBA, gl.UNSIGNED_BYTE, picture);
  makeSmaller(gl);
  return texture;
}

/** Gives the bound texture smaller copies of itself. */
function makeSmaller(gl: WebGL2RenderingContext): void {
  gl.generateMipmap(gl.TEXTURE_2D);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR_MIPMAP_NEAREST);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
}

function layerTexture(gl: WebGL2RenderingContext, picture: ImageBitmap): WebGLTexture {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.pixelStorei(gl.UNPACK_PREMULTIPLY_ALPHA_WEBGL, false);
  gl.texImage2D(gl.TEXTURE_2D, 0, gl.RGBA8, gl.RGBA, gl.UNSIGNED_BYTE, picture);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.LINEAR);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.LINEAR);
  return texture;
}
