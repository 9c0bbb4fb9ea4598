/** Requests that wait for their answers: numbered, and sent again to the same show when the link was lost before. */

import type { FromEditor, ToEditor } from "../../link/editing_messages";
import type { EditorAnswer, Request } from "./requests";

interface Waiting {
  readonly message: Extract<FromEditor, { request: number }>;
  readonly done: (answer: EditorAnswer) => void;
  readonly fail: (reason: Error) => void;
}

type Kind = Request["type"];

/** Done twice these would do something else than done once, so the user is asked instead. */
const ONCE: ReadonlySet<Kind> = new Set([
  "create_expression",
  "create_face",
  "duplicate",
  "undo",
  "redo",
  "save",
  "delete",
  "restore",
]);

/** What people call them. */
const NAMES: Partial<Record<Kind, string>> = {
  create_expression: "A new expression",
  create_face: "A new face",
  duplicate: "Duplicate",
  undo: "Undo",
  redo: "Redo",
  save: "Save",
  delete: "Delete",
  restore: "Restore",
};

export class PendingRequests {
  readonly #waiting = new Map<number, Waiting>();
  #last = 0;
  #up = false;
  /** The item that is open, to be opened again on the next link. */
  #open: number | null = null;
  /** The show that was greeted last; its numbers of items mean nothing in another one. */
  #show: string | null = null;

  /** `send` puts a message on the link; it is called only while the link is up. */
  constructor(private readonly send: (message: FromEditor) => void) {}

  get size(): number {
    return this.#waiting.size;
  }

  /** Sends a request, or keeps it until the link is there; rejects where it is refused or must not wait. */
  ask(request: Request): Promise<EditorAnswer> {
    const name = NAMES[request.type];
    if (!this.#up && ONCE.has(request.type))
      return Promise.reject(
        new Error(`${name}: not sent, because the link to the show is lost. Try again when it is back.`),
      );
    this.#last += 1;
    const message = { ...request, request: this.#last } as Waiting["message"];
    return new Promise((done, fail) => {
      this.#waiting.set(message.request, { message, done, fail });
      if (this.#up) this.send(message);
    });
  }

  /** The server has greeted: the open item is opened again, and what was not answered is sent again, in order; where
   * it serves another show, what waits fails. */
  up(show: string): void {
    this.#up = true;
    if (this.#show !== null && this.#show !== show) this.#forget();
    this.#show = show;
    if (this.#open !== null) this.send({ type: "open_item", request: 0, item: this.#open });
    for (const { message } of this.#waiting.values()) this.send(message);
  }

  /** The link is lost: what must not happen twice fails, all else waits. */
  down(): void {
    this.#up = false;
    for (const [number, { message, fail }] of this.#waiting) {
      if (!ONCE.has(message.type)) continue;
      this.#waiting.delete(number);
      fail(
        new Error(
          `${NAMES[message.type]}: the link to the show was lost before the answer. See whether it was done, and do it again if not.`,
        ),
      );
    }
  }

  /** What waits was meant for another show. */
  #forget(): void {
    const waiting = [...this.#waiting.values()];
    this.#waiting.clear();
    this.#open = null;
    for (const { message, fail } of waiting)
      fail(new Error(`${NAMES[message.type] ?? "An edit"}: not sent, because another show is served here now.`));
  }

  /** Takes a message of the server; true where it answered a request of ours. */
  answer(message: ToEditor): boolean {
    if (message.type === "draft") this.#open = message.item;
    if (!("request" in message) || message.type === "progress") return false;
    const asked = this.#waiting.get(message.request);
    if (asked === undefined) return false;
    this.#waiting.delete(message.request);
    if (asked.message.type === "close_item" && asked.message.item === this.#open) this.#open = null;
    if (message.type === "refused") asked.fail(new Error(message.reason));
    else asked.done(message);
    return true;
  }
}
