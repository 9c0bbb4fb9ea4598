/** Runs in the thread of the sound: hands chunks of 10 ms to the page. Its output stays
 * silent, so nothing reaches a speaker. */

import { SAMPLE_RATE } from "./microphone_messages";
import { SoundChunks } from "./sound_chunks";

declare const sampleRate: number;
declare function registerProcessor(name: string, processor: new () => AudioWorkletProcessor): void;
declare class AudioWorkletProcessor {
  readonly port: MessagePort;
}

class Capture extends AudioWorkletProcessor {
  readonly #chunks = new SoundChunks(sampleRate, SAMPLE_RATE);

  process([input]: Float32Array[][]): boolean {
    const [first, second] = input ?? [];
    if (first === undefined) return true;
    const chunk = this.#chunks.push(
      second === undefined ? first : first.map((left, at) => (left + (second[at] ?? 0)) / 2),
    );
    if (chunk !== null) this.port.postMessage(chunk, [chunk.buffer]);
    return true;
  }
}

registerProcessor("capture", Capture);
