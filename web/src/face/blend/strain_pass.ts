/** The pass that finds how far skin is pressed together or drawn out, and which way, as `omote.geometry.strain` does. */

import type { Fans } from "../anatomy/topology";
import { fanSpans } from "../anatomy/topology";
import { createProgram, dataTexture, uniformAt } from "../gpu/gl";
import { PASS_HEAD, PASS_VERTEX, ROW_SHIFT, ROW_WIDTH } from "../gpu/pass_shaders";

const CORNER_WIDTH = 512;

/**
 * Strain of each row: level, mixed, upright. `F` is the gradient of places now by places at rest in a triangle, `U` the
 * symmetric root of `F'F`, the strain `U - 1`; a row has the mean of its fan, by areas at rest.
 */
const STRAIN_FRAGMENT = `${PASS_HEAD}
uniform sampler2D positions;
uniform sampler2D rests;
uniform usampler2D ranges;
uniform usampler2D corners;
out vec4 strain;

ivec2 texelOf(uint row) { return ivec2(int(row & ${ROW_WIDTH - 1}u), int(row >> ${ROW_SHIFT})); }

/** What one triangle says, times twice its area at rest, and that. */
vec4 triangle(vec3 rest1, vec3 rest2, vec3 now1, vec3 now2) {
  vec3 facing = cross(rest1, rest2);
  float area = max(length(facing), 1e-20);
  vec3 normal = facing / area;
  vec3 level = vec3(normal.z, 0.0, -normal.x); // upright x normal
  float wide = length(level);
  level = wide < 1e-3 ? vec3(1.0, 0.0, 0.0) : level / wide;
  vec3 upright = cross(normal, level);
  vec2 first = vec2(dot(rest1, level), dot(rest1, upright));
  vec2 second = vec2(dot(rest2, level), dot(rest2, upright));
  vec3 x = (second.y * now1 - first.y * now2) / area;
  vec3 y = (first.x * now2 - second.x * now1) / area;
  float xx = dot(x, x), xy = dot(x, y), yy = dot(y, y);
  float root = sqrt(max(xx * yy - xy * xy, 0.0));
  float scale = sqrt(max(xx + yy + 2.0 * root, 1e-20));
  return area * vec4((xx + root) / scale - 1.0, xy / scale, (yy + root) / scale - 1.0, 1.0);
}

void main() {
  ivec2 at = ivec2(gl_FragCoord.xy);
  uvec2 range = texelFetch(ranges, at, 0).xy;
  vec3 rest = texelFetch(rests, at, 0).xyz;
  vec3 here = texelFetch(positions, at, 0).xyz;
  vec4 sum = vec4(0.0);
  for (uint slot = range.x; slot < range.y; slot++) {
    uvec2 pair = texelFetch(corners, ivec2(int(slot & ${CORNER_WIDTH - 1}u), int(slot >> 9)), 0).xy;
    ivec2 one = texelOf(pair.x), other = texelOf(pair.y);
    sum += triangle(
      texelFetch(rests, one, 0).xyz - rest, texelFetch(rests, other, 0).xyz - rest,
      texelFetch(positions, one, 0).xyz - here, texelFetch(positions, other, 0).xyz - here);
  }
  strain = sum.w > 0.0 ? vec4(sum.xyz / sum.w, 1.0) : vec4(0.0);
}
`;

/** Draws strains; rows without a fan have none. */
export class StrainPass {
  private readonly program: WebGLProgram;
  private readonly ranges: WebGLTexture;
  private readonly corners: WebGLTexture;
  private readonly empty: WebGLVertexArrayObject;

  /** `fans`: of the triangles that may fold, for all rows. */
  constructor(
    private readonly gl: WebGL2RenderingContext,
    private readonly height: number,
    fans: Fans,
  ) {
    this.program = createProgram(gl, PASS_VERTEX, STRAIN_FRAGMENT);
    this.ranges = dataTexture(gl, fanSpans(fans), ROW_WIDTH);
    this.corners = dataTexture(gl, fans.pairs, CORNER_WIDTH);
    this.empty = gl.createVertexArray();
    gl.useProgram(this.program);
    ["positions", "rests", "ranges", "corners"].forEach((name, unit) => {
      gl.uniform1i(uniformAt(gl, this.program, name), unit);
    });
  }

  /** Draws the strain of positions against others at rest into a target. */
  draw(positions: WebGLTexture, rests: WebGLTexture, target: WebGLFramebuffer): void {
    const { gl } = this;
    gl.bindFramebuffer(gl.FRAMEBUFFER, target);
    gl.viewport(0, 0, ROW_WIDTH, this.height);
    gl.bindVertexArray(this.empty);
    gl.useProgram(this.program);
    [positions, rests, this.ranges, this.corners].forEach((texture, unit) => {
      gl.activeTexture(gl.TEXTURE0 + unit);
      gl.bindTexture(gl.TEXTURE_2D, texture);
    });
    gl.drawArrays(gl.TRIANGLES, 0, 3);
  }

  dispose(): void {
    const { gl } = this;
    for (const texture of [this.ranges, this.corners]) gl.deleteTexture(texture);
    gl.deleteProgram(this.program);
    gl.deleteVertexArray(this.empty);
  }
}
