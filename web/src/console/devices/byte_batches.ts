/** What MIDI devices send, batched: the first bytes go at once, those of the next moment together. */

/** Milliseconds between two messages of one page: less than a frame, so that nothing waits for longer than that. */
export const BATCH_MILLISECONDS = 8;
/** Bytes of one message at most, as the wire has it (`MidiBytes`). */
export const LONGEST_BATCH = 1024;
/** Clocks and the like, which no control sends. */
const REAL_TIME = 0xf8;

export class ByteBatches {
  readonly #waiting = new Map<string, number[]>();
  #sent = Number.NEGATIVE_INFINITY;
  #asked = false;

  /** `later`: calls what it gets after so many milliseconds, or much later on a page that is out of sight. */
  constructor(
    private readonly send: (device: string, data: Uint8Array) => void,
    private readonly now: () => number,
    private readonly later: (call: () => void, milliseconds: number) => void,
  ) {}

  /** A device has sent a message. */
  add(device: string, data: ArrayLike<number>): void {
    if (data.length === 0 || (data[0] as number) >= REAL_TIME) return;
    const bytes = this.#waiting.get(device) ?? [];
    for (let index = 0; index < data.length; index += 1) bytes.push(data[index] as number);
    this.#waiting.set(device, bytes);
    const left = this.#sent + BATCH_MILLISECONDS - this.now();
    if (left <= 0) this.flush();
    else if (!this.#asked) {
      this.#asked = true;
      this.later(() => {
        this.#asked = false;
        this.flush();
      }, left);
    }
  }

  /** Sends what waits. */
  flush(): void {
    if (this.#waiting.size === 0) return;
    this.#sent = this.now();
    for (const [device, bytes] of this.#waiting)
      for (let at = 0; at < bytes.length; at += LONGEST_BATCH)
        this.send(device, Uint8Array.from(bytes.slice(at, at + LONGEST_BATCH)));
    this.#waiting.clear();
  }

  /** A device is gone: what waits of it goes before. */
  forget(device: string): void {
    this.flush();
    this.#waiting.delete(device);
  }
}
