import { describe, expect, it } from "vitest";
import { PlayoutClock } from "./playout_clock";

const TICK = 1 / 60;
const LONGEST = 0.06;

/** A link and a display: how late state `n` is, whether it shows something new, and seconds between two frames. */
interface Trial {
  late: (n: number) => number;
  moves?: (n: number) => boolean;
  interval?: (n: number) => number;
  states?: number;
}

/** A frame: when, what was due, the newest state, and how much of the time between the frames passed since the last. */
interface Shown {
  time: number;
  due: number;
  newest: number;
  speed: number;
}

/** Numbers from 0 to 1, the same for the same seed. */
function dice(seed: number): () => number {
  let state = seed;
  return () => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return state / 2 ** 32;
  };
}

function play({ late, moves = () => true, interval = () => 1 / 59.94, states = 1200 }: Trial): Shown[] {
  const clock = new PlayoutClock(LONGEST);
  const shown: Shown[] = [];
  let [time, next, comes, before] = [0, 0, late(0), 0];
  for (let frame = 0; next < states; frame++) {
    const seconds = interval(frame);
    time += seconds;
    for (; next < states && comes <= time; comes = Math.max(comes, next * TICK + late(next))) {
      clock.arrived(next * TICK, !moves(next));
      next += 1;
    }
    if (next === 0) continue;
    const due = clock.at(time, seconds);
    shown.push({ time, due, newest: (next - 1) * TICK, speed: (due - before) / seconds });
    before = due;
  }
  return shown;
}

const jitters: [string, (seed: number) => Trial][] = [
  ["a quiet link", (seed) => spread(seed, 0.001)],
  ["a wireless link", (seed) => spread(seed, 0.012)],
  ["a bad link", (seed) => spread(seed, 0.08)],
  ["a slow machine", (seed) => ({ ...spread(seed, 0.008), interval: frames(seed) })],
];

function spread(seed: number, most: number): Trial {
  const random = dice(seed);
  return { late: () => 0.001 + most * random() ** 3 };
}

function frames(seed: number): () => number {
  const random = dice(seed + 99);
  return () => (random() < 0.2 ? 2 * TICK : TICK) + 0.01 * random();
}

describe.each(jitters)("on %s", (_, jitter) => {
  const seeds = [1, 2, 3, 4, 5];
  const settled = (shown: Shown[]): Shown[] => shown.filter(({ time }) => time > 1);

  it("time never goes back, nor past the newest state", () => {
    for (const seed of seeds)
      for (const { due, newest, speed } of play(jitter(seed)).slice(1)) {
        expect(speed).toBeGreaterThanOrEqual(-1e-9);
        expect(due).toBeLessThanOrEqual(newest);
      }
  });

  it("what moves plays evenly: it stands where a state is missing, and never jumps after it", () => {
    for (const seed of seeds)
      for (const { due, newest, speed } of settled(play(jitter(seed)))) {
        expect(speed).toBeLessThan(1.5);
        if (due < newest) expect(speed).toBeGreaterThanOrEqual(0.5 - 1e-9);
      }
  });

  it("is no later than the limit, or than it has waited for a state in the last second", () => {
    for (const seed of seeds) {
      const shown = play(jitter(seed));
      shown.forEach(({ time, due }, frame) => {
        const waits = shown
          .slice(Math.max(0, frame - 60), frame + 1)
          .map((frameShown) => frameShown.time - frameShown.newest);
        if (frame > 60) expect(time - due).toBeLessThan(Math.max(LONGEST, ...waits) + 0.002);
      });
    }
  });

  it("shows the first change after a rest in the first frame that knows of it", () => {
    for (const seed of seeds) {
      const changes = [90, 300, 571, 888];
      const moves = (n: number): boolean => changes.some((from) => n >= from && n < from + 40);
      const shown = play({ ...jitter(seed), moves });
      for (const change of changes) {
        const newestShown = shown.find(({ newest }) => newest >= change * TICK - 1e-9) as Shown;
        expect(newestShown.due).toBeGreaterThan((change - 1) * TICK);
      }
    }
  });
});

describe("the delay while something moves", () => {
  const delay = (trial: Trial): number => {
    const late = play(trial).slice(-300);
    return late.reduce((sum, { time, due }) => sum + time - due, 0) / late.length;
  };

  it("is no longer than a state's interval where states are punctual", () => {
    for (const interval of [TICK / 2.4, TICK, 1 / 59.94, 2 * TICK])
      expect(delay({ late: () => 0, interval: () => interval })).toBeLessThan(TICK + 0.0015);
  });

  it("covers late states, where there are many", () => {
    const often = delay({ late: (n) => (n % 5 === 0 ? 0.014 : 0.001) });
    expect(often).toBeGreaterThan(0.014);
    expect(often).toBeLessThan(TICK + 0.017);
  });

  it("is for the odd late state only what that needs, and soon what it was", () => {
    const shown = play({ late: (n) => (n % 150 === 0 ? 0.05 : 0.001) }).filter(({ time }) => time > 5);
    const least = shown.map(({ time, due }) => time - due).sort((a, b) => a - b);
    expect(least[least.length >> 1]).toBeLessThan(TICK + 0.004);
  });

  it("is the same for a source of 30 Hz, of which every other state is new: its rests are not skipped", () => {
    const shown = play({ late: () => 0.001, moves: (n) => n % 2 === 0 }).filter(({ time }) => time > 1);
    for (const { speed } of shown) expect(Math.abs(speed - 1)).toBeLessThan(0.11);
  });
});

describe("after a pause of the link", () => {
  const pause = (seconds: number) => (n: number) =>
    n >= 300 && n < 300 + 60 * seconds ? (300 - n) * TICK + seconds : 0;

  it("plays on from where it stood, at no more than twice the speed, until it is no later than allowed", () => {
    const shown = play({ late: pause(0.2) });
    const after = shown.filter(({ time }) => time > 5);
    for (const { speed } of after) expect(speed).toBeLessThanOrEqual(2 + 1e-9);
    for (const { time, due } of after.filter((frameShown) => frameShown.time > 6))
      expect(time - due).toBeLessThan(LONGEST + 0.001);
  });

  it("begins anew after a long one", () => {
    const shown = play({ late: pause(0.9) }).filter(({ time }) => time > 6);
    for (const { time, due } of shown) expect(time - due).toBeLessThan(LONGEST + 0.001);
  });

  it("follows a server that started anew with another clock", () => {
    const clock = new PlayoutClock(LONGEST);
    for (let n = 0; n < 60; n++) {
      clock.arrived(100 + n * TICK, false);
      clock.at(100 + n * TICK, TICK);
    }
    clock.arrived(3, false);
    expect(clock.at(3, TICK)).toBeLessThanOrEqual(3);
    clock.arrived(3 + TICK, false);
    expect(clock.at(3 + TICK, TICK)).toBeGreaterThan(2.9);
  });
});
