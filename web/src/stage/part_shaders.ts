import { FRAGMENT_HEAD, VERTEX_HEAD } from "./shader_heads";

/** Eyeballs: the true sphere under each pixel, white, iris and pupil by the angle from the line of sight. */
export const EYE_VERTEX = `${VERTEX_HEAD}
out vec3 vPoint;

void main() {
  vPoint = turned(fetchRow(positions), 1.0);
  gl_Position = project(vPoint);
}
`;

export const EYE_FRAGMENT = `${FRAGMENT_HEAD}
uniform vec3 centre; // in the world
uniform float radius;
uniform mat3 eyeTurn; // eye to world
uniform mat3 headTurn;
uniform vec3 iris;
uniform sampler2D grain;
in vec3 vPoint;

void main() {
  vec3 view = normalize(cameraPosition - vPoint);
  vec3 from = vPoint - centre;
  float b = dot(from, view);
  float inside = b * b - dot(from, from) + radius * radius;
  vec3 normal = normalize(from + view * (inside > 0.0 ? sqrt(inside) - b : 0.0));
  vec3 local = normal * eyeTurn; // transposed: world to eye
  float angle = acos(clamp(local.z, -1.0, 1.0)) / 0.43; // 1 at the iris' edge
  float spoke = texture(grain, vec2(atan(local.y, local.x) * 0.9549, angle * 0.22)).r - 0.5;
  float pupil = 1.0 - smoothstep(0.36, 0.43, angle);
  float disc = 1.0 - smoothstep(0.94, 1.04, angle);
  float limbus = smoothstep(0.72, 0.98, angle);

  vec3 white = vec3(0.80, 0.76, 0.72) - vec3(0.02, 0.16, 0.15) * smoothstep(1.1, 2.4, angle);
  vec3 fibres = iris * (0.95 + 2.0 * spoke) * (1.0 - 0.9 * limbus * limbus);
  fibres += iris * vec3(0.8, 0.65, 0.45) * smoothstep(0.72, 0.42, angle); // brighter around the pupil
  vec3 albedo = mix(white, mix(fibres, vec3(0.004), pupil), disc);

  vec3 upright = normal * headTurn; // in the head's frame
  float lidShadow = mix(0.22, 1.0, smoothstep(0.50, -0.05, upright.y)) * smoothstep(-0.15, 0.70, upright.z);
  lidShadow = shaded(lidShadow);
  float key = clamp(dot(normal, KEY) * 0.75 + 0.25, 0.0, 1.0);
  vec3 light = albedo * (KEY_LIGHT * key * 0.62 + FILL_LIGHT * 0.6 + 1.6 * ambient(normal)) * lidShadow;
  // the light on the far side of the cornea, as a lens gathers it
  light += iris * KEY_LIGHT * disc * (1.0 - pupil) * 0.35 * max(dot(local.xy, -(KEY * eyeTurn).xy), 0.0) * lidShadow;
  vec3 bulge = normalize(normal + 0.35 * disc * (normal - (eyeTurn * vec3(0.0, 0.0, 1.0))));
  light += KEY_LIGHT * (2.6 * shine(bulge, view, KEY, 420.0) + 0.10 * shine(normal, view, KEY, 60.0));
  light += FILL_LIGHT * 1.2 * shine(bulge, view, FILL, 500.0);
  colour = premultiplied(light, 1.0);
}
`;

/** The tongue: darker the deeper it lies in the mouth. */
export const MOUTH_VERTEX = `${VERTEX_HEAD}
in vec3 place; // depth in the mouth, angle on the arch, height from the gum (0) to the edge (1)
out vec3 vPoint;
out vec3 vNormal;
out vec3 vPlace;

void main() {
  vPoint = turned(fetchRow(positions), 1.0);
  vNormal = turnedNormal(fetchRow(normals), 1.0);
  vPlace = place;
  gl_Position = project(vPoint);
}
`;

const MOUTH_HEAD = `${FRAGMENT_HEAD}
in vec3 vPoint;
in vec3 vNormal;
in vec3 vPlace;

vec3 lit(vec3 albedo, float wet) {
  vec3 view = normalize(cameraPosition - vPoint);
  vec3 normal = normalize(gl_FrontFacing ? vNormal : -vNormal);
  float open = pow(clamp(1.0 - vPlace.x, 0.0, 1.0), 2.0);
  float key = clamp((dot(normal, KEY) + 0.7) / 1.7, 0.0, 1.0);
  vec3 light = albedo * (KEY_LIGHT * key * 0.85 + FILL_LIGHT * 0.5 + ambient(normal)) * open;
  return light + KEY_LIGHT * wet * shine(normal, view, KEY, 50.0) * open;
}
`;

export const TONGUE_FRAGMENT = `${MOUTH_HEAD}
void main() {
  float furrow = 1.0 - 0.35 * exp(-pow(vPlace.y / 0.09, 2.0));
  colour = premultiplied(lit(vec3(0.36, 0.085, 0.08) * furrow * (1.0 - 0.6 * vPlace.x), 0.10), 1.0);
}
`;

/** Teeth: grooves between them by the angle on the arch, gum above. */
export const TEETH_FRAGMENT = `${MOUTH_HEAD}
void main() {
  float tooth = fract(vPlace.y / 0.235) * 2.0 - 1.0;
  float groove = smoothstep(0.72, 1.0, abs(tooth));
  float gum = smoothstep(0.06, -0.06, vPlace.z - 0.40 - 0.10 * tooth * tooth);
  vec3 enamel = vec3(1.05, 0.97, 0.84) * (1.0 - 0.55 * groove) * mix(0.85, 1.0, vPlace.z);
  colour = premultiplied(lit(mix(enamel, vec3(0.42, 0.13, 0.12), gum), 0.20), 1.0);
}
`;

/** Lashes: dark strands that thin out towards their tips. */
export const LASH_VERTEX = `${VERTEX_HEAD}
in vec3 strand; // along the lid, from root (0) to tip (1), upper (1) or lower (0) lid
out vec3 vStrand;

void main() {
  vStrand = strand;
  gl_Position = project(turned(fetchRow(positions), 1.0));
}
`;

export const LASH_FRAGMENT = `${FRAGMENT_HEAD}
uniform vec3 brow;
in vec3 vStrand;

void main() {
  float id = floor(vStrand.x);
  float chance = fract(sin(id * 91.7) * 4375.85);
  float lean = (chance - 0.5) * 0.9 * vStrand.y;
  float across = abs(fract(vStrand.x) - 0.5 + lean) * 2.0;
  float tip = vStrand.y / mix(0.35 + 0.30 * chance, 0.62 + 0.38 * chance, vStrand.z);
  float width = mix(0.34, 0.55, vStrand.z) * (1.0 - tip * tip);
  float alpha = smoothstep(width + 0.25, width - 0.10, across) * (1.0 - smoothstep(0.75, 1.0, tip)) * step(-0.3, vStrand.y);
  float even = max(width, 0.0) * mix(0.85, 1.3, vStrand.z) * (1.0 - smoothstep(0.75, 1.0, tip)) * step(-0.3, vStrand.y);
  alpha = mix(alpha, even, smoothstep(0.3, 0.9, fwidth(vStrand.x))); // from afar a shade, not a scatter of dots
  alpha *= mix(0.5, 1.0, vStrand.z);
  if (alpha < 0.02) discard;
  colour = premultiplied(brow * 0.08, alpha);
}
`;
