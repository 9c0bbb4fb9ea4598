/** What there is around the work: the cast, own things, faces that are shown, how hands work, what must be read. */

import type { Library } from "../../link/assets";
import type { Greeted, ItemDocument } from "../../link/editing_messages";
import type { Manifest } from "../../link/messages";
import { TopicStore } from "../../link/topics";
import { LongRequests } from "../../ui/long_requests";
import type { Request } from "../link/requests";
import { type Followers, type HeadControls, type Muscle, readHeadControls } from "./control_net";
import { type EditorNotice, EditorNotices } from "./notices";

/** What has changed. "live" is told at the rate of the pointer, all others rarely. */
export type EditorTopic =
  | "cast"
  | "items"
  | "draft"
  | "selection"
  | "options"
  | "live"
  | "link"
  | "notices"
  | "history";

/** drag: on the surface; pull: off it (R); add, remove, place: the net itself. */
export type Tool = "drag" | "pull" | "add" | "remove" | "place";

export interface Options {
  readonly tool: Tool;
  /** What a hand does on one side is done on the other. */
  readonly mirror: boolean;
  /** How far a drag takes points beside the dragged ones along, millimetres; 0: not at all. */
  readonly falloff: number;
  /** The only region that a drag moves, or null. */
  readonly region: string | null;
  readonly wireframe: boolean;
  readonly needles: boolean;
  readonly muscles: boolean;
}

/** What changes nothing. */
const LOOKS: ReadonlySet<Request["type"]> = new Set(["ask_history", "open_item", "close_item"]);

/** What is answered with the draft of another item than the open one. */
const OPENS: ReadonlySet<Request["type"]> = new Set([
  "open_item",
  "create_expression",
  "create_face",
  "create_pose",
  "duplicate",
]);

/** The most faces beside the work. */
export const MOST_NEIGHBOURS = 10;
/** The face under work before anybody has chosen. */
const FIRST = "kaori";
const NEIGHBOURS = ["dog", "child", "old"];

/** How an item is named, found and ordered. */
export type Description = Partial<Pick<ItemDocument, "label" | "tags" | "place">>;

/** A change of that: what it was before, and the change in words. */
export interface Described {
  readonly item: number;
  readonly before: Description;
  readonly what: string;
}

/** Everything that belongs to no item; whoever listens to a topic hears of its changes. */
export class EditorStore extends TopicStore<EditorTopic> {
  library: Library | null = null;
  headControls: HeadControls | null = null;
  items: readonly ItemDocument[] = [];
  /** The numbers of items of which this editor has a draft that is not saved. */
  unsaved: ReadonlySet<number> = new Set();
  /** Which show is served; null before the server has greeted. */
  show: string | null = null;
  /** The endings of downloads that the show's computer cannot make, and why. */
  unwritable: Readonly<Record<string, string>> = {};
  /** Of the cast that pages may load now; "" before the server has said. */
  digest = "";
  /** The name of the face shown large, and of those beside it. */
  work = FIRST;
  neighbours: readonly string[] = NEIGHBOURS;
  options: Options = {
    tool: "drag",
    mirror: false,
    falloff: 25,
    region: null,
    wireframe: false,
    needles: true,
    muscles: false,
  };
  /** The item that was deleted last, and whether it was open, while nothing was done since: Undo brings it back. */
  deleted: { readonly item: ItemDocument; readonly open: boolean } | null = null;
  /** Names, tags and places that were changed last, the newest last, while nothing else was done since: Undo takes them
   * back one by one. */
  described: readonly Described[] = [];
  online = false;
  /** What is being opened, as people call it; "": nothing. */
  opening = "";
  readonly longRequests = new LongRequests();
  readonly #notices = new EditorNotices();
  /** How often something was to be opened. */
  openings = 0;

  /** The cast as it is now. */
  get manifest(): Manifest | null {
    return this.library?.manifest ?? null;
  }

  get notices(): readonly EditorNotice[] {
    return this.#notices.all;
  }

  get muscles(): readonly Muscle[] {
    return this.headControls?.muscles ?? [];
  }

  get regions(): readonly string[] {
    return this.headControls?.regions ?? [];
  }

  /** For each region how much it owns of each vertex, 255 all. */
  get masks(): readonly Uint8Array[] {
    return this.headControls?.masks ?? [];
  }

  get followers(): Followers | null {
    return this.headControls?.followers ?? null;
  }

  /** The library has come, or has been renewed. */
  setCast(library: Library): void {
    this.library = library;
    const { manifest } = library;
    const isInCast = (name: string) => manifest.faces.some((face) => face.name === name);
    if (!isInCast(this.work)) this.work = isInCast(FIRST) ? FIRST : (manifest.faces[0]?.name ?? this.work);
    this.neighbours = this.neighbours.filter((name) => isInCast(name) && name !== this.work);
    this.tell("cast");
  }

  setHeadControls(greeted: Greeted): void {
    if (this.show !== null && this.show !== greeted.show) this.#leaveShow();
    this.headControls = readHeadControls(greeted);
    this.show = greeted.show;
    this.unsaved = new Set(greeted.unsaved);
    this.unwritable = greeted.unwritable;
    this.setItems(greeted.items, greeted.digest);
  }

  setItems(items: readonly ItemDocument[], digest = this.digest): void {
    [this.items, this.digest] = [items, digest];
    this.tell("items");
  }

  /** Nothing is open any more. */
  leave(): void {
    this.tell("draft");
  }

  /** Another show is served than before: what is open, and what was deleted last, belong to the former. */
  #leaveShow(): void {
    [this.deleted, this.described] = [null, []];
    this.leave();
    this.say("Another show is served here now: what you see are its faces and expressions.");
  }

  /** Something is asked of the server: what is more than a look is now the last thing that was done. Its turn among
   * those that open an item; NaN where it opens none. */
  protected noteAsked(type: Request["type"]): number {
    if (!LOOKS.has(type)) this.deleted = null;
    if (!LOOKS.has(type) && type !== "describe") this.described = [];
    if (!OPENS.has(type)) return Number.NaN;
    this.openings += 1;
    return this.openings;
  }

  /** Whether nothing else was to be opened since; a late answer takes the page from nobody. */
  protected isNewest(turn: number): boolean {
    return turn === this.openings;
  }

  protected setUnsaved(item: number, unsaved: boolean): void {
    if (this.unsaved.has(item) === unsaved) return;
    const others = [...this.unsaved].filter((other) => other !== item);
    this.unsaved = new Set(unsaved ? [...others, item] : others);
    this.tell("items");
  }

  setOnline(online: boolean): void {
    this.online = online;
    this.tell("link");
  }

  setOpening(label: string): void {
    this.opening = label;
    this.tell("draft");
  }

  /** The source of a face by its name. */
  sourceOf(face: string): string {
    return this.library?.sourceOf("faces", face) ?? face;
  }

  setOptions(change: Partial<Options>): void {
    this.options = { ...this.options, ...change };
    this.tell("options");
  }

  /** Shows a face large; the one that was takes its place beside it. */
  setWork(name: string): void {
    if (name === this.work) return;
    this.neighbours = this.neighbours.map((neighbour) => (neighbour === name ? this.work : neighbour));
    this.work = name;
    this.tell("cast");
  }

  setNeighbours(names: readonly string[]): void {
    this.neighbours = [...new Set(names)].filter((name) => name !== this.work).slice(0, MOST_NEIGHBOURS);
    this.tell("cast");
  }

  /** Tells the user something that stays until it is read. */
  say(text: string, kind: EditorNotice["kind"] = "refusal", actions: EditorNotice["actions"] = []): void {
    this.#notices.say(text, kind, actions);
    this.tell("notices");
  }

  /** What was said of this kind holds no more. */
  clear(kind: EditorNotice["kind"]): void {
    this.#notices.clear(kind);
    this.tell("notices");
  }

  dismiss(id: number): void {
    this.#notices.dismiss(id);
    this.tell("notices");
  }
}
