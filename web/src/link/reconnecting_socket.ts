/** A WebSocket with msgpack messages that comes back: both links of the pages are built on it. */

import { decode, encode } from "@msgpack/msgpack";
import { now } from "./clock";
import { REVOKED_CODE } from "./constants";

/** What the server answers to a token that is not valid, or to none. */
const UNAUTHORIZED = 401;

/** Bytes that wait in a connection that is slow: newer ones are dropped, so that what arrives is never old. */
const MOST_UNSENT = 32768;

/** What a link does with its socket. */
export interface SocketOwner<Incoming> {
  /** Seconds without a message after which the connection counts as dead; those in which the page itself was busy, so
   * that no message could be handled, do not count. */
  readonly silence: number;
  /** Milliseconds between two looks at the silence. */
  readonly interval: number;
  /** The connection is open: the link greets. */
  opened(): void;
  received(message: Incoming): void;
  /** The connection is gone; `wasUp`: the server had accepted it. Another one is opened after a pause. */
  lost(wasUp: boolean): void;
  /** The token of this page is not valid any more; without this the connection is tried again. */
  revoked?(): void;
  /** Whether a message is due, so that silence means death. */
  expects(): boolean;
  /** Called at every look, after the silence was judged. */
  looked?(): void;
}

/** The address of a path on the host that served this page. */
const addressOf = (path: string, page: Location = location): string =>
  `${page.protocol === "https:" ? "wss" : "ws"}://${page.host}${path}`;

/** One connection at a time; a lost one is opened again, for ever, after the pauses of `Backoff`. */
export class ReconnectingSocket<Incoming, Outgoing> {
  /** When the last message came, or the connection was begun; seconds on the page's clock. */
  heard = 0;
  #socket: WebSocket | null = null;
  #up = false;
  #closed = false;
  #asking = false;
  #silent = 0; // seconds
  #looked = 0;
  #timer: ReturnType<typeof setTimeout> | undefined;
  readonly #backoff = new Backoff();
  readonly #watch: ReturnType<typeof setInterval>;

  constructor(
    private readonly path: string,
    private readonly owner: SocketOwner<Incoming>,
  ) {
    this.#watch = setInterval(() => this.#look(), owner.interval);
    this.#open();
  }

  /** Whether the server has accepted the present connection. */
  get up(): boolean {
    return this.#up;
  }

  /** The server has answered the greeting. */
  accept(): void {
    this.#backoff.reset();
    this.#up = true;
  }

  /** Nothing was due before: silence counts from here. */
  awaitMessage(): void {
    this.#silent = 0;
    this.#looked = now();
  }

  /** Sends a message; false where no connection is open (the message is not kept). */
  send(message: Outgoing): boolean {
    if (this.#socket?.readyState !== WebSocket.OPEN) return false;
    this.#socket.send(encode(message));
    return true;
  }

  /** Sends bytes that are no message; where no connection is open they are dropped. */
  sendBytes(data: ArrayBuffer): void {
    if (this.#socket?.readyState === WebSocket.OPEN && this.#socket.bufferedAmount < MOST_UNSENT)
      this.#socket.send(data);
  }

  /** Gives up the present connection; another one is opened after a pause. */
  reconnect(): void {
    if (this.#socket === null) return; // given up before
    this.#drop();
    if (!this.#closed) this.#timer = setTimeout(() => this.#open(), this.#backoff.next() * 1000);
  }

  /** Ends it for good. */
  close(): void {
    this.#closed = true;
    clearInterval(this.#watch);
    clearTimeout(this.#timer);
    this.#drop();
  }

  #open(): void {
    const socket = new WebSocket(addressOf(this.path));
    socket.binaryType = "arraybuffer";
    this.#socket = socket;
    this.heard = now();
    this.awaitMessage();
    let opened = false;
    socket.onopen = () => {
      opened = true;
      this.owner.opened();
    };
    socket.onmessage = (event: MessageEvent<ArrayBuffer>) => this.#receive(event.data);
    socket.onclose = (event: CloseEvent) => {
      this.reconnect();
      if (event.code === REVOKED_CODE) this.owner.revoked?.();
      else if (!opened) void this.#askWhetherRevoked();
    };
  }

  /** A browser does not say why a connection was not made: it may be that the token has ended while the page was away. */
  async #askWhetherRevoked(): Promise<void> {
    if (this.#asking || this.owner.revoked === undefined) return;
    this.#asking = true;
    const answer = await fetch("/access", { cache: "no-store" }).catch(() => null); // null: the show is not there
    this.#asking = false;
    if (answer?.status === UNAUTHORIZED && !this.#closed) this.owner.revoked();
  }

  #drop(): void {
    const [socket, wasUp] = [this.#socket, this.#up];
    [this.#socket, this.#up] = [null, false];
    if (socket === null) return;
    socket.onopen = socket.onmessage = socket.onclose = null;
    socket.close();
    this.owner.lost(wasUp);
  }

  /** A page that draws for seconds hears nothing meanwhile, and its looks are late: each counts as one that is in time,
   * and between two of them messages have their turn. */
  #look(): void {
    const time = now();
    this.#silent += Math.min(time - this.#looked, this.owner.interval / 1000);
    this.#looked = time;
    if (this.owner.expects() && this.#silent > this.owner.silence) this.reconnect();
    this.owner.looked?.();
  }

  #receive(data: ArrayBuffer): void {
    this.heard = now();
    this.#silent = 0;
    let message: Incoming;
    try {
      message = decode(data) as Incoming;
    } catch {
      return; // half a message from a dying server
    }
    this.owner.received(message);
  }
}

/** Waits between attempts: 50 ms at first, doubling up to half a second, each jittered by half, for ever. */
export class Backoff {
  private attempt = 0;

  constructor(
    private readonly first = 0.05,
    private readonly longest = 0.5,
    private readonly random: () => number = Math.random,
  ) {}

  /** Seconds to wait before the next attempt. */
  next(): number {
    const wait = Math.min(this.longest, this.first * 2 ** this.attempt);
    this.attempt = Math.min(this.attempt + 1, 30);
    return wait * (0.5 + this.random());
  }

  /** After a success. */
  reset(): void {
    this.attempt = 0;
  }
}
