/** The console's page: faces on the left, expressions on the right, what is on air between them, pads and faders below. */

import { html, nothing } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { showAccess } from "../access/access_banner";
import type { Library } from "../link/assets";
import { onFileDrop } from "../ui/file_import";
import { joinGltf } from "../ui/joined_gltf";
import { listenToKeys } from "../ui/key_presses";
import type { ShowNoticesView } from "../ui/show_notices_view";
import { base, palette } from "../ui/theme";
import { hearWhileShown, whileShown } from "../ui/topic_element";
import { endPass, ownPass, passesOf } from "./clips/clip_passes";
import { markMoment } from "./clips/keep_dialog";
import { style } from "./console_page_style";
import { ConsoleElement } from "./controls/console_element";
import type { LightRow } from "./controls/light_row";
import type { Pad } from "./controls/pad";
import { LOW, NARROW } from "./controls/screen_sizes";
import type { TBar } from "./controls/t_bar";
import type { Palette } from "./palette/palette";
import type { Monitor } from "./panels/monitor";
import { changeBus } from "./panels/preview_bar";
import type { StatusBar } from "./panels/status_bar";
import type { CharacterRow } from "./scene/character_row";
import type { MemoryRow } from "./scene/memory_row";
import { type ConsoleView, VIEWS } from "./store/arrangement";
import type { LookKind } from "./store/axis";
import { type Command, commandOf, isPanic, stepOf } from "./store/keys";
import type { Topic } from "./store/page_store";
import { nextPlace } from "./store/region_calls";
import { toggleStill } from "./store/stillness";
import { neighbour } from "./store/timing";
import "./scene/character_row";
import "./scene/memory_row";
import "./scene/head_frames";
import "./scene/scene_panel";
import "./mixer/layer_panel";
import "./mixer/unrouted_mark";
import "./leases/lease_dialog";
import "./leases/lease_marks";
import "./leases/seat_key";
import "./panels/bank";
import "./mixer/calibration_dialog";
import "./devices_dialog";
import "./help";
import "./learn/binding_marks";
import "./learn/learn_mode";
import type { TeachAsked } from "./mappings/mappings_panel";
import "./mappings/mapping_learning";
import "./message_log";
import "./setup";
import "./controls/light_row";
import "./panels/on_air_mix";
import "./panels/monitor";
import "./controls/pad";
import "./pads/pad_panel";
import "./palette/palette";
import "./panels/status_bar";
import type { MenuRequest } from "./palette/tile_menu";
import "./palette/tile_menu";
import "./controls/t_bar";

type Dialog = "devices" | "mappings" | "help" | "keep" | "leases" | "log" | "setup";

/** The instrument: faces on the left, expressions on the right, what is on air between them, hands and faders below. */
@customElement("omote-console")
export class ConsolePage extends ConsoleElement {
  /** The notices of the show, which have their place on the picture. */
  @property({ attribute: false }) notices!: ShowNoticesView;
  @state() private dialog: Dialog | null = null;
  /** The source whose calibration is open, "" for none. */
  @state() private calibrated = "";
  /** The own tile whose menu is open. */
  @state() private menu: MenuRequest | null = null;
  /** Its person may only look. */
  @state() private restricted = false;
  /** What is touched is bound, not played. */
  @state() private learning = false;
  /** The macro that is learned by touch, "" for none. */
  @state() private taught = "";
  @query("omote-monitor") private monitor!: Monitor;

  static override styles = [palette, base, style];

  protected override readonly topics: readonly Topic[] = ["link", "call", "arrangement", "characters"];

  constructor() {
    super();
    whileShown(this, () => listenToKeys({ everywhere: this.#keyEverywhere, page: this.#key }));
    whileShown(this, () =>
      onFileDrop(
        async (files) => this.context.imports.add(await joinGltf(files), "expression"),
        (sentence) => this.store.say(sentence),
      ),
    );
    hearWhileShown(this, IN_TURN, ["change"], () => this.requestUpdate());
  }

  /** Gives the monitor the cast to draw. */
  async open(library: Library): Promise<void> {
    await this.updateComplete;
    await this.monitor.open(library);
  }

  /** Lets hands off everything, where this page may only look; `sentence` says why. */
  restrict(sentence: string | null): void {
    showAccess(sentence);
    this.restricted = sentence !== null;
    this.classList.toggle("view-only", this.restricted);
  }

  override render() {
    this.classList.toggle("lost", !this.store.online);
    this.classList.toggle("preview", this.store.bus === "preview");
    this.classList.toggle("alone", this.store.arrangement.alone);
    this.classList.toggle("several", Object.keys(this.store.state?.characters ?? {}).length > 1);
    const context = this.context;
    const shown = this.#view;
    this.dataset.view = shown;
    return html`
      <omote-status
        .context=${context}
        .notices=${this.notices.notices}
        .restricted=${this.restricted}
        @help=${() => this.show("help")}
        @setup=${() => this.show("setup")}
        @log=${() => this.show("log")}
        @moments=${() => this.show("keep")}
        @learn=${this.#learn}
        @said=${this.#makeRoom}
        ><omote-seat slot="seat" .context=${context} @leases=${this.#openLeases}></omote-seat></omote-status
      >
      <omote-palette class="panel faces live" .context=${context} .axis=${"face"} @menu=${this.#openMenu}></omote-palette>
      <omote-tbar class="panel facebar live" .context=${context} .axis=${"face"}></omote-tbar>
      <section class="panel air" aria-label="On air and coming">
        <omote-monitor class="live picture" .context=${context}></omote-monitor>
        <omote-head-frames class="live picture" .context=${context} .boxes=${this.#heads}></omote-head-frames>
        <omote-characters class="live picture" .context=${context} @scene=${() => this.#toggle("scene")} @blend_pads=${() => this.#toggle("blend_pads")} @layers=${() => this.#toggle("layers")}></omote-characters>
        ${this.notices}
        <div class="mixes">
          <omote-mix class="live picture" .context=${context} .axis=${"face"}></omote-mix>
          <omote-mix class="live picture" .context=${context} .axis=${"expression"}></omote-mix>
        </div>
      </section>
      <div class="looks live">
        <omote-lights class="panel" .context=${context}></omote-lights>
        <omote-memories class="panel" .context=${context}></omote-memories>
      </div>
      <omote-tbar class="panel exprbar live" .context=${context} .axis=${this.#rightAxis()}></omote-tbar>
      <omote-palette class="panel expressions live" .context=${context} .axis=${"expression"} @menu=${this.#openMenu}></omote-palette>
      <section class="hands live" aria-label="Head and gaze">
        <omote-pad class="panel" .context=${context} .what=${"head"}></omote-pad>
        <omote-pad class="panel" .context=${context} .what=${"gaze"}></omote-pad>
      </section>
      <omote-bank class="panel live" .context=${context}></omote-bank>
      ${shown === "blend_pads" ? html`<omote-pad-panel class="panel live" .context=${context} @close=${() => this.#toggle("blend_pads")}></omote-pad-panel>` : nothing}
      ${shown === "scene" ? html`<omote-scene-panel class="panel live" .context=${context} @close=${() => this.#toggle("scene")}></omote-scene-panel>` : nothing}
      ${shown === "layers" ? html`<omote-layer-panel class="panel live" .context=${context} @calibrate=${this.#calibrate} @close=${() => this.#toggle("layers")}></omote-layer-panel>` : nothing}
      <nav class="views live" role="tablist" aria-label="What is shown below">
        ${VIEWS.map(
          (view) => html`<button role="tab" data-view=${view} aria-selected=${view === shown}
            @click=${() => this.store.arrange({ view })}>${VIEW_LABELS[view][0]}<span>${VIEW_LABELS[view][1]}</span>${view === "layers" ? html`<omote-unrouted-mark .context=${context}></omote-unrouted-mark>` : nothing}</button>`,
        )}
      </nav>
      ${this.#overlays()}
    `;
  }

  #overlays() {
    const { context, dialog, menu } = this;
    return html`
      <omote-lease-marks .context=${context} .page=${this.renderRoot}></omote-lease-marks>
      ${menu === null ? nothing : html`<omote-tile-menu .context=${context} .asked=${menu} @close=${this.#closeMenu}></omote-tile-menu>`}
      <omote-binding-marks .context=${context} .page=${this.renderRoot}></omote-binding-marks>
      ${this.learning ? html`<omote-learn-mode .context=${context} .page=${this.renderRoot} @close=${this.#learn} @devices=${this.#openDevices}></omote-learn-mode>` : nothing}
      ${this.taught === "" ? nothing : html`<omote-mapping-learning .context=${context} .name=${this.taught} @close=${this.#taught}></omote-mapping-learning>`}
      ${dialog === "devices" || dialog === "mappings" ? html`<omote-devices-dialog .context=${context} .view=${dialog} @close=${this.#close} @teach=${this.#teach}></omote-devices-dialog>` : nothing}
      ${this.calibrated === "" ? nothing : html`<omote-calibration-dialog .context=${context} .name=${this.calibrated} @close=${this.#close}></omote-calibration-dialog>`}
      ${dialog === "help" ? html`<omote-help .context=${context} @close=${this.#close}></omote-help>` : nothing}
      ${dialog === "keep" ? html`<omote-keep-dialog .context=${context} @close=${this.#close}></omote-keep-dialog>` : nothing}
      ${dialog === "leases" ? html`<omote-lease-dialog .context=${context} @close=${this.#close}></omote-lease-dialog>` : nothing}
      ${dialog === "log" ? html`<omote-message-log .context=${context} .notices=${this.notices.notices} @close=${this.#close}></omote-message-log>` : nothing}
      ${dialog === "setup" ? html`<omote-setup .context=${context} @close=${this.#close} @help=${() => this.show("help")} @devices=${() => this.show("devices")} @mappings=${() => this.show("mappings")} @learn=${this.#learn} @leases=${this.#openLeases} @moments=${() => this.show("keep")}></omote-setup>` : nothing}
    `;
  }

  /** On a phone one thing at a time has room; elsewhere the palettes always have their place. */
  get #view(): ConsoleView {
    const { view } = this.store.arrangement;
    return IN_TURN.matches || view !== "palettes" ? view : "faders";
  }

  /** Words that a phone's bar has no room for stand above the picture, which is as much lower. */
  readonly #makeRoom = ({ detail }: CustomEvent<number>): void => {
    this.style.setProperty("--said", `${detail}px`);
    this.classList.toggle("says", detail > 0);
  };

  readonly #heads = (): Monitor["heads"] => this.monitor.heads;

  /** What is shown below while none of scene, layers and pads of looks is. */
  #below: ConsoleView = "palettes";
  #axis: LookKind = "expression";

  /** Opens scene, layers or pads of looks in the place of what is below, and closes them. */
  #toggle(wanted: (typeof IN_PLACE)[number]): void {
    const { view } = this.store.arrangement;
    if (!IN_PLACE.some((other) => other === view)) this.#below = view;
    this.store.arrange({ view: view === wanted ? this.#below : wanted });
  }

  /** Opens a dialog. */
  show(dialog: Dialog): void {
    this.dialog = dialog;
  }

  /** Begins to learn, or ends it. */
  readonly #learn = (): void => {
    this.learning = !this.learning && this.taught === "";
    this.dialog = null;
  };

  readonly #teach = ({ detail }: TeachAsked): void => {
    [this.taught, this.dialog] = [detail.name, null];
  };

  /** Learned or not: back to the macros. */
  readonly #taught = (): void => {
    this.taught = "";
    this.show("mappings");
  };

  readonly #openDevices = (): void => {
    this.learning = false;
    this.show("devices");
  };

  readonly #openMenu = (event: CustomEvent<MenuRequest>): void => {
    this.menu = event.detail;
  };

  readonly #closeMenu = (): void => {
    this.menu = null;
  };

  readonly #calibrate = (event: CustomEvent<string>): void => {
    this.calibrated = event.detail;
  };

  readonly #openLeases = (): void => this.show("leases");

  readonly #close = (): void => {
    this.dialog = null;
    this.calibrated = "";
  };

  /** Panic: also over what is open, but not in a field. */
  readonly #keyEverywhere = (event: KeyboardEvent): boolean => {
    if (isPanic(event) && !event.repeat) this.store.panic(event.ctrlKey); // held down it is one press
    return isPanic(event);
  };

  readonly #key = (event: KeyboardEvent, typing: boolean): void => {
    const step = typing ? null : stepOf(event);
    if (step !== null) {
      event.preventDefault();
      if (!event.repeat) this.store[step]();
      return;
    }
    const command = commandOf(event, typing);
    if (command === null) return;
    event.preventDefault();
    this.#obey(command);
  };

  #obey(command: Command): void {
    if (command.do === "help") this.show("help");
    else if (command.do === "learn") this.#learn();
    else if (command.do === "moments") this.show("keep");
    else if (command.do === "mark") markMoment(this.store, "");
    else if (command.do === "centre") this.store.centre();
    else if (command.do === "clear") this.store.clearChannels(Object.keys(this.store.air?.channels ?? {}));
    else if (command.do === "leases") this.show("leases");
    else if (command.do === "memory") this.#at<MemoryRow>("omote-memories")?.press(command.name);
    else if (command.do === "keep_memory") this.#at<MemoryRow>("omote-memories")?.keep();
    else if (command.do === "still") toggleStill(this.store);
    else if (command.do === "go") this.#at<StatusBar>("omote-status")?.go();
    else if (command.do === "black") this.store.callBlack(command.seconds);
    else if (command.do === "take_over") this.context.leases.takeOverWanted();
    else if (command.do === "bus") changeBus(this.store);
    else if (command.do === "scene" || command.do === "layers" || command.do === "blend_pads") this.#toggle(command.do);
    else if (command.do === "region") this.store.chooseRegion(nextPlace(this.store.region, command.direction));
    else if (command.do === "focus" && command.place === "characters" && this.#keepPass()) return;
    else if (command.do === "focus")
      this.#at<CharacterRow | LightRow | Palette | Pad | TBar>(PLACES[command.place])?.focus();
    else this.#obeyAxis(command);
  }

  /** What the right T-bar and its keys move: poses while their tiles are shown; a hand that is on it keeps what it has. */
  #rightAxis(): LookKind {
    if (!this.store.bar(this.#axis).touched())
      this.#axis = this.store.arrangement.kind === "poses" ? "pose" : "expression";
    return this.#axis;
  }

  #obeyAxis(command: Extract<Command, { axis: unknown }>): void {
    const { axis } = command;
    const timing = this.store.timing[axis];
    if (command.do === "call") this.#at<Palette>(axis === "face" ? ".faces" : ".expressions")?.callIndex(command.index);
    else if (command.do === "release") this.store.release(axis === "face" ? axis : this.#rightAxis());
    else if (command.do === "keep") this.context.items.keep(axis);
    else if (command.do === "hand") this.store.setTiming(axis, { byHand: !timing.byHand });
    else this.store.setTiming(axis, { seconds: neighbour(timing, command.direction) });
  }

  /** Keeps the pass that this hand records, where there is one; says whether. */
  #keepPass(): boolean {
    const pass = ownPass(passesOf(this.store), this.store.name, this.store.played.names);
    if (pass !== undefined) endPass(this.store, pass, true);
    return pass !== undefined;
  }

  #at<Found extends Element>(selector: string): Found | null {
    return this.renderRoot.querySelector<Found>(selector);
  }
}

/** What stands in the place of what is below. */
const IN_PLACE = ["scene", "layers", "blend_pads"] as const;
/** Where palettes, faders and pads take turns. */
const IN_TURN = matchMedia(`${NARROW} or ${LOW}`);

const PLACES = {
  face: ".facebar",
  expression: ".exprbar",
  head: ".hands omote-pad",
  gaze: ".hands omote-pad + omote-pad",
  search: ".expressions",
  light: "omote-lights",
  characters: "omote-characters",
} as const;

/** What a button reads, and what it adds where there is room. */
const VIEW_LABELS: Readonly<Record<ConsoleView, readonly [string, string]>> = {
  palettes: ["Faces", ", expressions"],
  faders: ["Faders", ""],
  pads: ["Head", ", gaze"],
  blend_pads: ["Pads", ""],
  scene: ["Scene", ""],
  layers: ["Layers", ""],
};
