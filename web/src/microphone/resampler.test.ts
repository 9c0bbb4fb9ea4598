import { describe, expect, it } from "vitest";
import { Resampler } from "./resampler";

const sine = (hertz: number, rate: number, count: number): Float32Array =>
  Float32Array.from({ length: count }, (_, at) => Math.sin((2 * Math.PI * hertz * at) / rate));
const power = (sound: Float32Array): number => sound.reduce((sum, sample) => sum + sample * sample, 0) / sound.length;

describe("a resampler", () => {
  for (const rate of [48000, 44100, 16000, 8000]) {
    it(`keeps speech at ${rate} samples a second`, () => {
      const resampled = new Resampler(rate, 16000).push(sine(1000, rate, rate));
      expect(Math.abs(resampled.length - 16000)).toBeLessThan(200);
      const wanted = sine(1000, 16000, 16000);

      expect(power(resampled.subarray(200, 15000))).toBeCloseTo(power(wanted.subarray(200, 15000)), 2);
    });
  }

  it("keeps out what would come back as another tone", () => {
    const resampled = new Resampler(48000, 16000).push(sine(11000, 48000, 48000));
    expect(10 * Math.log10(power(resampled.subarray(200)) / 0.5)).toBeLessThan(-40);
  });

  it("gives the same whatever the pieces", () => {
    const sound = sine(440, 44100, 4410);
    const whole = new Resampler(44100, 16000).push(sound);
    const pieces = new Resampler(44100, 16000);
    const parts: number[] = [];
    for (let at = 0; at < sound.length; at += 128) parts.push(...pieces.push(sound.subarray(at, at + 128)));
    expect(parts.length).toBe(whole.length);
    expect(Math.max(...parts.map((sample, at) => Math.abs(sample - (whole[at] ?? 0))))).toBeLessThan(1e-5);
  });

  it("is late by less than a millisecond or two", () => {
    expect(new Resampler(48000, 16000).delay(48000)).toBeLessThan(0.002);
  });
});
