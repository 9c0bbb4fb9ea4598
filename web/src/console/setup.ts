/** The set-up of a console: the face that a second panic brings, easings, its name, and layouts. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { EASING_NAMES } from "../link/constants";
import { closeOutside, curtainBelowBar } from "../ui/dialog_style";
import { ACCEPTED, type ImportKind } from "../ui/file_import";
import { layerWhileShown } from "../ui/key_presses";
import { base, entry } from "../ui/theme";
import { LONGEST_CONSOLE_NAME } from "./console_name";
import { ConsoleElement, chosenIn } from "./controls/console_element";
import { offersOf, offersStyle } from "./panels/offers";
import type { Axis } from "./store/axis";
import type { Topic } from "./store/page_store";
import { MANY_CHOICES, secondsLabel } from "./store/timing";
import "./setup_layouts";
import "./setup_people";

const AXES: readonly Axis[] = ["face", "expression"];

/** Home face and layouts, over everything else but panic. Tells `close`. */
@customElement("omote-setup")
export class Setup extends ConsoleElement {
  static override styles = [
    base,
    curtainBelowBar,
    css`
      section {
        width: min(460px, 100%);
        max-height: 100%;
        overflow: auto;
        padding: 16px 18px;
        display: grid;
        gap: 10px;
      }
      h2 {
        margin-top: 6px;
      }
      p {
        margin: 0;
        color: var(--dim);
      }
      .row {
        display: flex;
        flex-wrap: wrap;
        align-items: center;
        gap: 6px;
      }
      select,
      input {
        flex: 1 1 140px;
      }
      input {
        ${entry}
        min-height: 26px;
      }
      .files {
        flex: 1 1 140px;
        display: grid;
      }
      .said {
        padding: 6px 10px;
        border: 1px solid var(--line);
        border-radius: 4px;
        color: var(--text);
      }
      .said.attention {
        color: var(--attention);
      }
    `,
    offersStyle,
  ];

  constructor() {
    super();
    closeOutside(this, () => this.#close());
    layerWhileShown(this, "dialog", () => this.#close());
  }

  protected override topics(): readonly Topic[] {
    return ["panic", "cast", "timing", "layouts", "notice", "leases"];
  }

  override firstUpdated(): void {
    this.renderRoot.querySelector("select")?.focus();
  }

  override render() {
    return html`<section class="panel" role="dialog" aria-modal="true" aria-label="Set-up">
      ${this.#said()}
      <h2>Home face</h2>
      <p>Panic holds the face on air still; panic again brings this one, on every console.</p>
      ${this.#home()}
      <h2>Easing</h2>
      <div class="row">${AXES.map((axis) => this.#easing(axis))}</div>
      <h2>This console</h2>
      <p>What the others read on a control that your hand is on.</p>
      <div class="row">
        <input aria-label="Name of this console" maxlength=${LONGEST_CONSOLE_NAME} .value=${this.store.name} @change=${this.#rename} />
      </div>
      <h2>Leases</h2>
      <p>With several operators: whoever touches a part first has it, another is told who and may take it over.</p>
      <div class="row">
        <button data-open="leases" @click=${() => this.dispatchEvent(new CustomEvent("leases"))}>Leases: ${this.context.leases.told.on ? "on" : "off"} ...</button>
      </div>
      <omote-layouts .context=${this.context}></omote-layouts>
      <omote-people></omote-people>
      <h2>Devices</h2>
      <p>Dials, keys, pads and sticks play what they are bound to.</p>
      <div class="row">
        <button data-open="learn" @click=${() => this.dispatchEvent(new CustomEvent("learn"))}>Learn</button>
        <button data-open="devices" @click=${() => this.dispatchEvent(new CustomEvent("devices"))}>Devices and bindings</button>
        <a href="/microphone" target="omote-microphone">Speak through a character by a microphone</a>
      </div>
      <h2>Bring in files</h2>
      <p>Expressions (.json, .glb, .vrm, .obj) and heads of our topology (.glb, .obj) come under Own; the show goes on meanwhile.</p>
      <div class="row">${(["expression", "face"] as const).map((kind) => this.#files(kind))}</div>
      <div class="row">
        <button class="close" @click=${() => this.#close()}>Close</button>
        <button @click=${() => this.dispatchEvent(new CustomEvent("help"))}>Keys and conventions</button>
      </div>
    </section>`;
  }

  /** What the bar says, for it lies behind this on a small screen. */
  #said() {
    const { notice, tone } = this.store;
    return notice === null ? nothing : html`<p class="said ${tone}">${notice} ${offersOf(this.store)}</p>`;
  }

  #home() {
    const face = this.store.air?.home_face ?? "";
    const seconds = this.store.air?.home_seconds ?? 0;
    const times = MANY_CHOICES.includes(seconds) ? MANY_CHOICES : [...MANY_CHOICES, seconds];
    return html`<div class="row">
      <select aria-label="Home face" @change=${(event: Event) => this.store.setHome(chosenIn(event), seconds)}>
        ${this.store.faces.map(({ name, label }) => html`<option value=${name} .selected=${name === face}>${label}</option>`)}
      </select>
      <select aria-label="Seconds to the home face" @change=${(event: Event) => this.store.setHome(face, Number(chosenIn(event)))}>
        ${times.map((one) => html`<option value=${one} .selected=${one === seconds}>${one === 0 ? "cut" : `in ${secondsLabel(one)} s`}</option>`)}
      </select>
    </div>`;
  }

  #easing(axis: Axis) {
    const chosen = this.store.timing[axis].easing;
    return html`<select aria-label="Easing of a call (${axis})"
      @change=${(event: Event) => this.store.setTiming(axis, { easing: chosenIn(event) })}>
      ${EASING_NAMES.map((name) => html`<option value=${name} .selected=${name === chosen}>${axis}: ${name}</option>`)}
    </select>`;
  }

  #files(kind: ImportKind) {
    const field = html`<input type="file" hidden multiple accept=${ACCEPTED[kind]} @change=${(event: Event) => this.#takeIn(event, kind)} />`;
    return html`<label class="files">${field}<button @click=${chooseFiles}>${kind === "face" ? "Faces" : "Expressions"} ...</button></label>`;
  }

  #takeIn(event: Event, kind: ImportKind): void {
    const field = event.target as HTMLInputElement;
    void this.context.imports.add([...(field.files ?? [])], kind);
    field.value = "";
    this.#close(); // how far they are stands in the bar
  }

  readonly #rename = (event: Event): void => {
    const field = event.target as HTMLInputElement;
    this.context.rename(field.value);
    if (!this.store.online) this.store.say("The others read it once the link to the show is back.");
  };

  #close(): void {
    this.dispatchEvent(new CustomEvent("close"));
  }
}

/** A button that opens the list of files of the field beside it. */
function chooseFiles(event: Event): void {
  (event.currentTarget as HTMLElement).parentElement?.querySelector("input")?.click();
}
