/** What of the faces is still being fetched, as a bar with words, until the first picture of all of them. */

import { css, html, LitElement } from "lit";
import { customElement, property } from "lit/decorators.js";
import { type Download, downloads } from "../../link/fetch_progress";
import { base } from "../../ui/theme";
import { progressOf } from "../session/loading_progress";

/** Shown over the canvas until it has drawn what was asked for. */
@customElement("omote-loading")
export class LoadingView extends LitElement {
  /** How many faces are to be shown. */
  @property({ type: Number }) faces = 1;
  #deaf: () => void = () => undefined;
  /** What had come before this was shown. */
  #before: ReadonlySet<Download> = new Set();
  #share = 0;

  static override styles = [
    base,
    css`
      :host {
        position: absolute;
        inset: 0;
        display: grid;
        place-content: center;
        justify-items: center;
        gap: 10px;
        background: #111315;
        animation: appear 0.25s steps(1, jump-none);
      }
      /* What comes at once is not announced. */
      @keyframes appear {
        from {
          opacity: 0;
        }
      }
      progress {
        width: min(280px, 70%);
        height: 6px;
        accent-color: var(--text);
      }
      p {
        margin: 0;
        color: var(--dim);
        text-align: center;
      }
    `,
  ];

  override connectedCallback(): void {
    super.connectedCallback();
    this.#before = new Set(downloads.all.filter(({ ended }) => ended));
    this.#deaf = downloads.listen(() => this.requestUpdate());
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#deaf();
  }

  override render() {
    const { share, words } = progressOf(
      downloads.all.filter((download) => !this.#before.has(download)),
      this.faces,
    );
    this.#share = Math.max(this.#share, share); // what comes to light late takes nothing back
    return html`<p role="status">${words}</p>
      <progress aria-label="Loading the faces" max="1" .value=${this.#share}></progress>`;
  }
}
