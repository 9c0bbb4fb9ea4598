/** Shaders of the lashes. */

import { EDGE_POINTS } from "../anatomy/openings";
import { FRAGMENT_HEAD, VERTEX_HEAD } from "../light/shader_prelude";

/**
 * Lashes: tapered ribbons that grow from the blended lids' edges, away from the eyeball, and bend: up on an open upper
 * lid, down on a closed one. A ribbon is never drawn narrower than a pixel; it fades instead, so that lashes seen from
 * afar are a shade and not a scatter of dots.
 */
export const LASH_VERTEX = `${VERTEX_HEAD}
uniform int edgeRows[${4 * EDGE_POINTS}]; // left upper, left lower, right upper, right lower
uniform int ballRows[4]; // opposite each other: on the left ball, on the right one
uniform float lashes; // how many, 0..1
uniform float pixel; // metres a pixel is wide, one metre away
uniform vec3 viewPoint;
in vec4 strand; // share of the edge from right to left, along (0 root, 1 tip), side (-1, 1), chance
in vec4 bend; // first row of its edge, where its clump meets, length (metres on an eye of 15 mm), upper (1) or lower (-1)
out vec2 vAcross; // side, what is left of it where a pixel is wider
out float vAlong;

vec3 edgeAt(int first, int n) { return rowAt(edgeRows[first + clamp(n, 0, ${EDGE_POINTS - 1})]); }

void main() {
  int first = int(bend.x + 0.5);
  bool left = first < ${2 * EDGE_POINTS};
  vec3 one = rowAt(ballRows[left ? 0 : 2]);
  vec3 other = rowAt(ballRows[left ? 1 : 3]);
  vec3 centre = 0.5 * (one + other);
  float size = distance(one, other) / 0.030;

  float place = strand.x * ${(EDGE_POINTS - 1).toFixed(1)};
  int n = int(place);
  float f = place - float(n);
  vec3 a = edgeAt(first, n - 1);
  vec3 b = edgeAt(first, n);
  vec3 c = edgeAt(first, n + 1);
  vec3 d = edgeAt(first, n + 2);
  vec3 root = b + 0.5 * f * (c - a + f * (2.0 * a - 5.0 * b + 4.0 * c - d + f * (3.0 * (b - c) + d - a)));
  vec3 tangent = normalize(edgeAt(first, ${EDGE_POINTS - 1}) - edgeAt(first, 0));

  bool above = bend.w > 0.0;
  vec3 facing = edgeAt(first + (above ? ${EDGE_POINTS} : -${EDGE_POINTS}), n);
  float open = clamp((root.y - facing.y) * bend.w / (0.42 * 0.015 * size), 0.0, 1.0);
  vec3 out_ = normalize(root - centre);
  vec3 up = normalize(cross(out_, tangent)) * bend.w;
  up *= dot(up, vec3(0.0, bend.w, 0.0)) < 0.0 ? -1.0 : 1.0;
  float kept = smoothstep(strand.w - 0.06, strand.w + 0.06, lashes * 1.12 - 0.06);
  if (!above) kept *= smoothstep(0.02, 0.25, open); // a closed upper lid lies over them
  float reach = bend.z * size * kept * (0.55 + 0.45 * lashes) * (above ? mix(0.8, 1.0, open) : 1.0);
  float t = strand.y;
  float fan = (strand.x - 0.5) * (above ? 0.95 : 0.8) + 0.4 * (strand.w - 0.5);
  float lift = above ? mix(-0.32, 0.85, open) : 0.55;
  vec3 at = root + reach * (out_ * (t * 0.95 - 0.35 * t * t) + up * (lift * t * t * (0.6 + 0.5 * t) + (above ? -0.22 : 0.12) * t) + tangent * fan * t * (0.4 + 0.6 * t));
  at += tangent * (bend.y - strand.x) * 0.034 * size * t * t;
  at += up * 0.0004 * size * (strand.w - 0.5);

  vec3 point = turned(at, 1.0);
  vec3 ahead = headTurn * normalize(out_ * (0.85 - 0.3 * t) + up * 2.0 * lift * t + tangent * fan);
  vec3 view = viewPoint - point;
  vec3 beside = normalize(cross(ahead, view));
  float wide = 0.00011 * size * (above ? 1.0 : 0.72) * (1.0 - t) * (1.0 - 0.25 * t) + 0.000004;
  float least = 0.62 * pixel * length(view);
  vAcross = vec2(strand.z, min(wide / least, 1.0) * kept);
  vAlong = t;
  gl_Position = project(point + beside * strand.z * max(wide, least));
}
`;

export const LASH_FRAGMENT = `${FRAGMENT_HEAD}
uniform vec3 brow;
in vec2 vAcross;
in float vAlong;

void main() {
  float soft = 1.0 - smoothstep(0.45, 1.0, abs(vAcross.x));
  float alpha = soft * vAcross.y * (1.0 - 0.6 * smoothstep(0.75, 1.0, vAlong));
  if (alpha < 0.01) discard;
  colour = premultiplied(brow * (0.06 + 0.05 * vAlong), alpha);
}
`;
