import { describe, expect, it } from "vitest";
import { SoundChunks } from "./sound_chunks";

describe("chunks of sound", () => {
  it("are whole pieces of 10 ms, as integers", () => {
    const chunks = new SoundChunks(48000, 16000);
    let count = 0;
    for (let block = 0; block < 375; block += 1) {
      const chunk = chunks.push(new Float32Array(128).fill(0.5));
      if (chunk === null) continue;
      expect(chunk.length % 160).toBe(0);
      count += chunk.length;
    }
    expect(count).toBeGreaterThan(15500);
    expect(count).toBeLessThanOrEqual(16000);
  });

  it("clip what is too loud", () => {
    const chunk = new SoundChunks(16000, 16000).push(new Float32Array(1600).fill(3));
    expect(Math.max(...(chunk ?? []))).toBe(32767);
  });
});
