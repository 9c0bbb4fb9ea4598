/** What the console knows of the cast, and who listens to what has changed. */

import type { ExpressionDocument, FaceDocument, LightDocument, Manifest } from "../../link/messages";
import type { Axis } from "./axis";
import { mirrorOf, type Strip, stripsOf } from "./channels";

/** What has changed, for elements that render (rarely); what moves is read every frame instead. */
export type Topic = "cast" | "crew" | "link" | "timing" | "layout" | "layouts" | "call" | "notice" | "panic";

export class CastStore {
  manifest: Manifest | null = null;
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
}
