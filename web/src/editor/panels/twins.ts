/** The muscle on the other side of the face, by name; one on the midline is its own twin. */
export const mirrorMuscle = (name: string): string =>
  name.replace(/_(left|right)$/, (_, side: string) => (side === "left" ? "_right" : "_left"));
