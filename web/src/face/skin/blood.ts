/** Blood in the skin, and tears and sweat on it, as the shaders take them. */

import * as THREE from "three";
import { BLOOD_SPOTS } from "../../link/constants";
import type { SkinTraits } from "./skin_layers";

/** What of the blood lies in spots, in the order of their attribute (`blood_spots.ts`). */
type Spot = keyof typeof BLOOD_SPOTS;
const SPOTS = Object.keys(BLOOD_SPOTS) as Spot[];

/** Blood by part of the face, tears, sweat, and the metres that these have run. */
type ShownBlood = Readonly<Record<Spot | "whole" | "tears" | "sweat" | "drops", number>>;

/** How much of its blood shows through a fur. */
const THROUGH_FUR = 0.35;

/** The uniforms of blood, tears and sweat. */
export const bloodUniforms = () => ({
  blood: { value: new THREE.Vector4() }, // of the spots
  flush: { value: 0 }, // of the whole face
  tears: { value: 0 },
  sweat: { value: 0 },
  drops: { value: 0 }, // metres
});

export type BloodUniforms = ReturnType<typeof bloodUniforms>;

/** Writes a complexion for the next frame; lacquer hides all of it, and a fur most and all sweat. */
export function writeBlood(
  shown: ShownBlood,
  { lacquer, fur }: Pick<SkinTraits, "lacquer" | "fur">,
  into: BloodUniforms,
) {
  const bare = (1 - lacquer) * (1 - (1 - THROUGH_FUR) * fur);
  into.blood.value.fromArray(SPOTS.map((spot) => bare * shown[spot]));
  into.flush.value = bare * shown.whole;
  into.tears.value = shown.tears * (1 - lacquer);
  into.sweat.value = shown.sweat * (1 - lacquer) * (1 - fur);
  into.drops.value = shown.drops;
}

/** Blood at a vertex, and the colour that it takes from the skin's own: in proportion, so that dark skin deepens and does not turn pink. */
export const BLOOD = `
in vec4 spots; // cheeks, nose, forehead, around the eyes
uniform vec4 blood;
uniform float flush;

float bloodAt(float pressed) { return clamp(flush + dot(spots, blood) + pressed, -0.8, 1.4); }
`;
export const FLUSHED = `
/** Skin without blood is sallow, not green. */
vec3 flushed(float blood) { return exp(-blood * (blood > 0.0 ? vec3(0.06, 0.43, 0.36) : vec3(0.16, 0.38, 0.42))); }
`;
