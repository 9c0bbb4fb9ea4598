/** Sound of any rate at another one, piece by piece: a low pass of windowed sincs (Smith, "Digital audio resampling"). */

const ZERO_CROSSINGS = 12;
const PHASES = 64;
/** Of the lower of both rates: what is above would come back as another tone. */
const PASS = 0.46;

export class Resampler {
  /** Input samples on either side of an output sample. */
  readonly #reach: number;
  readonly #step: number;
  readonly #taps: Float32Array;
  #rest: Float32Array;
  #at: number;

  constructor(from: number, to: number) {
    this.#step = from / to;
    const cutoff = PASS * Math.min(1, to / from); // cycles per input sample
    this.#reach = Math.ceil(ZERO_CROSSINGS / (2 * cutoff));
    this.#taps = lowPass(cutoff, this.#reach);
    this.#rest = new Float32Array(2 * this.#reach);
    this.#at = this.#reach;
  }

  /** Seconds of input, at its rate, by which what comes out is late. */
  delay(rate: number): number {
    return this.#reach / rate;
  }

  push(samples: Float32Array): Float32Array {
    const sound = new Float32Array(this.#rest.length + samples.length);
    sound.set(this.#rest);
    sound.set(samples, this.#rest.length);
    const resampled: number[] = [];
    for (; this.#at + this.#reach + 1 < sound.length; this.#at += this.#step) resampled.push(this.#sample(sound));
    const used = Math.floor(this.#at) - this.#reach;
    this.#rest = sound.slice(Math.max(0, used));
    this.#at -= Math.max(0, used);
    return Float32Array.from(resampled);
  }

  #sample(sound: Float32Array): number {
    const whole = Math.floor(this.#at);
    const phase = Math.round((this.#at - whole) * PHASES);
    const width = 2 * this.#reach + 1;
    let sum = 0;
    for (let tap = 0; tap < width; tap += 1)
      sum += (sound[whole - this.#reach + tap] ?? 0) * (this.#taps[phase * width + tap] ?? 0);
    return sum;
  }
}

/** The taps of all phases, one after the other; each sums to 1. */
function lowPass(cutoff: number, reach: number): Float32Array {
  const width = 2 * reach + 1;
  const taps = new Float32Array((PHASES + 1) * width);
  for (let phase = 0; phase <= PHASES; phase += 1) {
    const row = taps.subarray(phase * width, (phase + 1) * width);
    for (let tap = 0; tap < width; tap += 1) row[tap] = windowed(tap - reach - phase / PHASES, cutoff, reach);
    const sum = row.reduce((total, value) => total + value, 0);
    for (let tap = 0; tap < width; tap += 1) row[tap] = (row[tap] ?? 0) / sum;
  }
  return taps;
}

/** A sinc under the window of Blackman. */
function windowed(place: number, cutoff: number, reach: number): number {
  const turn = (Math.PI * place) / (reach + 1);
  if (Math.abs(turn) >= Math.PI) return 0;
  const window = 0.42 + 0.5 * Math.cos(turn) + 0.08 * Math.cos(2 * turn);
  const angle = 2 * Math.PI * cutoff * place;
  return window * (angle === 0 ? 1 : Math.sin(angle) / angle);
}
