/** The stages of a show, and which of their screens may go to sleep. */

import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import type { StageReport } from "../../link/messages";
import { base, selectable } from "../../ui/theme";
import type { Topic } from "../store/page_store";
import { DevicesElement, section } from "./devices_element";

/** What a stage says of its screen, for who can mend it. */
const SCREENS: Readonly<Record<StageReport["awake"], string>> = {
  "": "has not said yet whether its screen stays on.",
  kept: "keeps its screen on.",
  insecure:
    "may go to sleep: its address is not secure, so its browser keeps no screen on. Serve the show with --https, or switch off the sleep of that machine.",
  refused:
    "may go to sleep: its browser does not keep the screen on. Click the stage, or switch off the sleep of that machine.",
};
const CALM: readonly StageReport["awake"][] = ["", "kept"];

const style = css`
  ul {
    margin: 0;
    padding: 0;
    list-style: none;
    ${selectable}
  }
  li {
    padding: 3px 0;
    max-width: 70ch;
  }
`;

@customElement("omote-stages")
export class StageList extends DevicesElement {
  static override styles = [base, section, style];

  protected override readonly topics: readonly Topic[] = ["crew"];

  override render() {
    const stages = this.store.crew?.stages ?? [];
    return html`<h2>Stages</h2>
      ${stages.length === 0 ? html`<p class="none">No stage is open.</p>` : html`<ul>${stages.map(line)}</ul>`}`;
  }
}

function line(stage: StageReport | null, place: number) {
  if (stage === null) return html`<li><b>Stage ${place + 1}</b> is silent.</li>`;
  const { awake, name } = stage;
  return html`<li class=${CALM.includes(awake) ? "" : "attention"}><b>Stage ${name || place + 1}</b> ${SCREENS[awake]}</li>`;
}
