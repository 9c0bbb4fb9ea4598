/** WebGL 2: programs, textures and render targets. */

/** A linked program; an Error with the driver's words when a shader does not compile. */
export function createProgram(gl: WebGL2RenderingContext, vertex: string, fragment: string): WebGLProgram {
  const program = gl.createProgram();
  for (const [kind, source] of [
    [gl.VERTEX_SHADER, vertex],
    [gl.FRAGMENT_SHADER, fragment],
  ] as const) {
    const shader = gl.createShader(kind) as WebGLShader;
    gl.shaderSource(shader, source);
    gl.compileShader(shader);
    gl.attachShader(program, shader);
    gl.deleteShader(shader);
    if (!gl.getShaderParameter(shader, gl.COMPILE_STATUS) && !gl.isContextLost())
      throw new Error(`A shader does not compile: ${gl.getShaderInfoLog(shader)}`);
  }
  gl.linkProgram(program);
  if (!gl.getProgramParameter(program, gl.LINK_STATUS) && !gl.isContextLost())
    throw new Error(`A shader does not link: ${gl.getProgramInfoLog(program)}`);
  return program;
}

const locations = new WeakMap<WebGLProgram, Map<string, WebGLUniformLocation | null>>();

/** Where a program's uniform is, remembered: to ask for it costs as much as a small pass. */
export function uniformAt(
  gl: WebGL2RenderingContext,
  program: WebGLProgram,
  name: string,
): WebGLUniformLocation | null {
  const programLocations = locations.get(program) ?? new Map<string, WebGLUniformLocation | null>();
  locations.set(program, programLocations);
  const place = programLocations.get(name);
  if (place !== undefined) return place;
  const location = gl.getUniformLocation(program, name);
  programLocations.set(name, location);
  return location;
}

/** An empty texture whose texels are read as they are. */
function nearestTexture(gl: WebGL2RenderingContext, format: number, width: number, height: number): WebGLTexture {
  const texture = gl.createTexture();
  gl.bindTexture(gl.TEXTURE_2D, texture);
  gl.texStorage2D(gl.TEXTURE_2D, 1, format, width, height);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MIN_FILTER, gl.NEAREST);
  gl.texParameteri(gl.TEXTURE_2D, gl.TEXTURE_MAG_FILTER, gl.NEAREST);
  return texture;
}

/** A float texture and the framebuffer that draws into it. */
export function targetTexture(
  gl: WebGL2RenderingContext,
  width: number,
  height: number,
): [WebGLTexture, WebGLFramebuffer] {
  const texture = nearestTexture(gl, gl.RGBA32F, width, height);
  const target = gl.createFramebuffer();
  gl.bindFramebuffer(gl.FRAMEBUFFER, target);
  gl.framebufferTexture2D(gl.FRAMEBUFFER, gl.COLOR_ATTACHMENT0, gl.TEXTURE_2D, texture, 0);
  gl.bindFramebuffer(gl.FRAMEBUFFER, null);
  return [texture, target];
}

/** Pairs of whole numbers as a texture, `width` pairs to a line. */
export const dataTexture = (gl: WebGL2RenderingContext, pairs: Uint32Array, width: number): WebGLTexture =>
  filledTexture(gl, pairs, 2, width);

/** Whole numbers as a texture, four to a texel and `width` texels to a line. */
export const wholeTexture = (gl: WebGL2RenderingContext, values: Uint32Array, width: number): WebGLTexture =>
  filledTexture(gl, values, 4, width);

/** Numbers as a float texture, `parts` (1, 2 or 4) to a texel and `width` texels to a line. */
export const floatTexture = (
  gl: WebGL2RenderingContext,
  values: Float32Array,
  parts: 1 | 2 | 4,
  width: number,
): WebGLTexture => filledTexture(gl, values, parts, width);

function filledTexture(
  gl: WebGL2RenderingContext,
  values: Uint32Array | Float32Array,
  parts: 1 | 2 | 4,
  width: number,
): WebGLTexture {
  const height = Math.max(1, Math.ceil(values.length / parts / width));
  const real = values instanceof Float32Array;
  const padded = new (real ? Float32Array : Uint32Array)(parts * width * height);
  padded.set(values);
  const inside = real
    ? { 1: gl.R32F, 2: gl.RG32F, 4: gl.RGBA32F }[parts]
    : { 1: gl.R32UI, 2: gl.RG32UI, 4: gl.RGBA32UI }[parts];
  const format = real
    ? { 1: gl.RED, 2: gl.RG, 4: gl.RGBA }[parts]
    : { 1: gl.RED_INTEGER, 2: gl.RG_INTEGER, 4: gl.RGBA_INTEGER }[parts];
  const texture = nearestTexture(gl, inside, width, height);
  gl.texSubImage2D(gl.TEXTURE_2D, 0, 0, 0, width, height, format, real ? gl.FLOAT : gl.UNSIGNED_INT, padded);
  return texture;
}
