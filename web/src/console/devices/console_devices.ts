/** Devices on a page: what the show says of them and of bindings, what a page asks of them, and those at this browser. */

import type {
  BindingDocument,
  BindingsChanged,
  DeviceState,
  FoundTracker,
  FromClient,
  InputLine,
  LearningState,
  PresetDocument,
  ReceiverState,
  SendWay,
  TrackerOffer,
} from "../../link/messages";
import type { FramePainter } from "../../ui/frame_painter";
import type { ConsoleStore } from "../store/console_store";
import type { Asked } from "../store/requests";
import type { Change, Step } from "../store/undo_history";
import { type Target, targetLabel } from "./binding_target";
import { type Browser, BrowserDevices, thisBrowser } from "./browser_devices";

declare module "../controls/console_element" {
  interface ConsoleContext {
    readonly devices: ConsoleDevices;
  }
}

export class ConsoleDevices {
  readonly browser: BrowserDevices;
  #watched = false;
  #plugged: ReadonlySet<string> = new Set();
  /** Those that were unplugged since, and have been said. */
  readonly #gone = new Set<string>();

  /** `send` takes a message to the show at once. */
  constructor(
    private readonly store: ConsoleStore,
    private readonly send: (message: FromClient) => void,
    browser: Browser = thisBrowser(),
  ) {
    this.browser = new BrowserDevices(browser, store, send);
    store.hear("device_bytes", ({ device, data, cue }) => this.browser.receiveBytes(device, data, cue));
    store.hear("bindings_changed", (change) => change.preset !== "" && this.#receivePreset(change));
    store.hear("devices", ({ devices }) => {
      if (store.online) this.browser.receive(devices);
      this.#notePlugs(devices);
    });
    store.listen("link", () => this.#relink());
  }

  /** Hears what this browser has, each frame of the page. */
  start(painter: FramePainter): void {
    painter.add({ paint: () => this.browser.look() });
    document.addEventListener("visibilitychange", () => this.browser.hide(document.hidden));
    void this.browser.start();
  }

  get devices(): readonly DeviceState[] {
    return this.store.newest("devices")?.devices ?? [];
  }

  /** Trackers that can be heard, programs that have announced themselves, and to whom faces are sent, in which ways. */
  get trackers(): readonly TrackerOffer[] {
    return this.store.newest("devices")?.trackers ?? [];
  }

  get foundTrackers(): readonly FoundTracker[] {
    return this.store.newest("devices")?.found ?? [];
  }

  get receivers(): readonly ReceiverState[] {
    return this.store.newest("devices")?.receivers ?? [];
  }

  get ways(): readonly SendWay[] {
    return this.store.newest("devices")?.ways ?? [];
  }

  /** The page that a phone opens to copy what to type; "" where no phone opens a page of this show. */
  get phonePage(): string {
    return this.store.newest("devices")?.phone_page ?? "";
  }

  /** The address of the show's machine in its network, "" where it is in none. */
  get machine(): string {
    return this.store.newest("devices")?.host ?? "";
  }

  get bindings(): readonly BindingDocument[] {
    return this.store.newest("binding_list")?.bindings ?? [];
  }

  get presets(): readonly PresetDocument[] {
    return this.store.newest("binding_list")?.presets ?? [];
  }

  get learning(): LearningState | null {
    return this.store.online ? (this.store.newest("binding_list")?.learning ?? null) : null;
  }

  get lines(): readonly InputLine[] {
    return this.store.newest("input_log")?.lines ?? [];
  }

  /** Why a binding waits: it names a face, an expression or a character that is not there; "" where all is. */
  whyMissing(binding: BindingDocument): string {
    return this.store.newest("binding_list")?.missing[this.bindings.indexOf(binding)] ?? "";
  }

  /** Says which devices that play something have gone, and which of those are back. */
  #notePlugs(devices: readonly DeviceState[]): void {
    for (const { name, plugged } of devices) {
      const plays = this.bindings.some(({ device }) => device === name);
      if (plugged && this.#gone.delete(name) && plays) this.store.say(`${name} is plugged in again.`, "done");
      else if (!plugged && this.#plugged.has(name) && plays) {
        this.#gone.add(name);
        this.store.say(`${name} is unplugged: what it played stays as it is.`);
      }
    }
    this.#plugged = new Set(devices.filter(({ plugged }) => plugged).map(({ name }) => name));
  }

  /** A device came on which nothing was bound, and its preset with it: taken back at the page that has the device. */
  #receivePreset({ added, removed, preset, here }: BindingsChanged): void {
    const device = added[0]?.device ?? "";
    const done = `${device} plays as ${preset}, the preset that is made for it.`;
    if (here) this.store.offerUndo(done, stepOf(`the preset of ${device}`, added, removed));
    else this.store.say(done, "done");
  }

  /** What this page asked for is done; `done`: what is said, "" where the answer says it. */
  #receiveChange({ added, removed, preset }: BindingsChanged, done: string): void {
    const first = added[0] ?? removed[0];
    if (first === undefined || preset !== "") return;
    const said = done || this.#sentence(first);
    this.store.offerUndo(said, stepOf(said.replace(/\.$/, ""), added, removed));
  }

  #sentence(binding: BindingDocument): string {
    return `Bound: ${binding.device} ${binding.control} plays ${targetLabel(binding, this.store)}.`;
  }

  /** The link came up or was lost: what this page shows of devices has to be asked for again. */
  #relink(): void {
    const { store } = this;
    this.browser.setOnline(store.online);
    const lastDevices = store.newest("devices");
    if (store.online && this.#watched) this.send({ type: "watch_devices", on: true });
    if (store.online || lastDevices === null) return;
    store.receive({ ...lastDevices, devices: [], trackers: [], found: [], receivers: [] });
    store.receive({ type: "input_log", lines: [] });
    store.tell("binding_list");
  }

  /** This page shows devices from now on, or no more. */
  watch(on: boolean): void {
    this.#watched = on;
    if (this.store.online) this.send({ type: "watch_devices", on });
  }

  /** The newest state of a device, null where the show has never heard of it. */
  device(name: string): DeviceState | null {
    return this.devices.find((device) => device.name === name) ?? null;
  }

  isFixed(binding: BindingDocument): boolean {
    const text = JSON.stringify(binding);
    return (this.store.newest("binding_list")?.fixed ?? []).some((fixed) => JSON.stringify(fixed) === text);
  }

  /** Binds the next control that moves to a target, in a bank. */
  learn(target: Target, bank = ""): void {
    this.#ask({ type: "learn", bank, ...target }, "");
  }

  /** Stops to learn. */
  stopLearning(): void {
    if (this.learning !== null && this.store.online) this.#ask({ type: "learn", to: "" }, "");
  }

  bind(binding: BindingDocument, replaces: BindingDocument | null = null): void {
    this.#ask({ type: "bind", binding, replaces }, this.#sentence(binding));
  }

  unbind(binding: BindingDocument): void {
    this.#ask(
      { type: "unbind", binding },
      `Deleted: ${binding.device} ${binding.control} plays ${targetLabel(binding, this.store)}.`,
    );
  }

  loadPreset(device: string, preset: PresetDocument, character: string): void {
    const done = `${device} plays as ${preset.label}.`;
    this.#ask({ type: "load_preset", device, preset: preset.name, character }, done);
  }

  /** Switches a tracker that is heard (`listen`) or a receiver of faces (`send`) on or off, by its word. */
  switchDevice(direction: "listen" | "send", word: string, on: boolean): void {
    this.#ask({ type: "switch_device", direction, word, on }, "");
  }

  chooseBank(device: string, bank: string): void {
    this.store.push({ type: "choose_bank", device, bank });
  }

  #ask(asked: Asked, done: string): void {
    this.store.ask(asked, { bindings_changed: (change) => this.#receiveChange(change, done) });
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
    ...come.map((binding): Change => ({ type: "bind", binding })),
  ];
}
