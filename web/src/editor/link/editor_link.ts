/** The editor's link to the server. */

import { encode } from "@msgpack/msgpack";
import {
  type Cancel,
  EDITING_LIMIT,
  EDITING_PATH,
  EDITING_VERSION,
  type FromEditor,
  type Greeted,
  type ToEditor,
} from "../../link/editing_messages";
import { ReconnectingSocket } from "../../link/reconnecting_socket";
import { PendingRequests } from "./pending_requests";
import type { EditorAnswer, Request } from "./requests";

export interface EditorLinkHandlers {
  greeted: (greeted: Greeted) => void;
  /** What answers no request of ours. */
  message: (message: ToEditor) => void;
  connected: (up: boolean) => void;
  /** The token of this page is not valid any more. */
  revoked?: () => void;
}

/** Who greets: an id that a reload keeps, and a name that others read. */
export interface Identity {
  readonly editor: string;
  readonly name: string;
}

/** Seconds without a word while an answer is due, after which a link counts as dead. */
const SILENCE = 20;

/** The link of an editor to the server: greets, and loses no edit while the connection comes and goes. */
export class EditorLink {
  readonly #socket: ReconnectingSocket<ToEditor, FromEditor>;
  readonly #pending = new PendingRequests((message) => this.#socket.send(message));

  constructor(
    private identity: Identity,
    private readonly handlers: EditorLinkHandlers,
  ) {
    this.#socket = new ReconnectingSocket(EDITING_PATH, {
      silence: SILENCE,
      interval: 1000,
      opened: () => this.#socket.send({ type: "greet", ...this.identity, version: EDITING_VERSION }),
      received: (message) => this.#receive(message),
      revoked: () => this.handlers.revoked?.(),
      lost: (wasUp) => this.#lost(wasUp),
      expects: () => !this.#socket.up || this.#pending.size > 0,
    });
  }

  async ask(request: Request): Promise<EditorAnswer> {
    const size = encode(request).length;
    if (size > EDITING_LIMIT - 16)
      throw new Error(`This edit is ${size} bytes, expected at most ${EDITING_LIMIT}: use fewer points or layers.`);
    if (this.#pending.size === 0) this.#socket.awaitMessage();
    return this.#pending.ask(request);
  }

  /** Ends a long request; false while the link is lost. */
  cancel(message: Cancel): boolean {
    return this.#socket.send(message);
  }

  /** Greets anew under another name. */
  rename(name: string): void {
    this.identity = { ...this.identity, name };
    this.#socket.reconnect();
  }

  #lost(wasUp: boolean): void {
    if (wasUp) this.handlers.connected(false);
    this.#pending.down();
  }

  #receive(message: ToEditor): void {
    if (message.type === "greeted") this.#greeted(message);
    else if (!this.#pending.answer(message)) this.handlers.message(message);
  }

  #greeted(greeted: Greeted): void {
    this.#socket.accept();
    this.handlers.greeted(greeted);
    this.#pending.up(greeted.show);
    this.handlers.connected(true);
  }
}
