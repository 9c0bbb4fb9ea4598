/** The long requests of a page, over it: what each is, how far it is, and a button that ends it. */

import { css, html, LitElement, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { type LongRequest, type LongRequests, progressWords } from "./long_requests";
import { base, ellipsis, notice, palette } from "./theme";
import { whileShown } from "./topic_element";

const style = css`
  :host {
    position: fixed;
    z-index: 6;
    bottom: 12px;
    left: 50%;
    width: min(440px, 100vw - 16px);
    transform: translateX(-50%);
    pointer-events: none;
  }
  [role="group"] {
    ${notice}
    grid-template-columns: minmax(0, 1fr) auto;
    align-items: center;
    gap: 6px 12px;
    padding: 8px 8px 8px 12px;
    background: #1d2126;
    border: 1px solid var(--edge);
    pointer-events: auto;
  }
  [role="group"] + [role="group"] {
    margin-top: 6px;
  }
  span {
    ${ellipsis}
  }
  small {
    color: var(--dim);
  }
  progress {
    width: 100%;
    height: 6px;
  }
  button {
    grid-row: 1 / span 3;
    grid-column: 2;
    min-height: 32px;
  }
  @media (pointer: coarse) {
    button {
      min-height: 44px;
    }
  }
`;

@customElement("omote-long-requests")
export class LongRequestsView extends LitElement {
  static override styles = [palette, base, style];

  constructor(private readonly requests: LongRequests) {
    super();
    whileShown(this, () => requests.listen(() => this.requestUpdate()));
  }

  override render() {
    return this.requests.all.length === 0 ? nothing : this.requests.all.map((request) => this.#row(request));
  }

  #row(request: LongRequest) {
    const words = progressWords(request);
    return html`<div role="group" aria-label=${request.title}>
      <span>${request.title}</span>
      <progress aria-label=${request.title} max=${Math.max(1, request.total)} .value=${share(request)}></progress>
      <span><small role="status">${words}</small></span>
      <button ?disabled=${request.ending} aria-label="Cancel: ${request.title}" @click=${() => this.requests.cancel(request.id)}>
        Cancel
      </button>
    </div>`;
  }
}

const share = ({ done, total }: LongRequest): number | null => (total === 0 ? null : done);
