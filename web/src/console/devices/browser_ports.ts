/** The devices at this browser: what it lets the page hear, and what to do where it does not. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { base, selectable } from "../../ui/theme";
import type { Topic } from "../store/page_store";
import type { DeviceHearing } from "./browser_devices";
import { DevicesElement, section } from "./devices_element";
import type { DeviceKind } from "./midi_ports";

interface Words {
  readonly kind: DeviceKind;
  readonly title: string;
  /** What a button says that asks for it. */
  readonly ask: string;
  readonly says: Readonly<Record<DeviceHearing, string>>;
}

const MISSING = "This browser has no";
const INSECURE = "Only on a secure page";
const WORDS: readonly Words[] = [
  {
    kind: "midi",
    title: "MIDI",
    ask: "Use MIDI devices",
    says: {
      off: "Dials, faders, keys and pads. The browser asks once whether this page may use them.",
      asking: "The browser asks above: allow MIDI devices.",
      on: "Heard: plug a device in and it comes here by itself.",
      denied:
        "The browser refused. Allow MIDI for this page by the lock or the sliders beside its address, then ask again.",
      missing: `${MISSING} Web MIDI: use Chrome, Edge, Opera or Firefox.`,
      insecure: INSECURE,
    },
  },
  {
    kind: "gamepad",
    title: "Gamepads, joysticks",
    ask: "Use gamepads",
    says: {
      off: "Not heard at this page.",
      asking: "",
      on: "Heard while this page is seen: press a button on the pad, and it comes here.",
      denied: "The browser refused.",
      missing: `${MISSING} gamepads.`,
      insecure: INSECURE,
    },
  },
  {
    kind: "space_mouse",
    title: "Space mice",
    ask: "Choose a space mouse",
    says: {
      off: "Choose it in the browser's list. Some systems list it as a gamepad of six axes: then push it, and it comes by itself.",
      asking: "Choose it in the browser's list.",
      on: "Heard.",
      denied: "The browser refused.",
      missing: `${MISSING} WebHID (Chrome and Edge have): a space mouse is heard where the system lists it as a gamepad.`,
      insecure: INSECURE,
    },
  },
];

const style = css`
  .ports {
    display: grid;
    gap: 8px;
  }
  .port {
    display: grid;
    grid-template-columns: auto minmax(0, 1fr) auto;
    align-items: center;
    gap: 2px 8px;
  }
  .port small {
    grid-column: 2 / 4;
    font-size: 12px;
    color: var(--dim);
  }
  .secure {
    padding: 8px 10px;
    border: 1px solid var(--attention);
    border-radius: 4px;
    color: var(--text);
    ${selectable}
  }
  ul {
    margin: 8px 0 0;
  }
  li {
    padding: 3px 0;
    overflow-wrap: anywhere;
  }
`;

@customElement("omote-browser-ports")
export class BrowserPorts extends DevicesElement {
  static override styles = [base, section, style];

  protected override readonly topics: readonly Topic[] = ["browser_devices"];

  get #browser() {
    return this.context.devices.browser;
  }

  override render() {
    const { hearing, here, showControl } = this.#browser;
    return html`<h2>At this browser</h2>
      ${Object.values(hearing).includes("insecure") ? this.#insecure() : nothing}
      <div class="ports">${WORDS.map((words) => this.#port(words, hearing[words.kind]))}</div>
      ${hearing.midi === "on" && !showControl ? html`<p class="attention">The browser keeps MIDI Show Control back: allow “MIDI devices, full control” for this page by the lock or the sliders beside its address, then stop and ask again.</p>` : nothing}
      <ul>${[...here].map(([device, { refused, unsent }]) =>
        refused === null && !unsent
          ? nothing
          : html`<li class="attention" data-refused=${device}>${device}: ${refused ?? "what was sent to it did not reach it. Does another program have it, has it no output, or is MIDI Show Control not allowed?"}</li>`,
      )}</ul>`;
  }

  #port({ kind, title, ask, says }: Words, hearing: DeviceHearing) {
    const can = hearing !== "missing" && hearing !== "insecure";
    const on = hearing === "on";
    return html`<div class="port" data-port=${kind} data-hearing=${hearing}>
      <span class="lamp ${on ? "on" : ""}"></span><b>${title}</b>
      ${can ? html`<button ?disabled=${hearing === "asking"} @click=${() => void this.#browser.hear(kind, !on)}>${on ? "Stop" : ask}</button>` : html`<span></span>`}
      <small class=${hearing === "denied" ? "attention" : ""}>${says[hearing]}</small>
    </div>`;
  }

  /** Browsers give MIDI and HID to secure pages alone: what to do on a plain address of the network. */
  #insecure() {
    return html`<p class="secure">Browsers let only secure pages use MIDI devices and space mice, and
      <b>${location.origin}</b> is not one. Open this page at the show's https address, or on the show's own machine at
      <b>http://127.0.0.1:${location.port}${location.pathname}</b>. Gamepads, OSC, sACN and Art-Net work as they are.</p>`;
  }
}
