/** The bus that a page looks at and plays: what is on air, or the preview. */

import type { Hello } from "./messages";

export type Bus = NonNullable<Hello["bus"]>;

export const PREVIEW_WORDS = "PREVIEW – not on air";

/** The bus of a page by its address: `?bus=preview`; all else is air. */
export const readBus = (query: string): Bus =>
  new URLSearchParams(query).get("bus") === "preview" ? "preview" : "air";

/** The same address for another bus. */
export function addressOn(
  bus: Bus,
  { pathname, search, hash }: Pick<Location, "pathname" | "search" | "hash">,
): string {
  const parameters = new URLSearchParams(search);
  parameters.delete("bus");
  if (bus === "preview") parameters.set("bus", bus);
  const query = parameters.toString();
  return `${pathname}${query === "" ? "" : `?${query}`}${hash}`;
}
