import { describe, expect, it } from "vitest";
import { type Change, MOST_STEPS, type Step, UndoHistory, type Way } from "./undo_history";

/** A value that steps set, as a show that may be away or refuse. */
class Show {
  value = 0;
  away = false;
  readonly asked: ((reason: string) => void)[] = [];
  readonly told: string[] = [];
  readonly history = new UndoHistory(
    (step, way, refused) => this.#put(step[way], refused),
    (step, way, why) => this.told.push(`${way} ${step.what}: ${why}`),
  );

  take(way: Way): number {
    this.history.take(way);
    return this.value;
  }

  set(value: number): void {
    const to = (seconds: number): Change[] => [{ type: "set_home", character: "one", face: "generic", seconds }];
    const [undo, redo] = [to(this.value), to(value)];
    this.value = value;
    this.history.add({ what: String(value), undo, redo });
  }

  #put(changes: readonly Change[], refused: (reason: string) => void): boolean {
    if (this.away) return false;
    for (const change of changes) if (change.type === "set_home") this.value = change.seconds ?? 0;
    this.asked.push(refused);
    return true;
  }
}

describe("the history of what was done", () => {
  it("leads back to the beginning and forth to the end, as often as one likes", () => {
    const show = new Show();
    const values = [3, 1, 4, 1, 5];
    for (const value of values) show.set(value);
    for (let turn = 0; turn < 3; turn++) {
      const back = values.map(() => show.take("undo"));
      expect(back).toEqual([1, 4, 1, 3, 0]);
      expect(show.history.take("undo")).toBeNull();
      const forth = values.map(() => show.take("redo"));
      expect(forth).toEqual(values);
      expect(show.history.take("redo")).toBeNull();
    }
  });

  it("forgets what was taken back once something else is done", () => {
    const show = new Show();
    show.set(1);
    show.set(2);
    show.history.take("undo");
    show.set(7);
    expect(show.history.next("redo")).toBeNull();
    show.history.take("undo");
    expect(show.value).toBe(1);
  });

  it("keeps a step that could not be sent", () => {
    const show = new Show();
    show.set(1);
    show.away = true;
    expect(show.history.take("undo")).toBeNull();
    expect(show.history.next("undo")?.what).toBe("1");
    show.away = false;
    expect(show.history.take("undo")?.what).toBe("1");
  });

  it("puts a step that is refused back where it was, tells of it, and can leave it out", () => {
    const show = new Show();
    show.set(1);
    show.set(2);
    const step = show.history.take("undo") as Step;
    show.asked[0]?.("on air");
    show.asked[0]?.("on air");
    expect(show.told).toEqual(["undo 2: on air"]);
    expect([show.history.next("undo"), show.history.next("redo")]).toEqual([step, null]);
    show.history.skip(step);
    expect(show.history.take("undo")?.what).toBe("1");
  });

  it("remembers so many steps and no more", () => {
    const show = new Show();
    for (let value = 1; value <= MOST_STEPS + 5; value++) show.set(value);
    while (show.history.take("undo") !== null);
    expect(show.value).toBe(5);
  });
});
