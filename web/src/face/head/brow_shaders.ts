/** Shaders of the brows. */

import { FRAGMENT_HEAD, LIGHTS, VERTEX_HEAD } from "../light/shader_prelude";

/**
 * Brows: fine ribbons whose roots and tips lie on the blended skin, so that every face and expression moves them as it
 * moves that. As lashes they fade where they are narrower than a pixel.
 */
export const BROW_VERTEX = `${VERTEX_HEAD}
in vec4 hair; // along (0 root, 1 tip), side (-1, 1), strength, chance
in vec3 rootRows, rootShares, tipRows, tipShares;
uniform float brows; // 0 none, 1 bushy
uniform float pixel; // metres a pixel is wide, one metre away
uniform vec3 brow;
${LIGHTS}
out vec2 vAcross; // side, what is left of it where a pixel is wider
out float vAlong;
out vec3 vLight;

vec3 on(sampler2D rows, vec3 at, vec3 shares) {
  ivec3 row = ivec3(at + 0.5);
  return shares.x * texelFetch(rows, texelOf(row.x), 0).xyz + shares.y * texelFetch(rows, texelOf(row.y), 0).xyz
    + shares.z * texelFetch(rows, texelOf(row.z), 0).xyz;
}

void main() {
  float kept = smoothstep(0.0, 0.2, hair.z - mix(1.0, -0.12, brows)); // as \`browHairs\` of the painted brow
  if (kept <= 0.0) {
    gl_Position = vec4(2.0, 2.0, 2.0, 1.0); // nothing to draw
    return;
  }
  float t = hair.x;
  vec3 root = on(positions, rootRows, rootShares);
  vec3 normal = normalize(on(normals, rootRows, rootShares));
  vec3 way = (0.55 + 0.45 * kept) * (on(positions, tipRows, tipShares) - root);
  vec3 aside = cross(normal, way);
  float bow = 0.5 * (hair.w - 0.5);
  vec3 at = root + t * way + bow * t * (1.0 - t) * aside + normal * (0.0011 * t * (1.6 - t) - 0.0001);
  vec3 point = turned(at, 1.0);
  vec3 along = normalize(headTurn * (way + bow * (1.0 - 2.0 * t) * aside));
  vec3 facing = headTurn * normal;
  vec3 view = viewPoint - point;
  float wide = 0.000085 * (0.7 + 0.6 * fract(7.0 * hair.w)) * (1.0 - 0.75 * t * t);
  float least = 0.6 * pixel * length(view);
  vAcross = vec2(hair.y, min(wide / least, 1.0) * kept);
  vAlong = t;

  view = normalize(view);
  float sunlit = clamp((dot(facing, KEY) + 0.3) / 1.3, 0.0, 1.0); // cast shadows cost more here than all else, and hardly show
  vec3 diffuse = KEY_LIGHT * sunlit + FILL_LIGHT * clamp(dot(facing, FILL) * 0.5 + 0.5, 0.0, 1.0) + ambient(facing);
  float across = dot(along, normalize(KEY + view));
  float sheen = 1.0 - across * across;
  sheen *= sheen;
  sheen *= sheen;
  sheen *= sheen;
  sheen *= sheen; // to the power of 16
  vLight = brow * diffuse * mix(0.5, 0.95, t) + (0.02 + 0.1 * brow) * sheen * sunlit * KEY_LIGHT;
  gl_Position = project(point + normalize(cross(along, view)) * hair.y * max(wide, least));
}
`;

export const BROW_FRAGMENT = `${FRAGMENT_HEAD}
in vec2 vAcross;
in float vAlong;
in vec3 vLight;

void main() {
  float soft = 1.0 - smoothstep(0.4, 1.0, abs(vAcross.x));
  float alpha = soft * vAcross.y * (1.0 - 0.7 * smoothstep(0.6, 1.0, vAlong));
  if (alpha < 0.01) discard;
  colour = premultiplied(vLight, alpha);
}
`;
