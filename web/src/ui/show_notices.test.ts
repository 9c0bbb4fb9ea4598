import { describe, expect, it } from "vitest";
import { ShowNotices } from "./show_notices";

class Memory {
  readonly kept = new Map<string, string>();
  getItem = (key: string): string | null => this.kept.get(key) ?? null;
  setItem = (key: string, value: string): void => void this.kept.set(key, value);
}

const notice = (id: string) => ({ id, time: Date.now() / 1000, text: `notice ${id}`, solved: false });
const ids = (notices: ShowNotices): string[] => notices.open.map(({ id }) => id);

describe("notices of the show", () => {
  it("stay through a reload until they are dismissed, and do not come back", () => {
    const memory = new Memory();
    const first = new ShowNotices(
      () => memory,
      () => undefined,
    );
    first.receive([notice("1"), notice("2")]);
    expect(ids(first)).toEqual(["1", "2"]);
    first.dismiss("1");
    first.receive([notice("1"), notice("2")]);
    expect(ids(first)).toEqual(["2"]);
    const reloaded = new ShowNotices(
      () => memory,
      () => undefined,
    );
    expect(ids(reloaded)).toEqual([]);
    reloaded.receive([notice("1"), notice("2"), notice("3")]);
    expect(ids(reloaded)).toEqual(["2", "3"]);
  });

  it("grow older on the page: each minute it is told that there is something else to read", () => {
    let [now, changes] = [1000, 0];
    const counted = () => {
      changes += 1;
    };
    const notices = new ShowNotices(
      () => new Memory(),
      counted,
      () => now,
    );
    const crash = { ...notice("1"), time: 1000 };
    const seen = [0, 1, 59, 61, 62, 119, 121].map((passed) => {
      now = 1000 + passed;
      notices.receive([crash]);
      return changes;
    });
    expect(seen).toEqual([1, 1, 1, 2, 2, 2, 3]);
  });

  it("come to a new page once where they are old, and stay there until they are dismissed", () => {
    const [memory, old] = [new Memory(), { ...notice("1"), time: 100 }];
    const opened = () =>
      new ShowNotices(
        () => memory,
        () => undefined,
        () => 1000,
      );
    const first = opened();
    for (let times = 0; times < 3; times++) first.receive([old]);
    expect(ids(first)).toEqual(["1"]);
    const second = opened();
    second.receive([old]);
    expect(ids(second)).toEqual([]);
    first.dismiss("1");
    expect(ids(first)).toEqual([]);
  });

  it("go by themselves where they say that something is well again", () => {
    let now = 100;
    const notices = new ShowNotices(
      () => new Memory(),
      () => undefined,
      () => now,
    );
    const solved = { ...notice("1"), time: 100, solved: true };
    notices.receive([solved]);
    expect(ids(notices)).toEqual(["1"]);
    now = 121;
    notices.receive([solved]);
    expect(ids(notices)).toEqual([]);
  });

  it("tell of a change as they grow older, for their age is said", () => {
    let [now, changes] = [100, 0];
    const notices = new ShowNotices(
      () => new Memory(),
      () => {
        changes += 1;
      },
      () => now,
    );
    for (now of [100, 150, 161, 170, 221]) notices.receive([{ ...notice("1"), time: 100 }]);
    expect(changes).toBe(3);
  });

  it("tell of a change once, however often they come", () => {
    const memory = new Memory();
    let changes = 0;
    const notices = new ShowNotices(
      () => memory,
      () => {
        changes += 1;
      },
    );
    for (let time = 0; time < 5; time++) notices.receive([notice("1")]);
    expect(changes).toBe(1);
    notices.dismiss("1");
    notices.dismiss("1");
    expect(changes).toBe(2);
  });

  it.each([null, "{", "7", '[1, "x", null]'])("begin anew where the store holds %s", (kept) => {
    const memory = new Memory();
    if (kept !== null) memory.kept.set("omote-dismissed-notices", kept);
    const notices = new ShowNotices(
      () => memory,
      () => undefined,
    );
    notices.receive([notice("1")]);
    expect(ids(notices)).toEqual(["1"]);
  });

  it("are dismissed where nothing can be stored too", () => {
    const refuse = (): never => {
      throw new Error("no");
    };
    for (const storage of [refuse, () => ({ getItem: refuse, setItem: refuse })]) {
      const notices = new ShowNotices(storage, () => undefined);
      notices.receive([notice("1"), notice("2")]);
      notices.dismiss("2");
      expect(ids(notices)).toEqual(["1"]);
    }
  });
});
