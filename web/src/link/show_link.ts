/** The link of stages and consoles to the show. */

import { now, ServerClock } from "./clock";
import type {
  BindingList,
  BindingsChanged,
  Crew,
  DeviceBytes,
  Devices,
  FromClient,
  FromServer,
  Hands,
  Hello,
  InputLog,
  ItemChanged,
  Kept,
  LeaseClaim,
  Leases,
  Notice,
  Pong,
  Progress,
  SourceState,
  Sources,
  SourceValues,
  State,
  Welcome,
} from "./messages";
import { LINK_PATH, PROTOCOL_VERSION } from "./messages";
import { ReconnectingSocket } from "./reconnecting_socket";

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

/** What the show says of who holds what. */
export type LeaseMessage = Leases | LeaseClaim;
/** What the show says of devices and of what they play. */
export type DeviceMessage = Devices | BindingList | BindingsChanged | InputLog | DeviceBytes;
const DEVICE_MESSAGES: ReadonlySet<string> = new Set<DeviceMessage["type"]>([
  "devices",
  "binding_list",
  "bindings_changed",
  "input_log",
  "device_bytes",
]);
const isOfDevices = (message: FromServer): message is DeviceMessage => DEVICE_MESSAGES.has(message.type);

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
  /** An own face or expression was renamed, deleted or restored. */
  itemChanged?: (changed: ItemChanged) => void;
  /** The names of all layouts in the show file. */
  layouts?: (names: readonly string[]) => void;
  /** What hands at other consoles move, by control, and the names of those consoles. */
  hands?: (hands: Hands["hands"]) => void;
  /** All sources that send. */
  sources?: (sources: readonly SourceState[]) => void;
  /** What the source that this page watches sends now. */
  sourceValues?: (values: SourceValues) => void;
  /** News of devices. */
  devices?: (message: DeviceMessage) => void;
  /** Whether this stage is the one that plays sounds. */
  playsSound?: (on: boolean) => void;
  /** How far a long request (an import, an export) is; those of other pages too. */
  progress?: (progress: Progress) => void;
  /** Everything that the crew must know: all of it, each time. */
  notices?: (notices: readonly Notice[]) => void;
  /** A message of ours was not obeyed; the sentence is for the operator; `id`: which, where it had one. */
  refused?: (reason: string, id: string, held: readonly string[]) => void;
  /** Who holds what; or another seat touched what this one holds, or has taken it over. */
  leases?: (message: LeaseMessage) => void;
  /** A ping came back after so many seconds. */
  trip?: (seconds: number) => void;
  /** The token of this page is not valid any more. */
  revoked?: () => void;
  /** The link came up (true) or went down (false). */
  connected?: (up: boolean) => void;
}

const SILENCE = 1.5; // seconds without any message after which a link counts as dead
const PING_EVERY = 1.0;

/** The link of a page to the show: says hello, keeps the server's clock, and lets only the newest state through. */
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

  /** Says who this is: when the link opens, and again under another name. */
  introduce(): void {
    const { role, page, seat } = this;
    this.send({ type: "hello", role, version: PROTOCOL_VERSION, name: this.name(), page, seat });
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
    switch (message.type) {
      case "welcome":
        this.welcome(message);
        break;
      case "state":
        this.state(message);
        break;
      case "pong":
        this.pong(message);
        break;
      case "cast":
        this.recast(message.revision);
        break;
      default:
        this.pass(message);
    }
  }

  /** What is not of the link itself. */
  private pass(message: Exclude<FromServer, { type: "welcome" | "state" | "pong" | "cast" }>): void {
    switch (message.type) {
      case "plays_sound":
        this.handlers.playsSound?.(message.on);
        break;
      case "sources":
      case "source_values":
        this.hearSources(message);
        break;
      case "leases":
      case "lease_claim":
        this.handlers.leases?.(message);
        break;
      default:
        if (isOfDevices(message)) this.handlers.devices?.(message);
        else this.tell(message);
    }
  }

  private hearSources(message: Sources | SourceValues): void {
    if (message.type === "sources") this.handlers.sources?.(message.sources);
    else this.handlers.sourceValues?.(message);
  }

  /** What only the page itself has a use for. */
  private tell(
    message: Exclude<
      FromServer,
      | DeviceMessage
      | LeaseMessage
      | { type: "welcome" | "state" | "pong" | "cast" | "sources" | "plays_sound" | "source_values" }
    >,
  ): void {
    switch (message.type) {
      case "crew":
        this.handlers.crew?.(message);
        break;
      case "kept":
        this.handlers.kept?.(message);
        break;
      case "item_changed":
        this.handlers.itemChanged?.(message);
        break;
      case "layouts":
        this.handlers.layouts?.(message.names);
        break;
      case "hands":
        this.handlers.hands?.(message.hands);
        break;
      case "progress":
        this.handlers.progress?.(message);
        break;
      case "notices":
        this.handlers.notices?.(message.notices);
        break;
      case "refused":
        this.handlers.refused?.(message.reason, message.id, message.held);
        break;
    }
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
    if (!this.newest.accept(state)) return;
    if (state.epoch === this.epoch) this.recast(state.revision); // the message may have been lost
    this.clock.arrived(state.time, this.socket.heard);
    this.handlers.state?.(state);
  }
}
