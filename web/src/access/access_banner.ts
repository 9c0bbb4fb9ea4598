/** A bar at the foot of a page that says what this page's role may not. */

import { css, html, LitElement } from "lit";
import { customElement, property } from "lit/decorators.js";
import { palette } from "../ui/theme";

const style = css`
  :host {
    position: fixed;
    inset: auto 0 0 0;
    z-index: 5;
    padding: 8px 14px;
    font: 13px/1.4 system-ui, sans-serif;
    text-align: center;
    color: var(--ground);
    background: var(--attention);
  }
`;

@customElement("omote-access-banner")
export class AccessBanner extends LitElement {
  @property() sentence = "";

  static override styles = [palette, style];

  override render() {
    return html`<div role="status">${this.sentence}</div>`;
  }
}

/** Adds the bar to the page, where there is something to be said. */
export function showAccess(sentence: string | null): void {
  if (sentence === null) return;
  const banner = new AccessBanner();
  banner.sentence = sentence;
  document.body.append(banner);
}
