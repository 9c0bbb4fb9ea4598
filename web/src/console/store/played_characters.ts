/** Which characters this console plays, and what they have on air. */

import { ALL, FIRST_CHARACTER } from "../../link/constants";
import type { CharacterState, State } from "../../link/messages";
import { handsOf } from "./held_state";

export class PlayedCharacters {
  #chosen: readonly string[] = [FIRST_CHARACTER];
  /** Names that this console has asked for and not seen yet. */
  readonly #expected = new Set<string>();

  constructor(private readonly state: () => State | null) {}

  /** Plays these from now on; those that are not there yet once they are. */
  choose(names: readonly string[]): void {
    this.#chosen = [...new Set(names)];
  }

  /** A name has been asked for that will be there soon, or has been rejected. */
  expect(name: string, comes = true): void {
    if (comes) this.#expected.add(name);
    else this.#expected.delete(name);
  }

  /** The names of characters that there are, or will be soon. */
  get taken(): readonly string[] {
    return [...new Set([...Object.keys(this.state()?.characters ?? {}), ...this.#expected])];
  }

  get chosen(): readonly string[] {
    return this.#chosen;
  }

  /** Those that are played: the chosen ones that there are, else the first on the stage. */
  get names(): readonly string[] {
    const characters = this.state()?.characters;
    if (characters === undefined) return this.#chosen.slice(0, 1);
    for (const name of this.#expected) if (name in characters) this.#expected.delete(name);
    const there = this.#chosen.filter((name) => name in characters);
    return there.length > 0 ? there : firstOn(characters);
  }

  /** Whom a press on a name means: that one alone, or `beside` those played one more, or one less; never none. */
  pressed(name: string, beside: boolean): readonly string[] {
    if (!beside) return [name];
    const others = this.names.filter((other) => other !== name);
    if (others.length === this.names.length) return [...others, name];
    return others.length > 0 ? others : this.names;
  }

  /** The one whose values the controls show. */
  get lead(): string {
    return this.names[0] ?? FIRST_CHARACTER;
  }

  /** What the lead has on air. */
  get air(): CharacterState | null {
    return this.state()?.characters[this.lead] ?? null;
  }

  /** What stands on the picture: whose it is where it shows one of several, for that is not what the audience sees. */
  tally(alone: boolean): string {
    const [air, several] = [this.air, Object.keys(this.state()?.characters ?? {}).length > 1];
    if (air === null || (several && !alone)) return "ON AIR";
    return `${several ? `${air.label} ` : ""}${air.presence > 0 ? "ON AIR" : "OFF STAGE"}`;
  }

  /** Whom messages are for: one name for all of them, where all are played. */
  get targets(): readonly string[] {
    const [names, state] = [this.names, this.state()];
    const all = state !== null && names.length > 1 && names.length === Object.keys(state.characters).length;
    return all ? [ALL] : names;
  }

  /** Those that are played and have a macro of a name. */
  withMacro(name: string): readonly string[] {
    const characters = this.state()?.characters ?? {};
    return this.names.filter((played) => name in (characters[played]?.macros ?? {}));
  }

  /** The weights of a channel of each that is played; `lead`: what it shows of the lead. */
  weights(name: string, lead: number): (readonly [string, string, number])[] {
    const characters = this.state()?.characters ?? {};
    const read = (played: string): number => {
      const character = characters[played];
      return character === undefined ? 0 : (handsOf(character).channels[name] ?? 0);
    };
    return this.names.map((played) => [played, name, played === this.lead ? lead : read(played)] as const);
  }

  /** How many panics those have had that are played, or these. */
  panics(names: readonly string[] = this.names): number {
    const characters = this.state()?.characters ?? {};
    return names.reduce((sum, name) => sum + (characters[name]?.panics ?? 0), 0);
  }
}

function firstOn(characters: Readonly<Record<string, CharacterState>>): readonly string[] {
  const names = Object.keys(characters);
  const present = names.find((name) => (characters[name] as CharacterState).presence > 0);
  return present === undefined ? names.slice(0, 1) : [present];
}

/** What of a state's characters lists of them show: the same text while that is the same. */
export const charactersKey = (state: State | null): string =>
  JSON.stringify(
    Object.entries(state?.characters ?? {}).map(([name, character]) => [name, character.label, standing(character)]),
  );

/** Whether a character is on the stage, comes, or goes; in words, none where it is there. */
export const standing = ({ presence, leaves }: CharacterState): string =>
  leaves ? "going" : presence > 0 ? "" : "off stage";

/** Who else moves something of a character; nothing where nobody does. */
export function handOn(hands: Readonly<Record<string, string>>, character: string): string {
  const names = Object.entries(hands).flatMap(([control, who]) => (control.startsWith(`${character}/`) ? [who] : []));
  return [...new Set(names)].join(", ");
}
