/** What can be done about the console's notice: links and buttons beside its words. */

import { css, html } from "lit";
import { EDITOR_TAB } from "../../link/editor_address";
import type { NoticeStore, Offer } from "../store/notice_store";

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
`;

export const offersOf = ({ offers }: NoticeStore) => offers.map(offerView);

const offerView = (offer: Offer) =>
  "address" in offer
    ? html`<a class="offer" href=${offer.address} target=${EDITOR_TAB}>${offer.label}</a>`
    : html`<button class="offer" @click=${offer.act}>${offer.label}</button>`;
