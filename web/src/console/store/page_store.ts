/** What the console has whatever is on air: the cast, who listens to changes, the notice and what can be taken back. */

import type { ExpressionDocument, FaceDocument, LightDocument, Manifest } from "../../link/messages";
import type { Axis } from "./axis";
import { mirrorOf, type Strip, stripsOf } from "./channels";

/** What has changed, for elements that render (rarely); what moves is read every frame instead. */
export type Topic = "cast" | "crew" | "link" | "timing" | "layout" | "layouts" | "call" | "notice" | "panic";

/** Where to go on from a notice, or what to do about it. */
export type Offer =
  | { readonly label: string; readonly address: string }
  | { readonly label: string; readonly act: () => void };

export class PageStore {
  manifest: Manifest | null = null;
  /** The last thing the operator must read, how it is meant, and what can be done about it. */
  notice: string | null = null;
  tone: "attention" | "done" = "attention";
  offers: readonly Offer[] = [];
  #undo: (() => void) | null = null;
  #strips: Strip[] = [];
  #labels: Record<Axis, ReadonlyMap<string, string>> = { face: new Map(), expression: new Map() };
  readonly #listeners = new Map<Topic, Set<() => void>>();

  /** Calls `heard` with each change, until what it gives is called. */
  listen(topic: Topic, heard: () => void): () => void {
    const listeners = this.#listeners.get(topic) ?? new Set();
    this.#listeners.set(topic, listeners.add(heard));
    return () => listeners.delete(heard);
  }

  protected tell(topic: Topic): void {
    for (const heard of this.#listeners.get(topic) ?? []) heard();
  }

  /** What people read of a name; a name that the cast does not know stands for itself. */
  label(axis: Axis, name: string): string {
    return this.#labels[axis].get(name) ?? name;
  }

  get faces(): readonly FaceDocument[] {
    return this.manifest?.faces ?? [];
  }

  get expressions(): readonly ExpressionDocument[] {
    return this.manifest?.expressions ?? [];
  }

  get lights(): readonly LightDocument[] {
    return this.manifest?.lights ?? [];
  }

  setManifest(manifest: Manifest): void {
    this.manifest = manifest;
    this.#strips = stripsOf(manifest.expressions);
    const labels = (documents: readonly { name: string; label: string }[]) =>
      new Map(documents.map(({ name, label }) => [name, label]));
    this.#labels = { face: labels(manifest.faces), expression: labels(manifest.expressions) };
    this.tell("cast");
  }

  /** The channel that moves the same on the other side of the face; null where there is none. */
  protected mirrorOf(name: string): string | null {
    return mirrorOf(name, this.#strips);
  }

  say(notice: string | null, tone: PageStore["tone"] = "attention", offers: readonly Offer[] = []): void {
    [this.notice, this.tone, this.offers] = [notice, tone, offers];
    this.tell("notice");
  }

  /** Says what was done, and takes it back on request, until something else can be taken back. */
  offerUndo(done: string, undo: () => void, others: readonly Offer[] = []): void {
    this.#undo = undo;
    this.say(done, "done", [{ label: "Undo", act: () => this.undo() }, ...others]);
  }

  /** Takes the last Keep, Clear or change of the layouts back. */
  undo(): void {
    const undo = this.#undo;
    this.#undo = null;
    if (undo === null) this.say("Nothing to undo: Keep, Clear and changes of layouts can be taken back.");
    else {
      this.say(null);
      undo();
    }
  }
}
