/** What can be done about the console's notice: links and buttons beside its words. */

import { css, html, nothing } from "lit";
import { EDITOR_TAB } from "../../link/editor_address";
import type { Offer, PageStore } from "../store/page_store";

export const offersStyle = css`
  .offer {
    display: inline-block;
    min-height: 0;
    margin-left: 6px;
    padding: 6px 4px;
    color: var(--focus);
    background: none;
    border: 0;
    text-decoration: underline;
  }
  .away {
    color: inherit;
    text-decoration: none;
  }
`;

/** The offers of the notice; what has any stays, so it can be put away too. */
export const offersOf = (store: PageStore) => viewOffers(store.offers, () => store.say(null));

/** Offers beside words, and a cross that puts them away. */
export const viewOffers = (offers: readonly Offer[], dismiss: () => void) =>
  offers.length === 0
    ? nothing
    : html`${offers.map(offerView)}<button class="offer away" title="I have read it" aria-label="Dismiss" @click=${dismiss}>✕</button>`;

const offerView = (offer: Offer) =>
  "address" in offer
    ? html`<a class="offer" href=${offer.address} target=${offer.tab ?? EDITOR_TAB}>${offer.label}</a>`
    : html`<button class="offer" @click=${offer.act}>${offer.label}</button>`;
