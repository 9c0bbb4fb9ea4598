import { describe, expect, it } from "vitest";
import { type Download, Downloads } from "./fetch_progress";

/** A response that comes in parts. */
const inParts = (parts: readonly number[][], headers: Record<string, string>): Response =>
  new Response(
    new ReadableStream({
      start: (controller) => {
        for (const part of parts) controller.enqueue(Uint8Array.from(part));
        controller.close();
      },
    }),
    { headers },
  );

describe("downloads", () => {
  it("gives all bytes, and tells how many of how many have come", async () => {
    const downloads = new Downloads();
    const reports: (readonly [number, number | undefined])[] = [];
    downloads.listen(() => {
      const { received, total } = downloads.all[0] as Download;
      reports.push([received, total]);
    });
    const parts = inParts([[1, 2], [3], [4, 5, 6]], { "content-length": "6" });
    const { bytes } = await downloads.follow("/manifest", async () => parts);
    expect([...bytes]).toEqual([1, 2, 3, 4, 5, 6]);
    expect(reports).toEqual([
      [0, undefined],
      [2, 6],
      [3, 6],
      [6, 6],
      [6, 6],
    ]);
    expect(downloads.all[0]?.ended).toBe(true);
  });

  it("knows no length of what comes packed, nor of what nobody has said", async () => {
    const downloads = new Downloads();
    await downloads.follow("/a", async () => inParts([[1]], { "content-length": "9", "content-encoding": "gzip" }));
    await downloads.follow("/b", async () => inParts([[1]], {}));
    expect(downloads.all.map(({ total }) => total)).toEqual([undefined, undefined]);
  });

  it("ends what fails, and rejects as it does", async () => {
    const downloads = new Downloads();
    await expect(downloads.follow("/a", () => Promise.reject(new Error("away")))).rejects.toThrow("away");
    expect(downloads.all[0]?.ended).toBe(true);
  });
});
