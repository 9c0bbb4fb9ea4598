/** What the show says of devices and bindings, and what a page asks of them. */

import type {
  BindingDocument,
  BindingList,
  BindingsChanged,
  DeviceState,
  Devices,
  FoundTracker,
  FromClient,
  InputLine,
  InputLog,
  LearningState,
  PresetDocument,
  ReceiverState,
  SendWay,
  TrackerOffer,
} from "../../link/messages";
import { TopicStore } from "../../link/topics";
import type { Axis } from "../store/axis";
import type { Change, Step } from "../store/undo_history";
import { type Target, targetLabel } from "./binding_target";

export type DeviceNews = Devices | BindingList | BindingsChanged | InputLog;

/** What the store of the page does for this one. */
export interface DeviceHost {
  readonly online: boolean;
  /** What people read of a name of the cast. */
  label(axis: Axis, name: string): string;
  /** Tells when the link comes up or is lost. */
  listen(topic: "link", heard: () => void): () => void;
  say(notice: string, tone?: "attention" | "done"): void;
  offerUndo(done: string, step: Step): void;
}

/** A change of the bindings that has no answer yet: what is said once it has, "" where the answer says it. */
interface Asked {
  readonly done: string;
}

const NOT_SENT = "Not sent: the link to the show is lost.";

export class DeviceStore extends TopicStore<"devices" | "bindings" | "log"> {
  devices: readonly DeviceState[] = [];
  /** Trackers that can be heard, programs that have announced themselves, and to whom faces are sent, in which ways. */
  trackers: readonly TrackerOffer[] = [];
  found: readonly FoundTracker[] = [];
  receivers: readonly ReceiverState[] = [];
  ways: readonly SendWay[] = [];
  /** The page that a phone opens to copy what to type; "" where no phone opens a page of this show. */
  phonePage = "";
  /** The address of the show's machine in its network, "" where it is in none. */
  machine = "";
  bindings: readonly BindingDocument[] = [];
  /** Those of the bindings that a file has made. */
  fixed: readonly BindingDocument[] = [];
  presets: readonly PresetDocument[] = [];
  learning: LearningState | null = null;
  lines: readonly InputLine[] = [];
  #missing: ReadonlyMap<BindingDocument, string> = new Map();
  readonly #asked = new Map<string, Asked>();
  #count = 0;
  #watched = false;

  /** `send` takes a message to the show; `id` names this page. */
  constructor(
    private readonly host: DeviceHost,
    private readonly send: (message: FromClient) => void,
    private readonly id: string,
  ) {
    super();
  }

  receive(news: DeviceNews): void {
    if (news.type === "devices") {
      ({ devices: this.devices, trackers: this.trackers, found: this.found } = news);
      ({ receivers: this.receivers, ways: this.ways, phone_page: this.phonePage, host: this.machine } = news);
      this.tell("devices");
    } else if (news.type === "input_log") {
      this.lines = news.lines;
      this.tell("log");
    } else if (news.type === "binding_list") {
      const { bindings, missing } = news;
      this.#missing = new Map(bindings.map((one, at) => [one, missing[at] ?? ""]));
      ({ bindings: this.bindings, fixed: this.fixed, presets: this.presets, learning: this.learning } = news);
      this.tell("bindings");
    } else this.#receiveChange(news);
  }

  /** Why a binding waits: it names a face, an expression or a character that is not there; "" where all is. */
  whyMissing(binding: BindingDocument): string {
    return this.#missing.get(binding) ?? "";
  }

  /** A device came on which nothing was bound, and its preset with it: taken back at the page that has the device. */
  #receivePreset({ added, removed, preset, here }: BindingsChanged): void {
    const device = added[0]?.device ?? "";
    const done = `${device} plays as ${preset}, the preset that is made for it.`;
    if (here) this.host.offerUndo(done, stepOf(`the preset of ${device}`, added, removed));
    else this.host.say(done, "done");
  }

  /** What this page asked for is done, or what the show did by itself. */
  #receiveChange(change: BindingsChanged): void {
    if (change.preset !== "") {
      this.#receivePreset(change);
      return;
    }
    const { id, added, removed } = change;
    const asked = this.#asked.get(id);
    if (asked === undefined) return;
    this.#asked.delete(id);
    if (added.length + removed.length === 0) return;
    const first = added[0] ?? (removed[0] as BindingDocument);
    const done = asked.done || this.#told(first);
    this.host.offerUndo(done, stepOf(done.replace(/\.$/, ""), added, removed));
  }

  #told(binding: BindingDocument): string {
    return `Bound: ${binding.device} ${binding.control} plays ${targetLabel(binding, this.host)}.`;
  }

  /** A message was rejected; whether it was one from here. */
  receiveRefused(reason: string, id: string): boolean {
    if (!this.#asked.delete(id)) return false;
    this.host.say(reason);
    return true;
  }

  /** The link came up or was lost: what this page shows of devices has to be asked for again. */
  setOnline(online: boolean): void {
    this.#asked.clear();
    if (!online) {
      [this.devices, this.learning, this.lines] = [[], null, []];
      [this.trackers, this.found, this.receivers] = [[], [], []];
    } else if (this.#watched) this.send({ type: "watch_devices", on: true });
    for (const topic of ["devices", "bindings", "log"] as const) this.tell(topic);
  }

  /** This page shows devices from now on, or no more. */
  watch(on: boolean): void {
    this.#watched = on;
    if (this.host.online) this.send({ type: "watch_devices", on });
  }

  /** The newest state of a device, null where the show has never heard of it. */
  device(name: string): DeviceState | null {
    return this.devices.find((one) => one.name === name) ?? null;
  }

  isFixed(binding: BindingDocument): boolean {
    const text = JSON.stringify(binding);
    return this.fixed.some((one) => JSON.stringify(one) === text);
  }

  /** Binds the next control that moves to a target, in a bank. */
  learn(target: Target, bank = ""): void {
    this.#ask({ type: "learn", id: "", bank, ...target }, "");
  }

  /** Stops to learn. */
  stopLearning(): void {
    if (this.learning !== null && this.host.online)
      this.#ask({ type: "learn", id: "", to: "", axis: "", arguments: [], bank: "" }, "");
  }

  bind(binding: BindingDocument, replaces: BindingDocument | null = null): void {
    this.#ask({ type: "bind", id: "", binding, replaces }, this.#told(binding));
  }

  unbind(binding: BindingDocument): void {
    this.#ask(
      { type: "unbind", id: "", binding },
      `Deleted: ${binding.device} ${binding.control} plays ${targetLabel(binding, this.host)}.`,
    );
  }

  loadPreset(device: string, preset: PresetDocument, character: string): void {
    const done = `${device} plays as ${preset.label}.`;
    this.#ask({ type: "load_preset", id: "", device, preset: preset.name, character }, done);
  }

  /** Switches a tracker that is heard (`listen`) or a receiver of faces (`send`) on or off, by its word. */
  switchDevice(direction: "listen" | "send", word: string, on: boolean): void {
    this.#ask({ type: "switch_device", id: "", direction, word, on }, "");
  }

  chooseBank(device: string, bank: string): void {
    if (this.#mayAct()) this.send({ type: "choose_bank", device, bank });
  }

  #ask(message: Extract<FromClient, { id: string }>, done: string): void {
    if (!this.#mayAct()) return;
    this.#count += 1;
    const id = `${this.id}-device-${this.#count}`;
    this.#asked.set(id, { done });
    this.send({ ...message, id });
  }

  #mayAct(): boolean {
    if (!this.host.online) this.host.say(NOT_SENT);
    return this.host.online;
  }
}

/** What takes a change of bindings back, and does it again. */
export function stepOf(what: string, added: readonly BindingDocument[], removed: readonly BindingDocument[]): Step {
  return { what, undo: changesOf(removed, added), redo: changesOf(added, removed) };
}

/** Bindings that come, and others that go: as one where one takes the place of the other. */
function changesOf(come: readonly BindingDocument[], go: readonly BindingDocument[]): Change[] {
  const [first, last] = [come[0], go[0]];
  if (come.length === 1 && go.length === 1 && first !== undefined && last !== undefined)
    return [{ type: "bind", binding: first, replaces: last }];
  return [
    ...go.map((binding): Change => ({ type: "unbind", binding })),
    ...come.map((binding): Change => ({ type: "bind", binding, replaces: null })),
  ];
}
