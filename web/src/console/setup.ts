/** The set-up of a console: the face that a second panic brings, easings, its name, and layouts. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { readAccess } from "../access/page_access";
import { addressOn } from "../link/bus";
import { EASING_NAMES } from "../link/constants";
import { ACCEPTED, type ImportKind } from "../ui/file_import";
import { base, entry } from "../ui/theme";
import { textOf } from "../ui/topic_element";
import { LONGEST_CONSOLE_NAME } from "./console_name";
import { ConsoleDialog, sheet } from "./controls/console_dialog";
import { offersOf, offersStyle } from "./panels/offers";
import type { Axis } from "./store/axis";
import type { Topic } from "./store/page_store";
import { MANY_CHOICES, secondsLabel } from "./store/timing";
import "./mappings/setup_row";
import "./show_file/setup_layouts";
import "./setup_people";

const AXES: readonly Axis[] = ["face", "expression"];

const style = css`
  section {
    width: min(460px, 100%);
  }
  h2 {
    margin-top: 6px;
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
`;

/** Home face and layouts, over everything else but panic. Tells `close`. */
@customElement("omote-setup")
export class Setup extends ConsoleDialog {
  protected override readonly first = "select";
  static override styles = [base, sheet, style, offersStyle];

  protected override readonly topics: readonly Topic[] = ["panic", "manifest", "timing", "welcome", "notice", "leases"];

  /** The name is that of this console's token: nobody chooses another. */
  @state() private ofToken = false;

  override connectedCallback(): void {
    super.connectedCallback();
    void readAccess().then(({ name }) => {
      this.ofToken = name !== "";
    });
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
        <input aria-label="Name of this console" maxlength=${LONGEST_CONSOLE_NAME} .value=${this.store.name} ?disabled=${this.ofToken} @change=${this.#rename} />
      </div>
      ${this.ofToken ? html`<p>It is that of your token; whoever lists the people below may change it.</p>` : nothing}
      <h2>Leases</h2>
      <p>With several operators: whoever touches a part first has it, another is told who and may take it over.</p>
      <div class="row">
        <button data-open="leases" @click=${() => this.tell("leases")}>Leases: ${this.context.leases.report.on ? "on" : "off"} ...</button>
      </div>
      <omote-layouts .context=${this.context}></omote-layouts>
      <omote-people></omote-people>
      <h2>Devices</h2>
      <p>Dials, keys, pads and sticks play what they are bound to.</p>
      <div class="row">
        <button data-open="learn" @click=${() => this.tell("learn")}>Learn</button>
        <button data-open="devices" @click=${() => this.tell("devices")}>Devices and bindings</button>
        <button data-open="mappings" title="One number under a hand plays several targets, each by its curve" @click=${() => this.tell("mappings")}>Mappings</button>
        <a href="/microphone" target="omote-microphone">Speak through a character by a microphone</a>
      </div>
      <omote-setups .context=${this.context}></omote-setups>
      <h2>Cues and clips</h2>
      <p>Whole looks in the order of a show, recorded here and called by GO.</p>
      <div class="row"><a href="/cues" target="omote-cues">Record and play cues</a><a href="/solo" target="omote-solo">Play alone</a><a href="/clips" target="omote-clips">Record and edit motion clips</a>
        <button data-open="moments" @click=${() => this.tell("moments")}>Mark and keep</button></div>
      <div class="row"><a class="bus" href=${addressOn(this.store.bus === "air" ? "preview" : "air", location)}>${this.store.bus === "air" ? "Build a look up in preview, not on air" : "Back to what is on air"} (Shift P)</a></div>
      <h2>Bring in files</h2>
      <p>Expressions (.json, .glb, .vrm, .obj) and heads of our topology (.glb, .obj) come under Own; the show goes on meanwhile.</p>
      <div class="row">${(["expression", "face"] as const).map((kind) => this.#files(kind))}</div>
      <div class="row">
        <button class="close" @click=${() => this.close()}>Close</button>
        <button @click=${() => this.tell("help")}>Keys and conventions</button>
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
      <select aria-label="Home face" @change=${(event: Event) => this.store.setHome(textOf(event), seconds)}>
        ${this.store.faces.map(({ name, label }) => html`<option value=${name} .selected=${name === face}>${label}</option>`)}
      </select>
      <select aria-label="Seconds to the home face" @change=${(event: Event) => this.store.setHome(face, Number(textOf(event)))}>
        ${times.map((time) => html`<option value=${time} .selected=${time === seconds}>${time === 0 ? "cut" : `in ${secondsLabel(time)} s`}</option>`)}
      </select>
    </div>`;
  }

  #easing(axis: Axis) {
    const chosen = this.store.timing[axis].easing;
    return html`<select aria-label="Easing of a call (${axis})"
      @change=${(event: Event) => this.store.setTiming(axis, { easing: textOf(event) })}>
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
    this.close(); // how far they are stands in the bar
  }

  readonly #rename = (event: Event): void => {
    const field = event.target as HTMLInputElement;
    this.context.rename(field.value);
    if (!this.store.online) this.store.say("The others read it once the link to the show is back.");
  };
}

/** A button that opens the list of files of the field beside it. */
function chooseFiles(event: Event): void {
  (event.currentTarget as HTMLElement).parentElement?.querySelector("input")?.click();
}
