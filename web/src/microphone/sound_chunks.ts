/** Sound in pieces of 10 ms, as samples of 16 bits at 16 kHz. */

import { Resampler } from "./resampler";

const CHUNK = 160;

export class SoundChunks {
  readonly #resampler: Resampler;
  #waiting = new Float32Array(0);

  constructor(rate: number, to: number) {
    this.#resampler = new Resampler(rate, to);
  }

  /** The whole chunks that these samples complete, as one; null where there is none. */
  push(samples: Float32Array): Int16Array | null {
    const resampled = this.#resampler.push(samples);
    const sound = new Float32Array(this.#waiting.length + resampled.length);
    sound.set(this.#waiting);
    sound.set(resampled, this.#waiting.length);
    const whole = Math.floor(sound.length / CHUNK) * CHUNK;
    this.#waiting = sound.slice(whole);
    return whole === 0 ? null : Int16Array.from(sound.subarray(0, whole), toInteger);
  }
}

const toInteger = (sample: number): number => Math.round(Math.max(-1, Math.min(1, sample)) * 32767);
