/** The character that an address names. */

/** Its name: what is typed is a name, or a label in any case; undefined where none is meant, or several are. */
export function findCharacter(
  typed: string,
  characters: Readonly<Record<string, { readonly label: string }>>,
): string | undefined {
  if (Object.hasOwn(characters, typed)) return typed;
  const wanted = plain(typed);
  const names = Object.keys(characters).filter((name) => name === wanted);
  const labelled = Object.keys(characters).filter((name) => plain(characters[name]?.label ?? "") === wanted);
  const matching = names.length > 0 ? names : labelled;
  return matching.length === 1 ? matching[0] : undefined;
}

const plain = (text: string): string => text.trim().toLowerCase();
