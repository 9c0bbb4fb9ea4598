/** The console's page: faces on the left, expressions on the right, what is on air between them, pads and faders below. */

import { html, nothing } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import type { Library } from "../link/assets";
import { base, palette } from "../ui/theme";
import { style } from "./console_page_style";
import { ConsoleElement } from "./controls/console_element";
import type { LightRow } from "./controls/light_row";
import type { Pad } from "./controls/pad";
import type { TBar } from "./controls/t_bar";
import type { Monitor } from "./panels/monitor";
import type { Palette } from "./panels/palette";
import type { Topic } from "./store/console_store";
import { type Command, commandOf } from "./store/keys";
import { neighbour } from "./store/timing";
import "./panels/bank";
import "./help";
import "./controls/light_row";
import "./panels/on_air_mix";
import "./panels/monitor";
import "./controls/pad";
import "./panels/palette";
import "./panels/status_bar";
import "./controls/t_bar";

/** The instrument: faces on the left, expressions on the right, what is on air between them, hands and faders below. */
@customElement("omote-console")
export class ConsolePage extends ConsoleElement {
  @state() private helping = false;
  @query("omote-monitor") private monitor!: Monitor;

  static override styles = [palette, base, style];

  protected override topics(): readonly Topic[] {
    return ["link", "call"];
  }

  override connectedCallback(): void {
    super.connectedCallback();
    window.addEventListener("keydown", this.#key);
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    window.removeEventListener("keydown", this.#key);
  }

  /** Gives the monitor the cast to draw. */
  async open(library: Library): Promise<void> {
    await this.updateComplete;
    await this.monitor.open(library);
  }

  override render() {
    this.classList.toggle("lost", !this.store.online);
    const context = this.context;
    return html`
      <omote-status
        .context=${context}
        @help=${() => {
          this.helping = true;
        }}
      ></omote-status>
      <omote-palette class="panel faces live" .context=${context} .axis=${"face"}></omote-palette>
      <omote-tbar class="panel facebar live" .context=${context} .axis=${"face"}></omote-tbar>
      <section class="panel air live" aria-label="On air and coming">
        <omote-monitor .context=${context}></omote-monitor>
        <div class="mixes">
          <omote-mix .context=${context} .axis=${"face"}></omote-mix>
          <omote-mix .context=${context} .axis=${"expression"}></omote-mix>
        </div>
        <omote-lights .context=${context}></omote-lights>
      </section>
      <omote-tbar class="panel exprbar live" .context=${context} .axis=${"expression"}></omote-tbar>
      <omote-palette class="panel expressions live" .context=${context} .axis=${"expression"}></omote-palette>
      <section class="hands live" aria-label="Head and gaze">
        <omote-pad class="panel" .context=${context} .what=${"head"}></omote-pad>
        <omote-pad class="panel" .context=${context} .what=${"gaze"}></omote-pad>
      </section>
      <omote-bank class="panel live" .context=${context}></omote-bank>
      ${this.helping ? html`<omote-help .context=${context} @close=${this.#closeHelp}></omote-help>` : nothing}
    `;
  }

  readonly #closeHelp = (): void => {
    this.helping = false;
  };

  readonly #key = (event: KeyboardEvent): void => {
    const command = commandOf(event, isTyping(event));
    if (command === null) return;
    event.preventDefault();
    this.#obey(command);
  };

  #obey(command: Command): void {
    if (command.do === "panic") {
      this.helping = false;
      this.store.panic();
    } else if (command.do === "help") this.helping = !this.helping;
    else if (command.do === "centre") this.store.centre();
    else if (command.do === "clear") this.store.clearChannels(Object.keys(this.store.state?.channels ?? {}));
    else if (command.do === "focus") this.#at<LightRow | Palette | Pad | TBar>(PLACES[command.place])?.focus();
    else this.#obeyAxis(command);
  }

  #obeyAxis(command: Extract<Command, { axis: unknown }>): void {
    const { axis } = command;
    const { seconds } = this.store.timing[axis];
    if (command.do === "call") this.#at<Palette>(axis === "face" ? ".faces" : ".expressions")?.callIndex(command.index);
    else if (command.do === "release") this.store.release(axis);
    else if (command.do === "keep") this.store.keep(axis);
    else if (command.do === "hand") this.store.setTiming(axis, { seconds: seconds === null ? 1 : null });
    else this.store.setTiming(axis, { seconds: neighbour(seconds, command.direction) });
  }

  #at<Found extends Element>(selector: string): Found | null {
    return this.renderRoot.querySelector<Found>(selector);
  }
}

const PLACES = {
  face: ".facebar",
  expression: ".exprbar",
  head: ".hands omote-pad",
  gaze: ".hands omote-pad + omote-pad",
  search: ".expressions",
  light: "omote-lights",
} as const;

/** True while a key press belongs to a field for text. */
function isTyping(event: KeyboardEvent): boolean {
  return event
    .composedPath()
    .some((target) => target instanceof HTMLInputElement || target instanceof HTMLTextAreaElement);
}
