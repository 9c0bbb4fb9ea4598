/** What hands hold of a character, by part: it stays above what a clip plays there. */

import { CLIP_PARTS } from "../../link/constants";
import type { CharacterState, ClipPass, ExpressionDocument, LaneOutline } from "../../link/messages";
import { type Region, regionOf } from "../store/channels";
import type { ConsoleStore } from "../store/console_store";
import { handsOf } from "../store/held_state";
import { clearStep } from "../store/undo_history";

type Part = (typeof CLIP_PARTS)[number];

/** What this asks of the page of clips. */
interface Page {
  readonly show: ConsoleStore;
  /** Who plays the clip that is shown. */
  readonly character: string;
  readonly lanes: readonly LaneOutline[];
  readonly playing: object | null;
  readonly pass: Pick<ClipPass, "parts"> | null;
  readonly unheard: string;
  labelOf(character: string): string;
}

/** What a hand holds: a channel, or how head or eyes turn. */
interface Held {
  readonly name: string;
  readonly parts: readonly Part[];
  /** The weight of a channel; 0 for `head` and `gaze`. */
  readonly weight: number;
}

const LEAST = 0.001;
const PARTS: Readonly<Partial<Record<Region, Part>>> = {
  brows: "brows",
  eyes: "eyes",
  mouth: "mouth",
  jaw: "mouth",
  cheeks: "mouth",
  tongue: "mouth",
  nose: "rest",
  ears: "rest",
};

/** The parts of the face that a channel moves: one, or all of it. */
function partsOf(name: string, expressions: readonly ExpressionDocument[]): readonly Part[] {
  const known = expressions.find((expression) => expression.name === name);
  const part = PARTS[regionOf(known ?? { name, kind: "arkit", region: "" })];
  return part === undefined ? CLIP_PARTS.filter((each) => each !== "head" && each !== "gaze") : [part];
}

/** What hands hold of these parts; `expressions`: of the cast, which say where a channel belongs. */
function heldOf(
  character: CharacterState,
  parts: readonly Part[],
  expressions: readonly ExpressionDocument[],
): readonly Held[] {
  const { channels, head, gaze } = handsOf(character);
  const turned = (values: readonly number[]): boolean => values.some((value) => Math.abs(value) > LEAST);
  const held: Held[] = Object.entries(channels)
    .filter(([, weight]) => Math.abs(weight) > LEAST)
    .map(([name, weight]) => ({ name, weight, parts: partsOf(name, expressions) }));
  if (turned(head)) held.push({ name: "head", weight: 0, parts: ["head"] });
  if (turned(gaze)) held.push({ name: "gaze", weight: 0, parts: ["gaze"] });
  return held.filter((each) => each.parts.some((part) => parts.includes(part)));
}

/** Says what hands hold above a clip that plays, once of the same, and lets go of it. */
export class HandsAbove {
  #said = "";

  constructor(private readonly page: Page) {}

  /** What hands hold of the parts that the clip plays, and so hide of it; `but`: parts that are recorded. */
  above(but: Iterable<Part> = []): readonly Held[] {
    const { show, character, lanes } = this.page;
    const state = show.state?.characters[character];
    const recorded = new Set(but);
    const heard = lanes.filter(({ muted }) => !muted).flatMap(({ parts }) => parts);
    const parts = heard.filter((part) => !recorded.has(part));
    return state === undefined ? [] : heldOf(state, parts, show.expressions);
  }

  /** A state has come. */
  hear(): void {
    const held = this.page.playing === null ? [] : this.above(this.page.pass?.parts);
    const names = held.map(({ name }) => name).join();
    if (names !== this.#said) this.say(held);
    this.#said = names;
  }

  /** What was said is said again. */
  forget(): void {
    this.#said = "";
  }

  say(held: readonly Held[]): void {
    if (held.length === 0) return;
    const names = held.map(({ name }) => name);
    const what = names.length > 3 ? `${names.slice(0, 3).join(", ")} and ${names.length - 3} more` : names.join(", ");
    const says = `Hands hold ${what} of ${this.page.labelOf(this.page.character)}, above what the clip plays there.`;
    const { character } = this.page;
    this.page.show.say(says, "attention", [{ label: "Release", act: () => this.#release(character, held) }]);
  }

  #release(character: string, held: readonly Held[]): void {
    const { show, unheard } = this.page;
    if (unheard !== "") {
      show.say(unheard);
      return;
    }
    const names = held.map(({ name }) => name);
    const done = `Released: ${names.join(", ")}.`;
    if (names.includes("head"))
      show.put(`${character}/head`, { type: "set_head", character, yaw: 0, pitch: 0, roll: 0 });
    if (names.includes("gaze")) show.put(`${character}/gaze`, { type: "set_gaze", character, yaw: 0, pitch: 0 });
    const channels = held.filter(({ name }) => name !== "head" && name !== "gaze");
    const step = clearStep(channels.map(({ name, weight }) => [character, name, weight]));
    if (channels.length > 0) show.act(done, step);
    else show.say(done, "done");
  }
}
