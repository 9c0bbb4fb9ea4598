/** Which layer of the texture array holds which blendshape (least recently used goes first). */

/** Which layer of the texture array holds what: free ones first, then the least recently used gives way. */
export class LayerTable {
  private readonly layers = new Map<string, number>(); // in order of use, oldest first
  private used = 0;

  /** Layers below `preferred` are reused before more are opened, up to `limit`. */
  constructor(
    readonly preferred: number,
    readonly limit: number,
  ) {}

  has(key: string): boolean {
    return this.layers.has(key);
  }

  /** The layer that holds `key`, undefined when none does; counts as a use. */
  use(key: string): number | undefined {
    const layer = this.layers.get(key);
    if (layer === undefined) return undefined;
    this.layers.delete(key);
    this.layers.set(key, layer);
    return layer;
  }

  /** A layer for `key`; one that holds a key of `keep` never gives way; undefined when all are kept. */
  take(key: string, keep: ReadonlySet<string>): number | undefined {
    const layer = this.fresh(this.preferred) ?? this.evict(keep) ?? this.fresh(this.limit);
    if (layer !== undefined) this.layers.set(key, layer);
    return layer;
  }

  private fresh(below: number): number | undefined {
    if (this.used >= below) return undefined;
    this.used += 1;
    return this.used - 1;
  }

  private evict(keep: ReadonlySet<string>): number | undefined {
    for (const [key, layer] of this.layers) {
      if (keep.has(key)) continue;
      this.layers.delete(key);
      return layer;
    }
    return undefined;
  }
}
