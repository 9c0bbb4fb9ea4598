import { decode, encode } from "@msgpack/msgpack";
import { Backoff } from "./backoff";
import { now, ServerClock } from "./clock";
import type { Crew, FromClient, FromServer, Hello, Kept, State, Welcome } from "./messages";
import { LINK_PATH, PROTOCOL_VERSION } from "./messages";
import { Newest } from "./newest";

/** What a page wants to hear; every handler may be left out. */
export interface LinkHandlers {
  /** A newer state than any before; older ones never arrive here. */
  state?: (state: State) => void;
  welcome?: (welcome: Welcome) => void;
  crew?: (crew: Crew) => void;
  /** The cast has other names or contents now: fetch the manifest again (`Library.renew`). */
  cast?: () => void;
  /** What was asked to be kept is in the cast. */
  kept?: (kept: Kept) => void;
  /** A message of ours was not obeyed; the sentence is for the operator. */
  refused?: (reason: string) => void;
  /** A ping came back after so many seconds. */
  trip?: (seconds: number) => void;
  /** The link came up (true) or went down (false). */
  connected?: (up: boolean) => void;
}

const SILENCE = 1.5; // seconds without any message after which a link counts as dead
const PING_EVERY = 1.0;

/** The address of the link on the host that served this page. */
export const linkAddress = (page: Location = location): string =>
  `${page.protocol === "https:" ? "wss" : "ws"}://${page.host}${LINK_PATH}`;

/** The link to the server: says hello, keeps the clock, lets the newest state win, and reconnects for ever. */
export class ShowLink {
  readonly clock = new ServerClock();
  readonly newest = new Newest();
  private readonly backoff = new Backoff();
  private socket: WebSocket | undefined;
  private heard = 0;
  private pinged = 0;
  private epoch = -1;
  private revision = -1;
  private up = false;
  private closed = false;
  private timer: ReturnType<typeof setTimeout> | undefined;
  private readonly watch: ReturnType<typeof setInterval>;

  constructor(
    private readonly role: Hello["role"],
    private readonly handlers: LinkHandlers = {},
    private readonly address: string = linkAddress(),
  ) {
    this.watch = setInterval(() => this.look(), 250);
    this.open();
  }

  /** Whether the server has answered our hello. */
  get connected(): boolean {
    return this.up;
  }

  /** Sends a message; false when the link is down (it is not kept: a late command is worse than none). */
  send(message: FromClient): boolean {
    if (this.socket?.readyState !== WebSocket.OPEN) return false;
    this.socket.send(encode(message));
    return true;
  }

  /** Ends the link for good. */
  close(): void {
    this.closed = true;
    clearInterval(this.watch);
    clearTimeout(this.timer);
    this.drop();
  }

  private open(): void {
    const socket = new WebSocket(this.address);
    socket.binaryType = "arraybuffer";
    this.socket = socket;
    this.heard = now();
    socket.onopen = () => this.send({ type: "hello", role: this.role, version: PROTOCOL_VERSION });
    socket.onmessage = (event: MessageEvent<ArrayBuffer>) => this.receive(event.data);
    socket.onclose = () => this.lost(socket);
  }

  private lost(socket: WebSocket): void {
    if (socket !== this.socket) return; // one we gave up before
    this.drop();
    if (!this.closed) this.timer = setTimeout(() => this.open(), this.backoff.next() * 1000);
  }

  private drop(): void {
    const socket = this.socket;
    this.socket = undefined;
    if (socket !== undefined) {
      socket.onopen = socket.onmessage = socket.onclose = null;
      socket.close();
    }
    if (this.up) this.handlers.connected?.(false);
    this.up = false;
  }

  /** Gives up a link that has fallen silent, and pings a living one. */
  private look(): void {
    const time = now();
    if (this.socket !== undefined && time - this.heard > SILENCE) this.lost(this.socket);
    if (this.up && time - this.pinged > PING_EVERY) this.ping();
  }

  private ping(): void {
    this.pinged = now();
    this.send({ type: "ping", sent: this.pinged });
  }

  private receive(data: ArrayBuffer): void {
    this.heard = now();
    let message: FromServer;
    try {
      message = decode(data) as FromServer;
    } catch {
      return; // half a message from a dying server
    }
    this.obey(message);
  }

  private obey(message: FromServer): void {
    switch (message.type) {
      case "welcome":
        this.welcome(message);
        break;
      case "state":
        this.state(message);
        break;
      case "pong":
        this.handlers.trip?.(this.heard - message.sent);
        this.clock.measure(message.sent, message.time, this.heard);
        break;
      case "crew":
        this.handlers.crew?.(message);
        break;
      case "cast":
        this.recast(message.revision);
        break;
      case "kept":
        this.handlers.kept?.(message);
        break;
      case "refused":
        this.handlers.refused?.(message.reason);
        break;
    }
  }

  private welcome(welcome: Welcome): void {
    if (welcome.epoch !== this.epoch) this.clock.reset();
    this.epoch = welcome.epoch;
    this.revision = welcome.revision;
    this.up = true;
    this.backoff.reset();
    this.ping();
    this.handlers.welcome?.(welcome);
    this.handlers.connected?.(true);
  }

  private recast(revision: number): void {
    if (revision <= this.revision) return;
    this.revision = revision;
    this.handlers.cast?.();
  }

  private state(state: State): void {
    if (!this.newest.accept(state)) return;
    if (state.epoch === this.epoch) this.recast(state.revision); // the message may have been lost
    this.clock.arrived(state.time, this.heard);
    this.handlers.state?.(state);
  }
}
