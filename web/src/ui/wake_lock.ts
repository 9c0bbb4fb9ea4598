/** Keeps the screen on while a page is seen. */

import type { Drawing } from "../link/messages";

/** Whether the screen stays on: `insecure` where the address of the page forbids it, `""` while nobody has answered. */
export type Awake = NonNullable<Drawing["awake"]>;

/**
 * Asks the browser to keep the screen on, and again whenever the page is seen anew (what is hidden loses it) or clicked.
 * Browsers have it at https and on the machine itself alone.
 */
export class WakeLock {
  /** What became of it. */
  state: Awake = "";

  constructor() {
    for (const happens of ["visibilitychange", "click"]) document.addEventListener(happens, () => void this.#ask());
    void this.#ask();
  }

  async #ask(): Promise<void> {
    if (document.visibilityState !== "visible" || this.state === "kept") return;
    this.state = await this.#answer();
  }

  async #answer(): Promise<Awake> {
    if (!isSecureContext) return "insecure";
    try {
      const lock = await navigator.wakeLock.request("screen"); // an older browser has none: an error, as a refusal is
      lock.addEventListener("release", () => {
        this.state = "refused"; // until the page is seen anew
      });
      return "kept";
    } catch {
      return "refused";
    }
  }
}
