/** Sources that a performer feeds, trackers and lips: which were lost and which came back from one state to the next. */

import { SPEECH } from "../../link/constants";
import type { CharacterState, SourceState, State } from "../../link/messages";
import { isLost, isTrusted } from "../store/layer_state";
import { sourceLabel } from "../store/source_label";

/** Layers whose sources go on until somebody ends them, but for a speech; a recording ends by itself too. */
const WATCHED = ["tracker", "lips"] as const;

type Characters = State["characters"];

export class LostSources {
  /** Sources that were there, and whether they are lost now, by character, layer and source. */
  readonly #lost = new Map<string, boolean>();

  /** What changed with a newer state, in words; "" for nothing. One that was never trusted is not told, nor one that is
   * `sending`: its layer lets go for another reason, such as another measure. Nor one whose layer is off, as after a
   * panic: it shows nothing on air. */
  receive(characters: Characters, sending: ReadonlySet<string> = new Set()): string {
    const sentences: string[] = [];
    const there = new Set<string>();
    for (const [name, character] of Object.entries(characters))
      for (const layer of WATCHED) {
        const { source: only = "", trust: its = 0, sources = [], on = true } = character.layers[layer] ?? {};
        if (!on) continue;
        for (const { source, trust } of sources.length > 0 ? sources : [{ source: only, trust: its }]) {
          const key = `${name}/${layer}/${source}`;
          if (source === "" || source === SPEECH) continue;
          there.add(key);
          const turned = this.#turn(key, trust, sending.has(source));
          if (turned !== null)
            sentences.push(`${sourceLabel(source)} (${layer} of ${labelOf(name, character)}) is ${turned}.`);
        }
      }
    for (const key of this.#lost.keys()) if (!there.has(key)) this.#lost.delete(key);
    return sentences.join(" ");
  }

  /** How a source changed that is trusted this far now; null where it did not. */
  #turn(key: string, trust: number, sends: boolean): "lost" | "back" | null {
    const lost = this.#lost.get(key);
    if (isTrusted(trust)) this.#lost.set(key, false);
    else if (isLost(trust) && lost === false && !sends) this.#lost.set(key, true);
    if (lost === undefined || lost === this.#lost.get(key)) return null;
    return lost ? "back" : "lost";
  }
}

const labelOf = (name: string, { label }: CharacterState): string => label || name;

/** The sources that send what they see. */
export const sendingOf = (sources: readonly SourceState[]): ReadonlySet<string> =>
  new Set(sources.filter(({ found, rate }) => found && rate > 0).map(({ name }) => name));
