/** A list that is scrolled: which of its pictures lie in sight, and how a row is brought there. */

/** Pictures that lie in sight, each told when it comes there. */
export class PicturesInSight<Picture extends Element> {
  readonly #sight = new Set<Element>();
  #watch: IntersectionObserver | null = null;

  constructor(private readonly seen: (picture: Picture) => void) {}

  /** Looks after these pictures; those in sight are told at once, others when they are scrolled to. */
  watch(pictures: Iterable<Picture>): void {
    this.#watch ??= new IntersectionObserver((entries) => this.#see(entries));
    for (const picture of this.#sight) if (!picture.isConnected) this.#sight.delete(picture);
    for (const picture of pictures) {
      if (this.#sight.has(picture)) this.seen(picture);
      else this.#watch.observe(picture);
    }
  }

  stop(): void {
    this.#watch?.disconnect();
    this.#watch = null;
  }

  #see(entries: readonly IntersectionObserverEntry[]): void {
    for (const { target, isIntersecting } of entries) {
      if (isIntersecting) this.#sight.add(target);
      else this.#sight.delete(target);
      if (isIntersecting) this.seen(target as Picture);
    }
  }
}

type Box = Pick<Element, "getBoundingClientRect">;

/** Scrolls a list, and nothing around it, by as little as brings a row of it into sight. */
export function scrollToRow(list: Box & { scrollTop: number }, row: Box): void {
  const [inner, outer] = [row.getBoundingClientRect(), list.getBoundingClientRect()];
  if (inner.bottom > outer.bottom) list.scrollTop += inner.bottom - outer.bottom;
  else if (inner.top < outer.top) list.scrollTop -= outer.top - inner.top;
}
