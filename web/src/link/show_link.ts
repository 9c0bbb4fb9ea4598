/** The link of stages and consoles to the show. */

import type { Bus } from "./bus";
import { now, ServerClock } from "./clock";
import type { FromClient, FromServer, Hello, Pong, State, Welcome } from "./messages";
import { LINK_PATH, PROTOCOL_VERSION } from "./messages";
import { ReconnectingSocket } from "./reconnecting_socket";
import { type Hearing, hear } from "./topics";

/** What orders states: the server's start, then the count since. */
export interface Stamp {
  epoch: number;
  number: number;
}

/** Lets only states through that are newer than all before: a lower (epoch, number) is ignored. */
export class Newest {
  private last: Stamp = { epoch: -Infinity, number: -Infinity };
  /** How many states came too late. */
  ignored = 0;

  accept(stamp: Stamp): boolean {
    const { epoch, number } = this.last;
    const newer = stamp.epoch > epoch || (stamp.epoch === epoch && stamp.number > number);
    if (newer) this.last = { epoch: stamp.epoch, number: stamp.number };
    else this.ignored += 1;
    return newer;
  }
}

/** What a page wants to hear: messages by their tags, and what the link itself knows. */
export type LinkHandlers = Omit<Hearing<FromServer>, "cast"> & {
  /** The cast has other names or contents now: fetch the manifest again (`Library.renew`). */
  cast?: () => void;
  /** Every message, before whoever hears its tag; of states none that is older than one before. */
  every?: (message: FromServer) => void;
  /** A ping came back after so many seconds. */
  trip?: (seconds: number) => void;
  /** The token of this page is not valid any more. */
  revoked?: () => void;
  /** The link came up (true) or went down (false). */
  connected?: (up: boolean) => void;
};

const SILENCE = 1.5; // seconds without any message after which a link counts as dead
const PING_EVERY = 1.0;

/**
 * The link of a page to the show: says hello, keeps the server's clock, and lets only the newest state of its own bus
 * through.
 */
export class ShowLink {
  readonly clock = new ServerClock();
  readonly newest = new Newest();
  private readonly socket: ReconnectingSocket<FromServer, FromClient>;
  private pinged = 0;
  private epoch = -1;
  private revision = -1;

  constructor(
    private readonly role: Hello["role"],
    private readonly handlers: LinkHandlers = {},
    private readonly name: () => string = () => "",
    private readonly page = "",
    private readonly seat = "",
    private readonly bus: Bus = "air",
  ) {
    this.socket = new ReconnectingSocket(LINK_PATH, {
      silence: SILENCE,
      interval: 250,
      opened: () => this.introduce(),
      received: (message) => this.obey(message),
      lost: (wasUp) => wasUp && this.handlers.connected?.(false),
      revoked: () => this.handlers.revoked?.(),
      expects: () => true,
      looked: () => this.socket.up && now() - this.pinged > PING_EVERY && this.ping(),
    });
  }

  /** Whether the server has answered our hello. */
  get connected(): boolean {
    return this.socket.up;
  }

  /** Sends a message; false when the link is down (it is not kept: a late command is worse than none). */
  send(message: FromClient): boolean {
    return this.socket.send(message);
  }

  /** Says who this is, and what it looks at: when the link opens, and again under another name. */
  introduce(): void {
    const { role, page, seat, bus } = this;
    this.send({ type: "hello", role, version: PROTOCOL_VERSION, name: this.name(), page, seat, bus });
  }

  /** Ends the link for good. */
  close(): void {
    this.socket.close();
  }

  private ping(): void {
    this.pinged = now();
    this.send({ type: "ping", sent: this.pinged });
  }

  private obey(message: FromServer): void {
    // a server of before the preview says no bus
    if (message.type === "state" && ((message.bus ?? "air") !== this.bus || !this.newest.accept(message))) return;
    this.handlers.every?.(message);
    if (message.type === "welcome") this.welcome(message);
    else if (message.type === "state") this.state(message);
    else if (message.type === "pong") this.pong(message);
    else if (message.type === "cast") this.recast(message.revision);
    else hear<FromServer>(this.handlers, message);
  }

  private welcome(welcome: Welcome): void {
    if (welcome.epoch !== this.epoch) this.clock.reset();
    this.epoch = welcome.epoch;
    this.revision = welcome.revision;
    this.socket.accept();
    this.ping();
    this.handlers.welcome?.(welcome);
    this.handlers.connected?.(true);
  }

  private pong({ sent, time }: Pong): void {
    this.handlers.trip?.(this.socket.heard - sent);
    this.clock.measure(sent, time, this.socket.heard);
  }

  private recast(revision: number): void {
    if (revision <= this.revision) return;
    this.revision = revision;
    this.handlers.cast?.();
  }

  private state(state: State): void {
    if (state.epoch === this.epoch) this.recast(state.revision); // the message may have been lost
    this.clock.arrived(state.time, this.socket.heard);
    this.handlers.state?.(state);
  }
}
