/** What is said of a face from photographs, in sentences. */

import type { SeenPhotographs } from "./photograph_document";

/** What one photograph can say, and what it cannot. */
const ONE =
  "One photograph knows the colours of what it shows, and how wide and tall the face is; it cannot know the profile.";

/** What was seen, and how far the face may be off. */
export function knowledgeOf({ off, seen, spread }: SeenPhotographs): string {
  const shown = `The photographs show ${Math.round(100 * seen)} % of the skin; the rest is made up in its colours.`;
  const shape = `The shape may be ${spread.toFixed(1)} mm off, as far as people are alike.`;
  return off.length === 1
    ? `${ONE} ${shown.replace("photographs show", "photograph shows")} ${shape}`
    : `${shown} ${shape}`;
}

/** What to do now. */
export function photographAdvice({ doubts }: Pick<SeenPhotographs, "doubts">, changed: boolean): string {
  if (changed) return "Press Fit again when the points are where they belong.";
  if (doubts.length === 0)
    return "The photographs fit together. Compare the three sides with the person, then take it.";
  return "Omote is not sure. Look at the three sides and at the points on each photograph; drag those that are off.";
}

/** Of a photograph without a face. */
export const noFace = (name: string): string =>
  `No face was found in ${name}: it is left out. The face should be large, in even light, and turned no further than to the ear.`;
