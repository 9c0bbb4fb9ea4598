/** Sources at this console: what they send now, their measures as steps, and those that play nobody. */

import { aligned } from "../../link/arrays";
import type { CalibrateSource, SourceState, WatchSource } from "../../link/messages";
import type { ConsoleStore } from "../store/console_store";
import type { Question } from "../store/page_store";
import { sourceLabel } from "../store/source_label";
import { LostSources, sendingOf } from "./lost_sources";
import { MeasureSteps } from "./measure_step";
import { UnroutedSources } from "./unrouted_sources";

/** What a source sends now, and what its measure makes of it, by channel. */
export interface WatchedValues {
  readonly names: readonly string[];
  readonly sent: Float32Array;
  readonly weights: Float32Array;
}

declare module "../controls/console_element" {
  interface ConsoleContext {
    readonly sources: ConsoleSources;
  }
}

export class ConsoleSources {
  /** What the source that is watched sends now; null before it has. */
  watched: WatchedValues | null = null;
  readonly #measures = new MeasureSteps();
  readonly #unrouted = new UnroutedSources(
    (source, character) => this.#route(source, character),
    () => this.store.tell("notice"),
  );
  readonly #lost = new LostSources();
  #asked = "";
  /** What was asked last about a source that plays nobody. */
  #text: string | undefined;

  constructor(
    private readonly store: ConsoleStore,
    private readonly send: (message: WatchSource) => void,
  ) {
    store.hear("sources", ({ sources }) => this.#receive(sources));
    store.hear("source_values", ({ source, names, sent, weights }) => {
      if (source === this.#asked) this.watched = { names, sent: floatsOf(sent), weights: floatsOf(weights) };
    });
    store.hear("state", ({ characters }) => {
      const turned = this.#lost.receive(characters, sendingOf(store.sources));
      if (turned !== "") store.say(turned, turned.includes("lost") ? "attention" : "done");
    });
  }

  /** What is asked about a source that plays nobody; null for nothing. */
  get question(): Question | null {
    return this.#unrouted.question(this.store.sources, this.store.state?.characters ?? {});
  }

  /** All sources, as the show tells them. */
  #receive(sources: readonly SourceState[]): void {
    for (const step of this.#measures.receive(sources)) this.store.offerUndo(`Done: ${step.what}.`, step);
    const text = this.question?.text;
    if (text !== this.#text) this.store.tell("notice");
    this.#text = text;
  }

  /** Watches a source from now on, "" for none; again after the link was lost. */
  watch(source: string): void {
    if (source !== this.#asked) this.watched = null;
    this.#asked = source;
    this.send({ type: "watch_source", source });
  }

  /** A step of a calibration, for all channels or for some; the measure that comes of it can be taken back. */
  calibrate(source: SourceState, step: CalibrateSource["step"], channels: readonly string[] = []): boolean {
    if (step !== "range") this.#measures.ask(source);
    return this.store.ask({ type: "calibrate_source", source: source.name, step, channels: [...channels] });
  }

  #route(source: SourceState, character: string): void {
    const { name, layer, regions } = source;
    const to = (characters: string[]) => ({ type: "route_source", source: name, characters, layer, regions }) as const;
    const step = { what: `route ${sourceLabel(name)}`, undo: [to([])], redo: [to([character])] };
    const label = this.store.state?.characters[character]?.label ?? character;
    this.store.act(`${sourceLabel(name)} plays ${label}.`, step);
  }
}

const floatsOf = (bytes: Uint8Array): Float32Array => new Float32Array(aligned(bytes));
