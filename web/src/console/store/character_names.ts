/** Names of characters, which addresses can hold, and labels for those that nobody has named. */

import type { CharacterState } from "../../link/messages";

/** Letters that a name has at most. */
const LONGEST = 24;

/** The name of a character that is called `label`: what addresses can hold, and nobody has yet. */
export function nameOf(label: string, taken: readonly string[]): string {
  const plain = label
    .normalize("NFD")
    .replace(/[\u0300-\u036f]/g, "")
    .toLowerCase()
    .replace(/[^a-z0-9_-]+/g, "-")
    .replace(/^-+|-+$/g, "")
    .slice(0, LONGEST - 3);
  const [stem, names] = [plain || "character", new Set(taken)];
  for (let number = 1; ; number++) {
    const name = number === 1 ? stem : `${stem}-${number}`;
    if (!names.has(name)) return name;
  }
}

const NUMBERS = ["One", "Two", "Three", "Four", "Five", "Six", "Seven", "Eight"] as const;

/** What a new character is called that nobody has named: the first number that is free, a label that no other has in any
 * case; `taken`: names that are not free. */
export function freeLabel(
  characters: Readonly<Record<string, CharacterState>>,
  taken: readonly string[] = Object.keys(characters),
): string {
  const labels = new Set(Object.values(characters).map(({ label }) => label.toLowerCase()));
  const free = (label: string): boolean => !labels.has(label.toLowerCase());
  const numberWord = NUMBERS.find((label) => free(label) && !taken.includes(nameOf(label, [])));
  for (let number = 1; ; number++) {
    const label = numberWord ?? (number === 1 ? "Character" : `Character ${number}`);
    if (free(label)) return label;
  }
}
