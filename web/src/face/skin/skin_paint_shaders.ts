/** The shader that paints the skin of one character: its colour without light, as it lies on the layers of the cast. */

import { SKIN_COLOURS } from "./skin_colour_shaders";

/** What the strongest oil on a skin is multiplied by, so that eight bits hold it finely. */
export const OILY = 4;

/**
 * Two pictures: the roots of the colour, and what light is left there; how oily it is, how much of it is lip, and the
 * strands that a scalp's hair is seen in. Hair on the scalp comes by the hairline of vertices, and so later.
 */
export const PAINT_FRAGMENT = `
precision highp float;
precision highp sampler2D;
in vec2 place;
layout(location = 0) out vec4 paint;
layout(location = 1) out vec4 sheen;
uniform float gloss;
vec4 layer(sampler2D picture) { return texture(picture, place); }
${SKIN_COLOURS}
void main() {
  vec4 marked = layer(marks);
  Layers layers = Layers(layer(mask), marked, layer(patches), vec4(0.45, 0.2, 1.0, 0.5), layer(pelt));
  Ground at = ground(layers, 0.0);
  float oil = (0.05 + 0.13 * at.lips * gloss + 0.06 * lacquer) * (1.0 - at.hair) * (1.0 - 0.7 * at.fur);
  paint = vec4(sqrt(at.albedo), at.left);
  sheen = vec4(${OILY.toFixed(1)} * oil, at.lips, marked.a, 1.0);
}
`;
