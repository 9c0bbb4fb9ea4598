import { decode, encode } from "@msgpack/msgpack";
import { Backoff } from "../../link/backoff";
import { now } from "../../link/clock";
import {
  EDITING_LIMIT,
  EDITING_PATH,
  EDITING_VERSION,
  type FromEditor,
  type Greeted,
  type ToEditor,
} from "../../link/editing_messages";
import { PendingRequests } from "./pending_requests";
import type { Answer, Request } from "./requests";

export interface EditorLinkHandlers {
  greeted: (greeted: Greeted) => void;
  /** What answers no request of ours. */
  message: (message: ToEditor) => void;
  connected: (up: boolean) => void;
}

/** Who greets: an id that a reload keeps, and a name that others read. */
export interface Identity {
  readonly editor: string;
  readonly name: string;
}

/** Seconds without a word while an answer is due, after which a link counts as dead. */
const SILENCE = 20;

const address = (page: Location = location): string =>
  `${page.protocol === "https:" ? "wss" : "ws"}://${page.host}${EDITING_PATH}`;

/** The link of an editor to the server: greets, reconnects for ever, and loses no edit on the way. */
export class EditorLink {
  readonly #outstanding = new PendingRequests((message) => this.#send(message));
  readonly #backoff = new Backoff();
  #socket: WebSocket | null = null;
  #up = false;
  #heard = 0;

  constructor(
    private who: Identity,
    private readonly handlers: EditorLinkHandlers,
  ) {
    setInterval(() => this.#look(), 1000);
    this.#open();
  }

  async ask(request: Request): Promise<Answer> {
    const size = encode(request).length;
    if (size > EDITING_LIMIT - 16)
      throw new Error(`This edit is ${size} bytes, expected at most ${EDITING_LIMIT}: use fewer points or layers.`);
    if (this.#outstanding.size === 0) this.#heard = now(); // silence counts from here
    return this.#outstanding.ask(request);
  }

  /** Greets anew under another name. */
  rename(name: string): void {
    this.who = { ...this.who, name };
    this.#lost();
  }

  #send(message: FromEditor): void {
    this.#socket?.send(encode(message));
  }

  #open(): void {
    const socket = new WebSocket(address());
    socket.binaryType = "arraybuffer";
    this.#socket = socket;
    this.#heard = now();
    socket.onopen = () => this.#send({ type: "greet", ...this.who, version: EDITING_VERSION });
    socket.onmessage = (event: MessageEvent<ArrayBuffer>) => this.#receive(event.data);
    socket.onclose = () => this.#lost();
  }

  #lost(): void {
    const socket = this.#socket;
    if (socket === null) return;
    this.#socket = null;
    socket.onopen = socket.onmessage = socket.onclose = null;
    socket.close();
    if (this.#up) this.handlers.connected(false);
    this.#up = false;
    this.#outstanding.down();
    setTimeout(() => this.#open(), this.#backoff.next() * 1000);
  }

  #look(): void {
    const due = !this.#up || this.#outstanding.size > 0;
    if (due && now() - this.#heard > SILENCE) this.#lost();
  }

  #receive(data: ArrayBuffer): void {
    this.#heard = now();
    const message = decode(data) as ToEditor;
    if (message.type === "greeted") this.#greeted(message);
    else if (!this.#outstanding.answer(message)) this.handlers.message(message);
  }

  #greeted(greeted: Greeted): void {
    this.#backoff.reset();
    this.#up = true;
    this.handlers.greeted(greeted);
    this.#outstanding.up();
    this.handlers.connected(true);
  }
}
