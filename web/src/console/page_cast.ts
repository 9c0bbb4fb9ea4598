/** The cast that a page has fetched, and takes in anew where the show has another. */

import { Library } from "../link/assets";
import type { Thumbnails } from "../ui/thumbnails";
import type { ConsoleStore } from "./store/console_store";
import { openThumbnails } from "./thumbnail_drawing";

export class PageCast {
  /** What the page has fetched; none before the server has answered. */
  #library: Library | null = null;
  /** It may be another than was fetched: the server said so meanwhile. */
  #stale = false;

  constructor(private readonly store: ConsoleStore) {}

  /** Fetches it; `before`: what comes before the page shows it. */
  async open(before: () => Promise<void>): Promise<Library> {
    const library = await Library.open();
    this.#library = library;
    await before();
    this.store.setManifest(library.manifest);
    if (this.#stale) void this.renew();
    return library;
  }

  /** The show has said which cast it plays. */
  welcome(digest: string): void {
    const { manifest } = this.store;
    if (manifest !== null && manifest.digest !== digest) void this.renew();
  }

  /** The cast is another: takes it in and goes on; a page of another built-in cast must begin anew. */
  async renew(): Promise<void> {
    const library = this.#library;
    this.#stale = library === null;
    if (library === null) return;
    if (!(await library.renew())) location.reload();
    else if (library.manifest !== this.store.manifest) this.store.setManifest(library.manifest);
  }

  /** Draws pictures of it, once they can be drawn; without them names and hot keys are enough to play. */
  openThumbnails(thumbnails: Thumbnails): void {
    if (this.#library === null) return;
    openThumbnails(this.#library).then(
      (draw) => thumbnails.open(draw),
      (error: unknown) => console.warn("No thumbnails:", error),
    );
  }
}
