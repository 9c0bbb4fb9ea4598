/** A choice among sources, in their groups. */

import { html } from "lit";
import { live } from "lit/directives/live.js";
import { textOf } from "../../ui/topic_element";
import { grouped, type ListedSource } from "../session/sources";

/** A choice among sources under their groups; `chosen` hears each choice. */
export const sourceChoice = (
  sources: readonly ListedSource[],
  {
    label,
    first,
    value = "",
    chosen,
  }: { label: string; first: string; value?: string; chosen: (source: string) => void },
) => html`<select class="grow" aria-label=${label} title=${label}
  @change=${(event: Event) => {
    const source = textOf(event);
    (event.target as HTMLSelectElement).value = value; // until it is so
    chosen(source);
  }}>
  <option value="" .selected=${live(value === "")}>${first}</option>
  ${grouped(sources).map(
    ([group, inside]) => html`<optgroup label=${group}>
      ${inside.map(({ source, label: name }) => html`<option value=${source} .selected=${live(source === value)}>${name}</option>`)}
    </optgroup>`,
  )}
</select>`;
