/** What of the faces is still being fetched, as a bar with words, until the first picture of all of them; and the sign
 * that a new one is made. */

import { css, html, LitElement, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { type Download, downloads } from "../../link/fetch_progress";
import { base } from "../../ui/theme";
import { whileShown } from "../../ui/topic_element";
import { progressOf } from "../session/loading_progress";

/** Milliseconds of work that nobody is told of. */
const UNSEEN = 500;

const loadingViewStyle = css`
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
    color: var(--dim);
    text-align: center;
  }
`;

/** Shown over the canvas until it has drawn what was asked for. */
@customElement("omote-loading")
export class LoadingView extends LitElement {
  /** How many faces are to be shown. */
  @property({ type: Number }) faces = 1;
  /** What had come before this was shown. */
  #before: ReadonlySet<Download> = new Set();
  #share = 0;

  static override styles = [base, loadingViewStyle];

  constructor() {
    super();
    whileShown(this, () => {
      this.#before = new Set(downloads.all.filter(({ ended }) => ended));
      return downloads.listen(() => this.requestUpdate());
    });
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

const makingViewStyle = css`
  :host {
    position: absolute;
    left: 12px;
    top: 12px; /* below are labels */
    pointer-events: none;
  }
  p {
    padding: 6px 12px;
    border-radius: 6px;
    color: var(--text);
    background: #111315e0;
    border: 1px solid var(--line);
  }
  p::before {
    content: "";
    display: inline-block;
    width: 10px;
    height: 10px;
    margin-right: 8px;
    border-radius: 50%;
    border: 2px solid var(--dim);
    border-top-color: var(--text);
    animation: turn 1s linear infinite;
  }
  @keyframes turn {
    to {
      transform: rotate(1turn);
    }
  }
  @media (prefers-reduced-motion: reduce) {
    p::before {
      animation: none;
    }
  }
`;

/** Shown on the canvas while the face on it is the one before, and the new one is made. */
@customElement("omote-making")
export class MakingView extends LitElement {
  @state() private overdue = false;

  static override styles = [base, makingViewStyle];

  constructor() {
    super();
    whileShown(this, () => {
      const timer = setTimeout(() => {
        this.overdue = true;
      }, UNSEEN);
      return () => clearTimeout(timer);
    });
  }

  override render() {
    return html`<div role="status">${this.overdue ? html`<p>Making the face</p>` : nothing}</div>`;
  }
}
