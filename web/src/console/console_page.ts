/** The console's page: faces on the left, expressions on the right, what is on air between them, pads and faders below. */

import { html, nothing } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import type { Library } from "../link/assets";
import { onFileDrop } from "../ui/file_import";
import { listenToKeys } from "../ui/key_presses";
import type { ShowNoticesView } from "../ui/show_notices_view";
import { base, palette } from "../ui/theme";
import { style } from "./console_page_style";
import { ConsoleElement } from "./controls/console_element";
import type { LightRow } from "./controls/light_row";
import type { Pad } from "./controls/pad";
import { LOW, NARROW } from "./controls/screen_sizes";
import type { TBar } from "./controls/t_bar";
import type { Palette } from "./palette/palette";
import type { Monitor } from "./panels/monitor";
import { VIEWS, type View } from "./store/console_layout";
import { type Command, commandOf, isPanic } from "./store/keys";
import type { Topic } from "./store/page_store";
import { neighbour } from "./store/timing";
import "./panels/bank";
import "./help";
import "./message_log";
import "./setup";
import "./controls/light_row";
import "./panels/on_air_mix";
import "./panels/monitor";
import "./controls/pad";
import "./palette/palette";
import "./panels/status_bar";
import type { MenuRequest } from "./palette/tile_menu";
import "./palette/tile_menu";
import "./controls/t_bar";

type Dialog = "help" | "log" | "setup";

/** The instrument: faces on the left, expressions on the right, what is on air between them, hands and faders below. */
@customElement("omote-console")
export class ConsolePage extends ConsoleElement {
  /** The notices of the show, which have their place in the bar. */
  @property({ attribute: false }) notices!: ShowNoticesView;
  @state() private dialog: Dialog | null = null;
  /** The own tile whose menu is open. */
  @state() private menu: MenuRequest | null = null;
  #deaf: () => void = () => undefined;
  #closed: () => void = () => undefined;
  @query("omote-monitor") private monitor!: Monitor;

  static override styles = [palette, base, style];

  protected override topics(): readonly Topic[] {
    return ["link", "call", "layout"];
  }

  override connectedCallback(): void {
    super.connectedCallback();
    this.#deaf = listenToKeys({ everywhere: this.#panicKey, page: this.#key });
    this.#closed = onFileDrop((files) => void this.context.imports.add(files, "expression"));
    IN_TURN.addEventListener("change", this.#resized);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#deaf();
    this.#closed();
    IN_TURN.removeEventListener("change", this.#resized);
  }

  /** Gives the monitor the cast to draw. */
  async open(library: Library): Promise<void> {
    await this.updateComplete;
    await this.monitor.open(library);
  }

  override render() {
    this.classList.toggle("lost", !this.store.online);
    const context = this.context;
    const shown = this.#view;
    this.dataset.view = shown;
    return html`
      <omote-status
        .context=${context}
        .notices=${this.notices.notices}
        @help=${() => this.show("help")}
        @setup=${() => this.show("setup")}
        @log=${() => this.show("log")}
        >${this.notices}</omote-status
      >
      <omote-palette class="panel faces live" .context=${context} .axis=${"face"} @menu=${this.#openMenu}></omote-palette>
      <omote-tbar class="panel facebar live" .context=${context} .axis=${"face"}></omote-tbar>
      <section class="panel air live" aria-label="On air and coming">
        <omote-monitor .context=${context}></omote-monitor>
        <div class="mixes">
          <omote-mix .context=${context} .axis=${"face"}></omote-mix>
          <omote-mix .context=${context} .axis=${"expression"}></omote-mix>
        </div>
      </section>
      <omote-lights class="panel live" .context=${context}></omote-lights>
      <omote-tbar class="panel exprbar live" .context=${context} .axis=${"expression"}></omote-tbar>
      <omote-palette class="panel expressions live" .context=${context} .axis=${"expression"} @menu=${this.#openMenu}></omote-palette>
      <section class="hands live" aria-label="Head and gaze">
        <omote-pad class="panel" .context=${context} .what=${"head"}></omote-pad>
        <omote-pad class="panel" .context=${context} .what=${"gaze"}></omote-pad>
      </section>
      <omote-bank class="panel live" .context=${context}></omote-bank>
      <nav class="views live" role="tablist" aria-label="What is shown below">
        ${VIEWS.map(
          (view) => html`<button role="tab" data-view=${view} aria-selected=${view === shown}
            @click=${() => this.store.arrange({ view })}>${VIEW_LABELS[view][0]}<span>${VIEW_LABELS[view][1]}</span></button>`,
        )}
      </nav>
      ${this.#overlays()}
    `;
  }

  #overlays() {
    const { context, dialog, menu } = this;
    return html`
      ${menu === null ? nothing : html`<omote-tile-menu .items=${context.items} .asked=${menu} @close=${this.#closeMenu}></omote-tile-menu>`}
      ${dialog === "help" ? html`<omote-help .context=${context} @close=${this.#close}></omote-help>` : nothing}
      ${dialog === "log" ? html`<omote-message-log .context=${context} .notices=${this.notices.notices} @close=${this.#close}></omote-message-log>` : nothing}
      ${dialog === "setup" ? html`<omote-setup .context=${context} @close=${this.#close} @help=${() => this.show("help")}></omote-setup>` : nothing}
    `;
  }

  /** On a phone one thing at a time has room; elsewhere the palettes always have their place. */
  get #view(): View {
    const { view } = this.store.layout;
    return IN_TURN.matches || view !== "palettes" ? view : "faders";
  }

  readonly #resized = (): void => this.requestUpdate();

  /** Opens a dialog. */
  show(dialog: Dialog): void {
    this.dialog = dialog;
  }

  readonly #openMenu = (event: CustomEvent<MenuRequest>): void => {
    this.menu = event.detail;
  };

  readonly #closeMenu = (): void => {
    this.menu = null;
  };

  readonly #close = (): void => {
    this.dialog = null;
  };

  readonly #panicKey = (event: KeyboardEvent): boolean => {
    if (!isPanic(event)) return false;
    if (!event.repeat) this.store.panic(); // held down it is one press
    return true;
  };

  readonly #key = (event: KeyboardEvent, typing: boolean): void => {
    const command = commandOf(event, typing);
    if (command === null) return;
    event.preventDefault();
    this.#obey(command);
  };

  #obey(command: Command): void {
    if (command.do === "help") this.show("help");
    else if (command.do === "centre") this.store.centre();
    else if (command.do === "clear") this.store.clearChannels(Object.keys(this.store.state?.channels ?? {}));
    else if (command.do === "undo") this.store.undo();
    else if (command.do === "redo") this.store.redo();
    else if (command.do === "focus") this.#at<LightRow | Palette | Pad | TBar>(PLACES[command.place])?.focus();
    else this.#obeyAxis(command);
  }

  #obeyAxis(command: Extract<Command, { axis: unknown }>): void {
    const { axis } = command;
    const timing = this.store.timing[axis];
    if (command.do === "call") this.#at<Palette>(axis === "face" ? ".faces" : ".expressions")?.callIndex(command.index);
    else if (command.do === "release") this.store.release(axis);
    else if (command.do === "keep") this.context.items.keep(axis);
    else if (command.do === "hand") this.store.setTiming(axis, { byHand: !timing.byHand });
    else this.store.setTiming(axis, { seconds: neighbour(timing, command.direction) });
  }

  #at<Found extends Element>(selector: string): Found | null {
    return this.renderRoot.querySelector<Found>(selector);
  }
}

/** Where palettes, faders and pads take turns. */
const IN_TURN = matchMedia(`${NARROW} or ${LOW}`);

const PLACES = {
  face: ".facebar",
  expression: ".exprbar",
  head: ".hands omote-pad",
  gaze: ".hands omote-pad + omote-pad",
  search: ".expressions",
  light: "omote-lights",
} as const;

/** What a button reads, and what it adds where there is room. */
const VIEW_LABELS: Readonly<Record<View, readonly [string, string]>> = {
  palettes: ["Faces", ", expressions"],
  faders: ["Faders", ""],
  pads: ["Head", ", gaze"],
};
