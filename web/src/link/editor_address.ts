/** The editor's address: of the page, and of one item in it, so that other pages lead to the very thing. */

import type { ItemDocument } from "./editing_messages";

type Kind = ItemDocument["kind"];

export const EDITOR = "/editor";

/** One tab for all that is edited from one browser. */
export const EDITOR_TAB = "omote-editor";

/** Where an own face or expression is edited. */
export const editorAddress = (kind: Kind, name: string): string =>
  `${EDITOR}?kind=${kind}&name=${encodeURIComponent(name)}`;

/** What an address asks for: the query's kind and name, or the name after "#" of either kind; null: nothing. */
export function askedItem({
  search,
  hash,
}: Pick<Location, "search" | "hash">): { kind: Kind | null; name: string } | null {
  const query = new URLSearchParams(search);
  const [kind, name] = [query.get("kind"), query.get("name")];
  if (name) return { kind: kind === "face" || kind === "expression" ? kind : null, name };
  return hash.length > 1 ? { kind: null, name: hash.slice(1) } : null;
}
