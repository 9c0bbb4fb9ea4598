/** The notes that a page shows: read again every two seconds, written, changed, deleted and brought back. */

import type { ReactiveController, ReactiveControllerHost } from "lit";
import type { RecordingsDocument } from "../link/messages";
import type { TimedNote } from "./note_texts";
import { deleteNote, type Note, readRecordings, seekReplay, sinceBegin, writeNote } from "./recordings";

const POLL = 2000;
const EMPTY: RecordingsDocument = {
  spans: [],
  kept: [],
  markers: [],
  files: [],
  name: "",
  role: "view",
  now: null,
  cue: "",
};

/** The notes of a page (`host`), which renders again when they change. */
export class NoteBook implements ReactiveController {
  document = EMPTY;
  /** Why something could not be done or read; "" where all is well. */
  failure = "";
  /** The note that was deleted last: it can be brought back. */
  deleted: Note | undefined;
  #polling: ReturnType<typeof setInterval> | undefined;

  constructor(private readonly host: ReactiveControllerHost) {
    host.addController(this);
  }

  hostConnected(): void {
    this.#polling = setInterval(() => void this.read(), POLL);
    void this.read();
  }

  hostDisconnected(): void {
    clearInterval(this.#polling);
  }

  /** Whether a show plays: what is looked at is else a replay. */
  get live(): boolean {
    return this.document.now !== null;
  }

  /** All notes of a start of the show, in their order; of all starts where none is given. */
  notes(start?: number): TimedNote[] {
    return this.document.markers
      .filter((note) => start === undefined || note.start === start)
      .map((note) => ({ ...note, since: sinceBegin(this.document, note) }));
  }

  /** Whether this page may change a note: operators all, others their own. */
  readonly mayChange = ({ who }: Note): boolean => {
    const { role, name } = this.document;
    return role !== "view" || (name !== "" && who === name);
  };

  async read(): Promise<void> {
    await this.#do(async () => {
      this.document = await readRecordings();
    });
  }

  /** Notes something of now, or of `before` seconds ago; whether it was. */
  add(name: string, before: number, who: string): Promise<boolean> {
    return this.#change(() => writeNote({ name, before, who }));
  }

  /** Notes something of a moment of a start of the show. */
  addAt(name: string, start: number, at: number, who: string): Promise<boolean> {
    return this.#change(() => writeNote({ name, start, at, who }));
  }

  rename({ id }: Note, name: string): Promise<boolean> {
    return this.#change(() => writeNote({ name }, id));
  }

  async delete(note: Note): Promise<void> {
    if (await this.#change(() => deleteNote(note.id))) this.deleted = note;
    this.host.requestUpdate();
  }

  async restore(): Promise<void> {
    const note = this.deleted;
    if (note === undefined) return;
    if (await this.addAt(note.name, note.start, note.at, note.who)) this.deleted = undefined;
    this.host.requestUpdate();
  }

  async seek({ start, at }: Note): Promise<void> {
    await this.#do(() => seekReplay(start, at));
  }

  async #change(change: () => Promise<void>): Promise<boolean> {
    const done = await this.#do(change);
    if (done) await this.read();
    return done;
  }

  async #do(act: () => Promise<void>): Promise<boolean> {
    try {
      await act();
      this.failure = "";
      return true;
    } catch (error) {
      this.failure = (error as Error).message;
      return false;
    } finally {
      this.host.requestUpdate();
    }
  }
}
