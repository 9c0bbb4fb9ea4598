/** The set-up of a console: the face that a second panic brings, and layouts by name. */

import { css, html } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { EASING_NAMES } from "../link/constants";
import { closeOutside, curtain } from "../ui/dialog_style";
import { layerWhileShown } from "../ui/key_presses";
import { base, entry } from "../ui/theme";
import { ConsoleElement, chosenIn } from "./controls/console_element";
import type { Axis } from "./store/axis";
import type { ConsoleLayout } from "./store/console_layout";
import type { Topic } from "./store/console_store";
import { DEFAULT_LAYOUT } from "./store/layout_storage";
import { MANY_CHOICES, secondsLabel } from "./store/timing";

const AXES: readonly Axis[] = ["face", "expression"];
const LONGEST_NAME = 40;

/** Home face and layouts, over everything else but panic. Tells `close`. */
@customElement("omote-setup")
export class Setup extends ConsoleElement {
  @state() private names: readonly string[] = [];
  /** The layout that is there already, and that saving once more replaces. */
  @state() private replaces: string | null = null;
  /** How the console was before a layout was chosen. */
  @state() private earlier: ConsoleLayout | null = null;
  @query("input") private entry!: HTMLInputElement;

  static override styles = [
    base,
    curtain,
    css`
      :host {
        inset: 62px 0 0; /* panic stays in sight */
        background: #0006; /* and what is on air */
      }
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
      .row,
      .names {
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
      .names button {
        overflow-wrap: anywhere;
      }
    `,
  ];

  constructor() {
    super();
    closeOutside(this, () => this.#close());
    layerWhileShown(this, "dialog", () => this.#close());
  }

  protected override topics(): readonly Topic[] {
    return ["panic", "cast", "timing"];
  }

  override firstUpdated(): void {
    this.renderRoot.querySelector("select")?.focus();
    void this.#list();
  }

  override render() {
    const chosen = this.context.layouts.chosen;
    return html`<section class="panel" role="dialog" aria-modal="true" aria-label="Set-up">
      <h2>Home face</h2>
      <p>Panic holds the face on air still; panic again brings this one, on every console.</p>
      ${this.#home()}
      <h2>Easing</h2>
      <div class="row">${AXES.map((axis) => this.#easing(axis))}</div>
      <h2>Layout</h2>
      <p>What you set (times, by hand, palettes, faders) stays in this browser. A saved layout can be chosen on every console of this show.</p>
      <div class="names" role="group" aria-label="Choose a layout">
        ${this.names.map(
          (name) =>
            html`<button data-layout=${name} aria-pressed=${name === chosen} @click=${() => this.#choose(name)}>${name}</button>`,
        )}
      </div>
      <p>A fresh console opens with the layout that is saved under the name ${DEFAULT_LAYOUT}.</p>
      <form class="row" @submit=${this.#save}>
        <input aria-label="Name of the layout" maxlength=${LONGEST_NAME} placeholder="name of a layout" @input=${this.#rename} .value=${chosen === DEFAULT_LAYOUT ? "" : chosen} />
        <button type="submit">${this.replaces === null ? "Save as" : "Replace it"}</button>
      </form>
      ${this.earlier === null ? "" : html`<div class="row"><button @click=${this.#back}>Back to how it was</button></div>`}
      <div class="row"><button class="close" @click=${() => this.#close()}>Close</button></div>
    </section>`;
  }

  #home() {
    const face = this.store.state?.home_face ?? "";
    const seconds = this.store.state?.home_seconds ?? 0;
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

  async #list(): Promise<void> {
    this.names = await this.context.layouts.names();
  }

  async #choose(name: string): Promise<void> {
    this.earlier ??= this.store.layout;
    await this.context.layouts.choose(name);
    this.replaces = null;
    this.store.say(`Laid out as ${name}.`, "done");
    this.requestUpdate();
  }

  readonly #back = (): void => {
    if (this.earlier !== null) this.store.arrange(this.earlier);
    this.earlier = null;
    this.store.say(null);
  };

  readonly #rename = (): void => {
    this.replaces = null;
  };

  /** Saves under a name; one that is there, in whatever case, is replaced only by a second press. */
  readonly #save = (event: Event): void => {
    event.preventDefault();
    const typed = this.entry.value.trim();
    if (typed === "") {
      this.store.say("Not saved: type a name for the layout first.");
      this.entry.focus();
      return;
    }
    const known = this.names.find((name) => name.toLowerCase() === typed.toLowerCase());
    if (known !== undefined && this.replaces !== known) {
      this.replaces = known;
      this.store.say(`Every console has a layout ${known}: press once more to replace it, or type another name.`);
    } else this.#send(known ?? typed);
  };

  #send(name: string): void {
    this.replaces = null;
    if (!this.context.layouts.save(name)) {
      this.store.say("Not saved: the link to the show is lost.");
      return;
    }
    if (!this.names.includes(name)) this.names = [...this.names, name];
    this.requestUpdate();
    this.store.say(`Saved as ${name}: every console can choose it.`, "done");
  }

  #close(): void {
    this.dispatchEvent(new CustomEvent("close"));
  }
}
