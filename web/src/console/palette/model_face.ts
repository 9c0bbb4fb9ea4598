/** Which face the expressions of a palette are drawn on. */

/** How long a face must be called or alone on air before the expressions are drawn anew on it, in milliseconds. */
const SETTLED = 250;

/** Follows the face that is called, else the one that stands alone on air: a call that another follows at once passes. */
export class ModelFace {
  #candidate: [string, number] = ["", 0];

  constructor(private model: string) {}

  /** The model at `now`, milliseconds, while these faces are on air; `called`: the one that is on its way, null for none. */
  follow(faces: Readonly<Record<string, number>>, called: string | null, now: number): string {
    const [first] = Object.entries(faces).filter(([, weight]) => weight > 0.999);
    const wanted = called ?? first?.[0];
    if (wanted === undefined || wanted !== this.#candidate[0]) this.#candidate = [wanted ?? "", now];
    else if (now - this.#candidate[1] > SETTLED) this.model = wanted;
    return this.model;
  }
}
