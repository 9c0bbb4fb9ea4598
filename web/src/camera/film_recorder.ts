/** Saves what the camera sees as a file of this machine: a film that its performer may pass on. Nothing is sent. */

/** Seconds after which a film ends by itself: a guided minute, and some play. */
export const FILM_SECONDS = 90;

/** A film that is being taken. */
export class FilmRecorder {
  #recorder: MediaRecorder | null = null;
  #ending = 0;

  constructor(private readonly changed: () => void) {}

  get records(): boolean {
    return this.#recorder !== null;
  }

  /** Takes a film of a stream until it is stopped. */
  start(stream: MediaStream): void {
    const recorder = new MediaRecorder(stream, { videoBitsPerSecond: 6_000_000 });
    const parts: Blob[] = [];
    recorder.ondataavailable = ({ data }) => parts.push(data);
    recorder.onstop = () => {
      save(new Blob(parts, { type: recorder.mimeType }));
      this.#recorder = null;
      this.changed();
    };
    recorder.start();
    this.#recorder = recorder;
    this.#ending = window.setTimeout(() => this.stop(), 1000 * FILM_SECONDS);
    this.changed();
  }

  /** Ends the film, which the browser then saves. */
  stop(): void {
    window.clearTimeout(this.#ending);
    if (this.#recorder?.state === "recording") this.#recorder.stop();
  }
}

function save(film: Blob): void {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(film);
  link.download = `omote-hand-${new Date().toISOString().slice(0, 19).replace(/:/g, "-")}.webm`;
  link.click();
  window.setTimeout(() => URL.revokeObjectURL(link.href), 10_000);
}
