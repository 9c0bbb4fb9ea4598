/** Which face the expressions of a palette are drawn on. */

/** How long a face must be alone on air before the expressions are drawn anew on it, in milliseconds. */
const SETTLED = 800;

/** Follows the face on air once it stands there alone for a while. */
export class ModelFace {
  #candidate: [string, number] = ["", 0];

  constructor(private model: string) {}

  /** The model at `now`, milliseconds, while these faces are on air; `calling`: another is on its way. */
  follow(faces: Readonly<Record<string, number>>, calling: boolean, now: number): string {
    const [first] = Object.entries(faces).filter(([, weight]) => weight > 0.999);
    const alone = calling ? undefined : first?.[0];
    if (alone === undefined || alone !== this.#candidate[0]) this.#candidate = [alone ?? "", now];
    else if (now - this.#candidate[1] > SETTLED) this.model = alone;
    return this.model;
  }
}
