/** Sources that send and play nobody: each is said once, with a button for whom it may play. */

import type { SourceState, State } from "../../link/messages";
import type { Question } from "../store/page_store";
import { sourceLabel } from "../store/source_label";

/** Characters that a question offers; the mixer has all. */
const MOST_OFFERED = 4;

/** What an operator may do about a source: let it play a character. */
export type RouteTo = (source: SourceState, character: string) => void;

/** Those that play nobody, though somebody is to say whom; a program says it itself. */
export const unrouted = (sources: readonly SourceState[]): readonly SourceState[] =>
  sources.filter(({ characters, kind }) => kind !== "program" && characters.length === 0);

/** How many play nobody, in words. */
export const countUnrouted = (count: number): string =>
  count === 1 ? "1 source plays nobody" : `${count} sources play nobody`;

export class UnroutedSources {
  /** Those whose question was put away, until they play somebody or have gone. */
  readonly #answered = new Set<string>();

  constructor(
    private readonly route: RouteTo,
    private readonly dismissed: () => void,
  ) {}

  /** What to ask about the first source that plays nobody; null where each plays somebody. */
  question(sources: readonly SourceState[], characters: State["characters"]): Question | null {
    const idle = unrouted(sources);
    for (const name of this.#answered) if (idle.every((source) => source.name !== name)) this.#answered.delete(name);
    const source = idle.find(({ name }) => !this.#answered.has(name));
    if (source === undefined) return null;
    const offers = Object.entries(characters)
      .slice(0, MOST_OFFERED)
      .map(([name, { label }]) => ({ label: `Play ${label}`, act: () => this.route(source, name) }));
    const dismiss = (): void => {
      this.#answered.add(source.name);
      this.dismissed();
    };
    const label = sourceLabel(
      source.name,
      sources.map(({ name }) => name),
    );
    return { text: `${label} sends and plays nobody.`, offers, dismiss };
  }
}
