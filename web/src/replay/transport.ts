/** How a recording is played: what the server says of it, and what a key or a press asks for. */

/**
 * How far it is, as `/replay/transport` says; times in seconds from the beginning, which is `first` of the clock of a
 * start of the show.
 */
export interface Transport {
  playing: boolean;
  position: number;
  seconds: number;
  rate: number;
  loop: number[];
  jumps: number;
  different: number | null;
  failure: string;
  start: number;
  first: number;
}

/** What is asked of it; what is left out stays. */
export type Asked = Partial<Pick<Transport, "playing" | "position" | "rate" | "loop">>;

/** A moment that people look for. */
export interface Moment {
  at: number;
  what: string;
  name: string;
  who: string;
}

export const RATES = [0.25, 0.5, 1, 2];
const STEP_SECONDS = 5;
const FRAME_SECONDS = 1 / 60;
/** A moment that has just been passed is not the one before. */
const JUST_PASSED = 1;
const SHORTEST_LOOP = 0.5;

const WORDS: Record<string, string> = {
  go: "GO",
  go_back: "BACK",
  go_to_cue: "GO TO",
  follow_cue: "followed:",
  panic: "PANIC",
  begin_show: "the show begins",
  mark_moment: "marked",
};

/** A moment in words. */
export const wordsOf = ({ what, name, who }: Moment): string =>
  [WORDS[what] ?? what, name, who && `(${who})`].filter((word) => word).join(" ");

/** A position that there is. */
export const within = (position: number, { seconds }: Transport): number => Math.min(Math.max(position, 0), seconds);

/** The moment before or behind a position; undefined where there is none. */
export function momentBeside(moments: readonly Moment[], position: number, ahead: boolean): Moment | undefined {
  const sorted = [...moments].sort((one, other) => one.at - other.at);
  return ahead
    ? sorted.find(({ at }) => at > position + FRAME_SECONDS)
    : sorted.reverse().find(({ at }) => at < position - JUST_PASSED);
}

/** The loop after its beginning or its end is put at the position; the other end stays where it can. */
export function loopFrom(now: Transport, end: "begin" | "end"): number[] {
  const [begin = 0, last = now.seconds] = now.loop;
  const here = now.position;
  if (end === "begin")
    return [Math.min(here, now.seconds - SHORTEST_LOOP), last > here + SHORTEST_LOOP ? last : now.seconds];
  return [begin < here - SHORTEST_LOOP ? begin : 0, Math.max(here, SHORTEST_LOOP)];
}

/** What a key asks for; undefined for one that asks for nothing. */
export function askedBy(
  key: { code: string; shiftKey: boolean },
  now: Transport,
  moments: readonly Moment[],
): Asked | undefined {
  const step = key.shiftKey ? FRAME_SECONDS : STEP_SECONDS;
  switch (key.code) {
    case "Space":
      return { playing: !now.playing };
    case "ArrowLeft":
      return { position: within(now.position - step, now) };
    case "ArrowRight":
      return { position: within(now.position + step, now) };
    case "Home":
      return { position: 0 };
    case "End":
      return { position: now.seconds };
    case "KeyI":
      return { loop: loopFrom(now, "begin") };
    case "KeyO":
      return { loop: loopFrom(now, "end") };
    case "KeyL":
      return { loop: [] };
    case "Comma":
    case "Period": {
      const moment = momentBeside(moments, now.position, key.code === "Period");
      return moment && { position: moment.at };
    }
    default:
      return undefined;
  }
}
