import { describe, expect, it } from "vitest";
import type { Download } from "../../link/fetch_progress";
import { progressOf } from "./loading_progress";

const download = (address: string, received = 0, total?: number, ended = false): Download => ({
  address,
  received,
  total,
  ended,
});

describe("the progress of loading", () => {
  it("rises with every byte, and is whole when all has ended", () => {
    const shares = [0, 1e6, 2e6].map((received) => progressOf([download("/manifest", received, 2e6)], 1).share);
    expect([...shares].sort((a, b) => a - b)).toEqual(shares);
    expect(new Set(shares).size).toBe(3);
    const ended = Array.from({ length: 5 }, () => download("/assets/a", 1, 1, true));
    expect(progressOf(ended, 1).share).toBe(1);
  });

  it("says what comes, and how much of it where that is known", () => {
    expect(progressOf([], 4).words).toBe("Asking for the cast");
    expect(progressOf([download("/manifest", 1.2e6, 3.4e6)], 4).words).toBe("Fetching the cast: 1.2 of 3.4 MB");
    const both = [download("/tangents/a/b"), download("/assets/a", 5e5, 1e6), download("/manifest", 1, 1, true)];
    expect(progressOf(both, 4).words).toBe("Fetching faces, skin and hair, how each face moves: 0.5 of 1.0 MB");
    expect(progressOf([download("/manifest", 1, 1, true)], 4).words).toBe("Preparing the picture");
  });
});
