/** Whom or what characters look at, and the points of the house that have a name: what an operator does, with undo. */

import type { GazeTargetState } from "../../link/messages";
import type { ConsoleStore } from "../store/console_store";
import { AHEAD } from "../store/layer_state";
import type { Change } from "../store/undo_history";

type Point = readonly [x: number, y: number, z: number];

/** A target as it differs from nothing. */
export const targetOf = (fields: Partial<GazeTargetState>): GazeTargetState => ({ ...AHEAD, ...fields });

/** A target that can be chosen, and what it is called. */
export interface TargetChoice {
  readonly label: string;
  readonly title: string;
  readonly target: GazeTargetState;
}

/** Whether two targets are one: of what has a name the numbers mean nothing. */
export const isSame = (target: GazeTargetState, other: GazeTargetState): boolean =>
  target.kind === other.kind &&
  (target.kind === "point" || target.kind === "direction"
    ? target.x === other.x &&
      target.y === other.y &&
      target.z === other.z &&
      target.yaw === other.yaw &&
      target.pitch === other.pitch
    : target.name === other.name);

/** What can be chosen for the character `own`: nothing, cameras, others, and the points that have a name. */
export function choicesFor(
  own: string,
  characters: Readonly<Record<string, { label: string }>>,
  points: readonly string[],
  stages: readonly string[],
): TargetChoice[] {
  const named = [...new Set(stages)].filter((name) => name !== "");
  return [
    { label: "Ahead", title: "Its eyes look at nothing", target: AHEAD },
    { label: "Camera", title: "Its eyes look into the picture", target: targetOf({ kind: "stage" }) },
    ...named.map((name) => ({
      label: `Camera ${name}`,
      title: `Its eyes look into the picture of the stage ${name}`,
      target: targetOf({ kind: "stage", name }),
    })),
    ...Object.entries(characters)
      .filter(([name]) => name !== own)
      .map(([name, { label }]) => ({
        label,
        title: `Its eyes look at ${label}; where both do, they meet each other's eyes now and then`,
        target: targetOf({ kind: "character", name }),
      })),
    ...points.map((name) => ({
      label: name,
      title: `Its eyes look at ${name}`,
      target: targetOf({ kind: "gaze_point", name }),
    })),
  ];
}

export class GazeTargetCommands {
  constructor(private readonly store: ConsoleStore) {}

  /** The characters that are played look at something, each but itself. */
  choose({ label, target }: TargetChoice): void {
    const characters = this.store.state?.characters ?? {};
    const names = this.store.played.names.filter((name) => target.kind !== "character" || name !== target.name);
    const to = (wanted: (name: string) => GazeTargetState): Change[] =>
      names.map((character) => ({ type: "look_at", character, ...wanted(character) }));
    const sentence = target.kind === "ahead" ? "The eyes look ahead." : `The eyes look at: ${label}.`;
    this.store.act(sentence, {
      what: `look at ${label}`,
      undo: to((name) => characters[name]?.motion?.target ?? AHEAD),
      redo: to(() => target),
    });
  }

  /** Whether the characters that are played move by themselves while their tracker is lost. */
  idle(on: boolean): void {
    const to = (idle: boolean): Change[] =>
      this.store.played.names.map((character) => ({ type: "set_motion", character, idle }));
    const sentence = on ? "It moves by itself while its tracker is lost." : "It holds still while its tracker is lost.";
    this.store.act(sentence, { what: "idle motion", undo: to(!on), redo: to(on) });
  }

  /** Gives a point of the house a name; the characters that are played look at it. */
  keep(name: string, point: Point): void {
    const before = this.store.state?.gaze_points[name];
    const undo = before === undefined ? ({ type: "delete_gaze_point", name } as const) : naming(name, before);
    const step = { what: `point ${name}`, undo: [undo], redo: [naming(name, point)] };
    this.store.act(`${name} is a point to look at.`, step);
  }

  /** Forgets a point; whoever looked at it looks at it again where that is taken back. */
  delete(name: string): void {
    const { gaze_points = {}, characters = {} } = this.store.state ?? {};
    const point = gaze_points[name];
    if (point === undefined) return;
    const looked = Object.entries(characters).flatMap(([character, { motion }]): Change[] => {
      const target = motion?.target ?? AHEAD;
      return target.kind === "gaze_point" && target.name === name ? [{ type: "look_at", character, ...target }] : [];
    });
    this.store.act(`${name} is no point to look at any more.`, {
      what: `delete point ${name}`,
      undo: [naming(name, point), ...looked],
      redo: [{ type: "delete_gaze_point", name }],
    });
  }
}

const naming = (name: string, [x, y, z]: Point) => ({ type: "set_gaze_point", name, x, y, z }) as const;
