/** As what a face is taken: in whose place, with which name and hair. */

import { html, nothing, type TemplateResult } from "lit";
import type { ItemDocument } from "../../link/editing_messages";
import { textOf } from "../../ui/topic_element";
import type { HairChoice } from "./data/scan_document";

/** A new face, or instead of which; nothing where there are none to replace. */
export function placeChoice(
  items: readonly ItemDocument[],
  replaced: number | null,
  choose: (id: number | null) => void,
): TemplateResult | typeof nothing {
  const faces = items.filter(({ kind, deleted, head }) => kind === "face" && !deleted && head > 0);
  if (faces.length === 0) return nothing;
  return html`<label for="replaced">Place</label><select id="replaced"
      @change=${(event: Event) => choose(textOf(event) === "" ? null : Number(textOf(event)))}>
    <option value="">A new face</option>
    ${faces.map(({ id, label }) => html`<option value=${id} ?selected=${id === replaced}>Instead of ${label}</option>`)}
  </select>`;
}

/** That a name is given already. */
export const nameNote = (typed: string, called: string): TemplateResult =>
  html`<p class="note called" role="status">There is a face "${typed}" already: this one will be "${called}".</p>`;

/** The style and the colour of the hair. */
export function hairChoice(
  styles: readonly string[],
  hair: HairChoice,
  choose: (hair: HairChoice) => void,
): TemplateResult {
  return html`<label for="hair">Hair</label><div class="row"><select id="hair" class="grow"
      @change=${(event: Event) => choose({ ...hair, style: textOf(event) })}>
    ${["", ...styles].map((name) => html`<option value=${name} ?selected=${name === hair.style}>${name === "" ? "none" : name}</option>`)}
  </select><input type="color" aria-label="Colour of the hair" .value=${hair.colour}
    @input=${(event: Event) => choose({ ...hair, colour: textOf(event) })} /></div>`;
}
