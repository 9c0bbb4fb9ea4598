import { css, html, nothing } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import type { Library } from "../link/assets";
import type { Topic } from "./desk";
import { RigElement } from "./element";
import { type Command, commandOf } from "./keys";
import type { Monitor } from "./monitor";
import type { Pad } from "./pad";
import type { Palette } from "./palette";
import type { TBar } from "./t_bar";
import { base, palette } from "./theme";
import { neighbour } from "./timing";
import "./bank";
import "./help";
import "./mix";
import "./monitor";
import "./pad";
import "./palette";
import "./status_bar";
import "./t_bar";

/** The instrument: faces on the left, expressions on the right, what is on air between them, hands and faders below. */
@customElement("omote-console")
export class ConsolePage extends RigElement {
  @state() private helping = false;
  @query("omote-monitor") private monitor!: Monitor;

  static override styles = [
    palette,
    base,
    css`
      :host {
        height: 100dvh;
        background: var(--ground);
        display: grid;
        gap: 6px;
        padding: 6px;
        grid-template:
          "status status status status status" 50px
          "faces facebar air exprbar expressions" minmax(0, 1fr)
          "hands hands bank bank bank" minmax(220px, 31%) /
          minmax(228px, 0.8fr) 88px minmax(300px, 1.1fr) 88px minmax(330px, 1.15fr);
        overflow: hidden;
      }
      omote-status {
        grid-area: status;
      }
      .faces {
        grid-area: faces;
      }
      .facebar {
        grid-area: facebar;
      }
      .air {
        grid-area: air;
        display: grid;
        grid-template-rows: minmax(0, 1fr) auto;
        overflow: hidden;
      }
      .mixes {
        display: grid;
        grid-template-columns: repeat(2, minmax(0, 1fr));
        border-top: 1px solid var(--line);
      }
      .mixes omote-mix + omote-mix {
        border-left: 1px solid var(--line);
      }
      .exprbar {
        grid-area: exprbar;
      }
      .expressions {
        grid-area: expressions;
      }
      .hands {
        grid-area: hands;
        display: grid;
        grid-template-columns: repeat(2, minmax(0, 1fr));
        gap: 6px;
        min-width: 0;
      }
      omote-bank {
        grid-area: bank;
      }
      :host(.lost) {
        box-shadow: inset 0 0 0 4px #d21f10;
      }
      :host(.lost) .live {
        opacity: 0.45;
        filter: grayscale(0.7);
      }
      @media (min-width: 1600px) {
        .faces,
        .expressions {
          --tile: 96px;
        }
        :host {
          grid-template-columns: minmax(330px, 0.8fr) 104px minmax(480px, 1.2fr) 104px minmax(480px, 1.1fr);
        }
      }
      @media (max-width: 1100px) and (min-width: 800px) {
        :host {
          grid-template-columns: minmax(178px, 0.7fr) 78px minmax(260px, 1fr) 78px minmax(250px, 1fr);
        }
        .faces,
        .expressions {
          --tile: 56px;
        }
      }
      @media (max-width: 799px) {
        :host {
          height: auto;
          min-height: 100dvh;
          overflow: visible;
          grid-template:
            "status status" auto
            "air air" 420px
            "facebar exprbar" 300px
            "faces faces" auto
            "expressions expressions" auto
            "hands hands" 270px
            "bank bank" auto / minmax(0, 1fr) minmax(0, 1fr);
        }
        omote-status {
          position: sticky;
          top: 0;
          z-index: 5;
          background: var(--ground);
        }
        .faces,
        .expressions {
          max-height: 420px;
        }
      }
      @media (max-height: 640px) and (min-width: 800px) {
        :host {
          height: auto;
          overflow: visible;
          grid-template-rows: 50px 420px 230px;
        }
        omote-status {
          position: sticky;
          top: 0;
          z-index: 5;
          background: var(--ground);
        }
      }
    `,
  ];

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
    this.classList.toggle("lost", !this.desk.online);
    const rig = this.rig;
    return html`
      <omote-status
        .rig=${rig}
        @help=${() => {
          this.helping = true;
        }}
      ></omote-status>
      <omote-palette class="panel faces live" .rig=${rig} .axis=${"face"}></omote-palette>
      <omote-tbar class="panel facebar live" .rig=${rig} .axis=${"face"}></omote-tbar>
      <section class="panel air live" aria-label="On air and coming">
        <omote-monitor .rig=${rig}></omote-monitor>
        <div class="mixes">
          <omote-mix .rig=${rig} .axis=${"face"}></omote-mix>
          <omote-mix .rig=${rig} .axis=${"expression"}></omote-mix>
        </div>
      </section>
      <omote-tbar class="panel exprbar live" .rig=${rig} .axis=${"expression"}></omote-tbar>
      <omote-palette class="panel expressions live" .rig=${rig} .axis=${"expression"}></omote-palette>
      <section class="hands live" aria-label="Head and gaze">
        <omote-pad class="panel" .rig=${rig} .what=${"head"}></omote-pad>
        <omote-pad class="panel" .rig=${rig} .what=${"gaze"}></omote-pad>
      </section>
      <omote-bank class="panel live" .rig=${rig}></omote-bank>
      ${this.helping ? html`<omote-help .rig=${rig} @close=${this.#closeHelp}></omote-help>` : nothing}
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
      this.desk.panic();
    } else if (command.do === "help") this.helping = !this.helping;
    else if (command.do === "centre") this.desk.centre();
    else if (command.do === "clear") this.desk.clearChannels(Object.keys(this.desk.state?.channels ?? {}));
    else if (command.do === "focus") this.#at<Palette | Pad | TBar>(PLACES[command.place])?.focus();
    else this.#obeyAxis(command);
  }

  #obeyAxis(command: Extract<Command, { axis: unknown }>): void {
    const { axis } = command;
    const { seconds } = this.desk.timing[axis];
    if (command.do === "call") this.#at<Palette>(axis === "face" ? ".faces" : ".expressions")?.callIndex(command.index);
    else if (command.do === "release") this.desk.release(axis);
    else if (command.do === "hand") this.desk.setTiming(axis, { seconds: seconds === null ? 1 : null });
    else this.desk.setTiming(axis, { seconds: neighbour(seconds, command.direction) });
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
} as const;

/** True while a key press belongs to a field for text. */
function isTyping(event: KeyboardEvent): boolean {
  return event
    .composedPath()
    .some((target) => target instanceof HTMLInputElement || target instanceof HTMLTextAreaElement);
}
