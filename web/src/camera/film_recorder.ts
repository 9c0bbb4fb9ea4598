/** Saves what the camera sees as a file of this machine: a film that its performer may pass on. Nothing is sent. */

/** Seconds after which a film ends by itself: a guided minute, and some play. */
export const FILM_SECONDS = 90;

/** A film that is being taken. */
export class FilmRecorder {
  /** The name of the file that was saved last; "" before. */
  saved = "";
  /** Why there is no film; "" for nothing. */
  failed = "";
  #recorder: MediaRecorder | null = null;
  #began = 0;
  #ticking = 0;
  #minute = Number.NaN;

  constructor(private readonly changed: () => void) {}

  get records(): boolean {
    return this.#recorder !== null;
  }

  /** Seconds until it ends by itself. */
  get left(): number {
    return Math.max(0, FILM_SECONDS - (performance.now() - this.#began) / 1000);
  }

  /** Takes a film of a stream until it is stopped. */
  start(stream: MediaStream): void {
    [this.saved, this.failed, this.#minute] = ["", "", Number.NaN];
    try {
      this.#record(new MediaRecorder(stream, { videoBitsPerSecond: 6_000_000 }));
    } catch (error) {
      this.failed = error instanceof Error ? error.message : String(error);
    }
    this.changed();
  }

  /** Notes that a guided minute begins now: the file's name says when, so that the moves asked for are known. */
  noteMinute(): void {
    if (this.records) this.#minute = (performance.now() - this.#began) / 1000;
  }

  /** Ends the film, which the browser then saves. */
  stop(): void {
    if (this.#recorder?.state === "recording") this.#recorder.stop();
  }

  #record(recorder: MediaRecorder): void {
    const parts: Blob[] = [];
    recorder.ondataavailable = ({ data }) => parts.push(data);
    recorder.onstop = () => {
      window.clearInterval(this.#ticking);
      this.#recorder = null;
      this.saved = save(new Blob(parts, { type: recorder.mimeType }), this.#minute);
      this.changed();
    };
    recorder.start();
    this.#recorder = recorder;
    this.#began = performance.now();
    this.#ticking = window.setInterval(() => {
      if (this.left === 0) this.stop();
      this.changed();
    }, 1000);
  }
}

/** Has the browser save a film. minute: the second of it at which a guided minute begins, NaN for none. Returns the file's name. */
function save(film: Blob, minute: number): string {
  const link = document.createElement("a");
  const made = new Date().toISOString().slice(0, 19).replace(/:/g, "-");
  const noted = Number.isNaN(minute) ? "" : `-minute-at-${minute.toFixed(2)}s`;
  link.href = URL.createObjectURL(film);
  link.download = `omote-hand-${made}${noted}.${film.type.includes("mp4") ? "mp4" : "webm"}`;
  link.click();
  window.setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
  return link.download;
}
