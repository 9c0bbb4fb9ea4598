/** Where an operator puts characters: by a hand that drags, by numbers as people write them, towards each other. */

import type { CharacterState, Place } from "../../link/messages";
import type { ConsoleStore } from "../store/console_store";
import type { Change } from "../store/undo_history";

/** Seconds in which a character follows a hand that drags its place. */
const FOLLOW = 0.1;
/** Who faces somebody turns no farther from the audience, radians. */
export const FARTHEST_TURN = Math.PI / 3;

export type PlaceField = keyof Place;

/** A part of a place as people read and write it: in metres, times and degrees. */
export interface PlacePart {
  readonly part: PlaceField;
  readonly label: string;
  readonly unit: string;
  /** What a slider reaches. */
  readonly low: number;
  readonly high: number;
  /** What the show takes. */
  readonly least: number;
  readonly most: number;
  readonly step: number;
  /** Of the unit that people read in one of the wire's. */
  readonly scale: number;
}

const metres = { unit: "m", step: 0.01, scale: 1 };
export const PLACE_PARTS: readonly PlacePart[] = [
  { part: "x", label: "Left, right", low: -2, high: 2, least: -10, most: 10, ...metres },
  { part: "depth", label: "Back", low: 0, high: 4, least: 0, most: 20, ...metres },
  { part: "size", label: "Size", unit: "×", low: 0.25, high: 4, least: 0.25, most: 4, step: 0.01, scale: 1 },
  { part: "turn", label: "Turn", unit: "°", low: -90, high: 90, least: -180, most: 180, step: 1, scale: 180 / Math.PI },
];

/** A number of a place as people read it. */
export const shown = ({ scale, step }: PlacePart, value: number): string => {
  const text = (value * scale).toFixed(step < 1 ? 2 : 0);
  return Number(text) === 0 ? text.replace("-", "") : text;
};

/** What somebody has written, as the wire has it; a sentence where it cannot be. */
export function written({ label, unit, least, most, scale }: PlacePart, text: string): number | string {
  const value = text.trim() === "" ? Number.NaN : Number(text);
  if (value >= least && value <= most) return value / scale;
  return `${label}: ${text.trim() === "" ? "nothing" : text} is no number from ${least} to ${most} ${unit}.`;
}

/** Metres that the map shows at least: beside the middle, and behind the front line. */
const LEAST = { beside: 1, behind: 1.2 };
/** Metres around whoever stands farthest, and before the front line. */
const AROUND = 0.35;
/** The part of the stage that a map shows: left, back, width, height, metres. */
export type Extent = readonly [number, number, number, number];

/** What a map must show of these places. */
export function extentOf(places: readonly Place[]): Extent {
  const beside = Math.max(LEAST.beside, ...places.map(({ x }) => Math.abs(x) + AROUND));
  const behind = Math.max(LEAST.behind, ...places.map(({ depth }) => depth + AROUND));
  return [-beside, -behind, 2 * beside, behind + AROUND];
}

/** The turns with which characters look at the middle of the others, by name; at most `FARTHEST_TURN` from the audience. */
export function facing(places: Readonly<Record<string, Place>>): Record<string, number> {
  const turns: Record<string, number> = {};
  for (const [name, { x, depth }] of Object.entries(places)) {
    const others = Object.entries(places).flatMap(([other, place]) => (other === name ? [] : [place]));
    const mean = (part: "x" | "depth"): number => others.reduce((sum, place) => sum + place[part], 0) / others.length;
    const [across, ahead] = [mean("x") - x, depth - mean("depth")];
    const turn = others.length === 0 || (across === 0 && ahead === 0) ? 0 : Math.atan2(across, ahead);
    turns[name] = Math.min(FARTHEST_TURN, Math.max(-FARTHEST_TURN, turn));
  }
  return turns;
}

/** Puts characters somewhere, so that each change can be taken back as one. */
export class Placing {
  #held: { readonly character: string; readonly before: Place; now: Place } | null = null;

  constructor(private readonly store: ConsoleStore) {}

  /** Whom a hand drags, and where to. */
  get held(): { readonly character: string; readonly now: Place } | null {
    return this.#held;
  }

  /** Follows a hand that drags a part of a character's place. */
  drag(character: string, change: Partial<Place>): void {
    const place = this.store.state?.characters[character]?.place;
    if (place === undefined) return;
    if (this.#held?.character !== character) this.release();
    this.#held ??= { character, before: place, now: place };
    this.#held.now = { ...this.#held.now, ...change };
    const message = { type: "place_character", character, ...this.#held.now, seconds: FOLLOW } as const;
    this.store.put(`${character}/place`, message);
  }

  /** The hand lets go. */
  release(): void {
    const held = this.#held;
    this.#held = null;
    if (held !== null) this.#offer({ [held.character]: held.before }, { [held.character]: held.now });
  }

  /** Sends characters to other places in `seconds`. */
  move(changes: Readonly<Record<string, Partial<Place>>>, seconds: number): void {
    const characters: Readonly<Record<string, CharacterState>> = this.store.state?.characters ?? {};
    const [before, after]: [Record<string, Place>, Record<string, Place>] = [{}, {}];
    for (const [name, change] of Object.entries(changes)) {
      const place = characters[name]?.place;
      if (place === undefined) continue;
      before[name] = place;
      after[name] = { ...place, ...change };
    }
    if (asked(after, seconds).every((change) => this.store.ask(change))) this.#offer(before, after);
  }

  #offer(before: Readonly<Record<string, Place>>, after: Readonly<Record<string, Place>>): void {
    if (!this.store.online || JSON.stringify(before) === JSON.stringify(after)) return;
    const labels = Object.keys(after).map((name) => this.store.state?.characters[name]?.label ?? name);
    const who = labels.join(" and ");
    this.store.offerUndo(`Placed ${who}.`, { what: `place ${who}`, undo: asked(before, 0.5), redo: asked(after, 0.5) });
  }
}

type Placed = Extract<Change, { type: "place_character" }>;

const asked = (places: Readonly<Record<string, Place>>, seconds: number): Placed[] =>
  Object.entries(places).map(([character, place]) => ({ type: "place_character", character, ...place, seconds }));
