/** The tone curve, and the sRGB transfer function. */

/** A direction or a colour in linear light. */
export type Triple = readonly [number, number, number];

/** The film's curve x (x + a) / (x (b x + c) + d): a short toe, grey where it was, a long shoulder up to 1 / b. */
const FILM = { a: 0.266, b: 0.97, c: 0.456, d: 0.3327 };

/** Light of one channel as the film shows it, both linear: 0.18 stays, everything else ends below 1 / b. */
export const filmed = (x: number): number => (x * (x + FILM.a)) / (x * (FILM.b * x + FILM.c) + FILM.d);

/** A linear colour in the display's values (sRGB), 0..1. */
export const encodeSrgb = (colour: Triple): Triple =>
  colour.map((x) => (x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055)) as unknown as Triple;

/** A colour of the display, "#rrggbb", in linear light. */
export const decodeSrgb = (hex: string): Triple =>
  [1, 3, 5].map((at) => {
    const x = Number.parseInt(hex.slice(at, at + 2), 16) / 255;
    return x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;
  }) as unknown as Triple;

/**
 * `display(light)`: linear light to the display. The film's curve, part of each channel and part of the strongest, so
 * that bright skin keeps its hue and only what is brightest goes white; no logarithms, for software renderers.
 */
export const TONE = `
uniform float EXPOSURE;

vec3 filmed(vec3 x) { return x * (x + ${FILM.a}) / (x * (${FILM.b} * x + ${FILM.c}) + ${FILM.d}); }

vec3 display(vec3 light) {
  vec3 x = max(light * EXPOSURE, 0.0);
  float peak = max(max(x.r, x.g), max(x.b, 1e-5));
  float top = filmed(vec3(peak)).r;
  vec3 kept = mix(x * (top / peak), vec3(top), 0.7 * smoothstep(0.75, 1.0, top));
  vec3 shown = mix(filmed(x), kept, 0.6);
  vec3 root = sqrt(shown); // the sRGB curve by square roots
  vec3 fourth = sqrt(root);
  shown = 0.585122381 * root + 0.783140355 * fourth - 0.368262736 * sqrt(fourth);
#ifndef FAST
  shown += (fract(52.9829189 * fract(dot(gl_FragCoord.xy, vec2(0.06711056, 0.00583715)))) - 0.5) / 255.0; // against bands
#endif
  return clamp(shown, 0.0, 1.0);
}
`;
