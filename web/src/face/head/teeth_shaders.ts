/** Shaders of the teeth's sheet: gums, crowns, palate and floor. */

import { MOUTH_HEAD, MOUTH_LIGHT } from "./mouth_shaders";
import { COLUMN_ROWS, COLUMNS } from "./teeth_cage";

/**
 * A vertex keeps its place in the cage (`CagePlace`): a spline along the arch of what stands between the four rows of a
 * column. It is a sum of rows with weights of sum 1, so whatever moves the rows as a whole moves it along.
 */
export const SHEET_VERTEX = `${MOUTH_LIGHT}
uniform int cage[${COLUMN_ROWS * COLUMNS}]; // gum, middle, edge, behind of each column
uniform float milk;
in vec3 personPlace; // column, up, inward
in vec3 personFacing;
in vec3 milkPlace;
in vec3 milkFacing;
in vec3 carnivorePlace;
in vec3 carnivoreFacing;
in vec4 marks; // height, running number of the tooth, share of the other side, height among milk teeth
out vec2 vMarks;
out vec3 vAlong; // to the character's left
out vec3 vRise; // to the gum

/** A place in the cage, and the steps that lead away from it. */
struct Place { vec3 point; vec3 along; vec3 up; vec3 inward; };

Place placeAt(float column, float up, float inward) {
  int first = min(int(column), ${COLUMNS - 2});
  float t = column - float(first);
  vec4 shares = vec4(t * (-0.5 + t * (1.0 - 0.5 * t)), 1.0 + t * t * (1.5 * t - 2.5), t * (0.5 + t * (2.0 - 1.5 * t)), t * t * (0.5 * t - 0.5));
  vec4 slopes = vec4(-0.5 + t * (2.0 - 1.5 * t), t * (4.5 * t - 5.0), 0.5 + t * (4.0 - 4.5 * t), t * (1.5 * t - 1.0));
  Place place = Place(vec3(0.0), vec3(0.0), vec3(0.0), vec3(0.0));
  for (int n = 0; n < 4; n++) {
    int row = ${COLUMN_ROWS} * clamp(first - 1 + n, 0, ${COLUMNS - 1});
    vec3 edge = rowAt(cage[row + 2]);
    vec3 rise = rowAt(cage[row]) - edge;
    vec3 back = rowAt(cage[row + 3]) - rowAt(cage[row + 1]);
    vec3 here = edge + up * rise + inward * back;
    place.point += shares[n] * here;
    place.along += slopes[n] * here;
    place.up += shares[n] * rise;
    place.inward += shares[n] * back;
  }
  return place;
}

void main() {
  vec3 at = mix(mix(personPlace, milkPlace, milk), carnivorePlace, fur);
  vec3 facing = mix(mix(personFacing, milkFacing, milk), carnivoreFacing, fur);
  Place place = placeAt(at.x, at.y, at.z);
  vec3 here = place.point;
  vec3 normal = facing.x * cross(place.up, place.inward) + facing.y * cross(place.inward, place.along) + facing.z * cross(place.along, place.up);
  if (marks.z > 0.0) {
    here = mix(here, placeAt(${(COLUMNS - 1).toFixed(1)} - at.x, at.y, at.z).point, marks.z);
    normal = -place.up;
  }
  vPoint = turned(here, 1.0);
  vNormal = turnedNormal(normalize(normal), 1.0);
  vAlong = turnedNormal(normalize(place.along), 1.0);
  vRise = turnedNormal(normalize(place.up), 1.0);
  vMarks = vec2(mix(marks.x, marks.w, milk * (1.0 - fur)), marks.y);
  vLight = lightAt(here);
  gl_Position = project(vPoint);
}
`;

/** Enamel, gums and mucosa by height; each tooth has its own tone and its own round. */
export const SHEET_FRAGMENT = `${MOUTH_HEAD}
uniform float age, fur;
in vec2 vMarks;
in vec3 vAlong;
in vec3 vRise;

void main() {
  float height = vMarks.x;
  float across = 2.0 * fract(vMarks.y) - 1.0;
  float sides = across * across;
  float number = floor(vMarks.y);
  float fromMiddle = abs(number - 6.5) - 0.5;
  float gum = 1.0 - smoothstep(-0.02, 0.02, height);
  vec4 bumps = texture(grain, vec2(vMarks.y * 0.9, height * 0.7)) - 0.5;
  vec3 normal = facing();
  vec3 along = normalize(vAlong);
  vec3 rise = normalize(vRise);
  float round_ = across * (0.30 + 0.45 * sides) * mix(1.0, 1.8, fur);
  normal = normalize(normal + (1.0 - gum) * round_ * along + gum * 0.18 * (bumps.r * along + bumps.g * rise));

  float tone = fract(sin(number * 12.9) * 43.7) - 0.5;
  float canine = 1.0 - smoothstep(0.0, 0.6, abs(fromMiddle - 2.0));
  vec3 enamel = mix(vec3(0.79, 0.68, 0.52), vec3(0.90, 0.85, 0.76), smoothstep(-0.05, 0.5, height));
  enamel = mix(enamel, mix(vec3(0.82, 0.72, 0.55), vec3(0.91, 0.87, 0.79), smoothstep(0.0, 0.4, height)), fur);
  enamel *= mix(vec3(1.0), vec3(0.965, 0.93, 0.85), canine * (1.0 - fur));
  float thin = (1.0 - fur) * (1.0 - smoothstep(1.2, 1.8, fromMiddle)) * smoothstep(0.74 + 0.10 * bumps.b - 0.06 * sides, 0.98, height);
  enamel = mix(enamel, vec3(0.50, 0.53, 0.56), 0.55 * thin); // the edge of incisors lets the dark through
  enamel *= mix(vec3(1.0), vec3(0.95, 0.88, 0.73), age) * (1.0 + vec3(0.10, 0.11, 0.14) * tone);
  enamel *= mix(vec3(1.0), vec3(0.50, 0.36, 0.29), smoothstep(0.62, 1.0, abs(across)) * smoothstep(0.0, 0.15, height)); // light between teeth went through them
  vec3 pink = mix(vec3(0.56, 0.235, 0.22), vec3(0.46, 0.13, 0.12), smoothstep(0.1, 0.7, -height)) * (1.0 + 0.35 * bumps.b);
  vec3 albedo = mix(enamel, pink, gum);
  albedo *= mix(0.62, 1.0, smoothstep(0.0, 0.09, abs(height))); // where the gum begins
  albedo *= mix(vec3(1.0), mix(vec3(0.36, 0.27, 0.23), vec3(1.0), fur), smoothstep(1.5, 6.0, fromMiddle)); // cheeks lie close to a person's back teeth
  vec3 film = normalize(normal + (1.0 - gum) * (1.2 * (0.60 - height) * rise + (0.25 * round_ + 0.3 * tone) * along + 0.10 * (bumps.r * along + bumps.a * rise)));
  float direct = keyAt(normal);
  vec3 light = lit(albedo, normal, mix(0.42, 0.35, gum), mix(0.16, 0.24, gum), direct);
  colour = premultiplied(light + wetness(film, mix(0.75 + 0.8 * tone, 0.5, gum), direct), 1.0);
}
`;
