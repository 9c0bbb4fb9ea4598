/** Files that the show takes in one after the other, while the console is played: how far each is, and what came of it. */

import { type Imported, type ImportKind, importFile, sayTakenIn } from "../../ui/file_import";
import { CancelledError, type LongRequest, type LongRequests } from "../../ui/long_requests";
import type { ConsoleStore } from "../store/console_store";
import type { Offer } from "../store/page_store";
import type { OwnItem, OwnItems } from "./own_items";

/** The file that is being taken in, and how many wait behind it. */
export interface RunningImport {
  readonly file: string;
  readonly waiting: number;
  /** How far the show is; null before it is asked and once it has answered. */
  readonly request: LongRequest | null;
}

export type TakeIn = (file: File, kind: ImportKind, requests: LongRequests) => Promise<Imported>;

declare module "../controls/console_element" {
  interface ConsoleContext {
    readonly imports: FileImports;
  }
}

export class FileImports {
  #file: string | null = null;
  readonly #waiting: (readonly [File, ImportKind])[] = [];

  constructor(
    private readonly store: ConsoleStore,
    private readonly items: OwnItems,
    readonly requests: LongRequests,
    private readonly takeIn: TakeIn = importFile,
  ) {
    requests.listen(() => store.tell("import"));
    store.hear("progress", (progress) => requests.receive(progress));
  }

  /** What is under way; null for nothing. */
  get running(): RunningImport | null {
    if (this.#file === null) return null;
    return { file: this.#file, waiting: this.#waiting.length, request: this.requests.all[0] ?? null };
  }

  /** Takes files in, after those that are under way. */
  async add(files: readonly File[], kind: ImportKind): Promise<void> {
    this.#waiting.push(...files.map((file) => [file, kind] as const));
    if (this.#file === null) await this.#runAll();
    else this.store.tell("import");
  }

  /** Ends the file under way and forgets those that wait; what came in before the show hears of it stays. */
  cancel(): void {
    const request = this.running?.request;
    if (request === undefined || request === null) return;
    this.#waiting.length = 0;
    this.requests.cancel(request.id);
    if (this.running?.request?.ending === false) this.store.say("Not cancelled: the link to the show is lost.");
  }

  async #runAll(): Promise<void> {
    for (let next = this.#waiting.shift(); next !== undefined; next = this.#waiting.shift()) await this.#run(...next);
    this.#show(null);
  }

  async #run(file: File, kind: ImportKind): Promise<void> {
    this.#show(file.name);
    await this.takeIn(file, kind, this.requests).then(
      (imported) => this.#tell(file.name, imported),
      (error: unknown) => this.store.say(sentenceOf(error as Error, kind)),
    );
  }

  #tell(file: string, imported: Imported): void {
    const items: readonly (OwnItem & { known: boolean })[] = imported.items;
    const [added, existing] = [items.filter((item) => !item.known), items.filter((item) => item.known)];
    const says = sayTakenIn(imported);
    const both = (): void => {
      for (const item of existing) this.items.copy(item);
    };
    const offers: Offer[] = existing.length === 0 ? [] : [{ label: "Keep both", act: both }];
    if (added.length === 0) this.store.say(`Nothing new in ${file}: ${says}.`, "attention", offers);
    else this.store.offerUndo(`Taken in, under Own: ${says}.`, this.items.stepOf(`take in ${file}`, added), offers);
  }

  #show(file: string | null): void {
    this.#file = file;
    this.store.tell("import");
  }
}

const sentenceOf = (error: Error, kind: ImportKind): string =>
  kind === "face" || error instanceof CancelledError
    ? error.message
    : `${error.message} Faces come in by Set-up or the editor.`;
