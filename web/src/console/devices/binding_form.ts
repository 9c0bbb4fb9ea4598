/** The form of one binding: what a control plays, its range, curve and kind. */

import { css, html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import type { BindingDocument } from "../../link/messages";
import { layerWhileShown } from "../../ui/key_presses";
import { base, entry } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import type { Topic } from "../store/page_store";
import { readArguments } from "./binding_fields";
import { isLevel } from "./binding_target";
import { DevicesElement, section } from "./devices_element";

type Mode = "fader" | NonNullable<BindingDocument["button"] | BindingDocument["relative"]>;
const MODES: readonly (readonly [Mode, string])[] = [
  ["fader", "fader"],
  ["momentary", "key, while it is held"],
  ["toggle", "key, on and off"],
  ["twos_complement", "encoder, two's complement"],
  ["binary_offset", "encoder, binary offset"],
  ["sign_magnitude", "encoder, sign and magnitude"],
];
const AXES: Readonly<Record<string, readonly string[]>> = {
  head: ["yaw", "pitch", "roll"],
  gaze: ["yaw", "pitch"],
  place: ["x", "depth", "size", "turn"],
};

/** A binding that the form opens with, and the one that it replaces. */
export interface Draft {
  readonly binding: BindingDocument;
  readonly replaces: BindingDocument | null;
}

const style = css`
  form {
    display: grid;
    grid-template-columns: repeat(auto-fill, minmax(150px, 1fr));
    gap: 8px;
    margin-bottom: 10px;
    padding: 10px;
    border: 1px solid var(--edge);
    border-radius: 6px;
    background: var(--raised);
  }
  label {
    display: grid;
    align-content: start;
    gap: 2px;
    font-size: 12px;
    color: var(--dim);
  }
  .wide,
  .row {
    grid-column: 1 / -1;
  }
  input:not([type="checkbox"]) {
    ${entry}
    width: 100%;
    min-height: 28px;
  }
  input[type="checkbox"] {
    width: 24px;
    height: 24px;
  }
`;

/** Tells `close` when it is done with. */
/** What a control plays of the whole show. */
const SHOW_PATHS = ["go", "back", "pause", "assert", "light", "memory", "black", "fade_to_black", "fade_up", "panic"];

@customElement("omote-binding-form")
export class BindingForm extends DevicesElement {
  @property({ attribute: false }) draft!: Draft;
  @state() private edited: BindingDocument | null = null;

  static override styles = [base, section, style];

  constructor() {
    super();
    layerWhileShown(this, "form", () => this.close());
  }

  protected override readonly topics: readonly Topic[] = ["binding_list"];

  override willUpdate(changed: Map<PropertyKey, unknown>): void {
    if (changed.has("draft")) this.edited = this.draft.binding;
  }

  override firstUpdated(): void {
    const fields = [...this.renderRoot.querySelectorAll<HTMLInputElement>("input")];
    (fields.find(({ value }) => value === "") ?? fields[0])?.focus();
  }

  override render() {
    const binding = this.edited as BindingDocument;
    const level = isLevel(binding);
    const fader = level && binding.button === "" && binding.relative === "";
    return html`<form @submit=${this.#keep} autocomplete="off">
      ${this.#text(
        "Device",
        "device",
        binding.device,
        this.devices.devices.map(({ name }) => name),
      )}
      ${this.#text("Control", "control", binding.control, Object.keys(this.devices.device(binding.device)?.values ?? {}))}
      ${this.#text("plays (an address, or bank:NAME)", "to", binding.to, this.#addresses(), "wide")}
      ${this.#axis(binding)} ${level ? nothing : this.#arguments(binding)}
      ${level ? this.#mode(binding) : nothing}
      ${level ? html`${this.#number("Low", "low", binding.low)} ${this.#number("High", "high", binding.high)}` : nothing}
      ${fader ? html`${this.#number("Curve (1 even, 2 fine below)", "curve", binding.curve)} ${this.#pickUp(binding)}` : nothing}
      ${fader ? this.#number("Dead zone beside the middle of a stick, 0 to .45", "dead_zone", binding.dead_zone) : nothing}
      ${binding.relative === "" ? nothing : this.#number("Part of the range per step", "step", binding.step)}
      ${this.#text("Bank (none: in all)", "bank", binding.bank, [...new Set(this.devices.bindings.map(({ bank }) => bank))].filter(Boolean))}
      <div class="row">
        <button type="submit">${this.draft.replaces === null ? "Bind" : "Keep"}</button>
        <button type="button" data-close @click=${() => this.close()}>Cancel</button>
      </div>
    </form>`;
  }

  #change(change: Partial<BindingDocument>): void {
    this.edited = { ...(this.edited as BindingDocument), ...change };
  }

  #text(
    label: string,
    key: "device" | "control" | "to" | "bank",
    value: string,
    choices: readonly string[],
    wide = "",
  ) {
    return html`<label class=${wide}>${label}
      <input name=${key} list="choices-${key}" .value=${value} ?required=${key !== "bank"} @input=${(event: Event) => this.#change({ [key]: textOf(event) })} />
      <datalist id="choices-${key}">${choices.map((choice) => html`<option value=${choice}></option>`)}</datalist></label>`;
  }

  /** Empty: the target's own. */
  #number(label: string, key: "low" | "high" | "curve" | "step" | "dead_zone", value: number | null) {
    const own = key === "low" || key === "high";
    const read = (event: Event): void => {
      const text = textOf(event);
      const number = Number(text);
      if (text === "" ? own : Number.isFinite(number)) this.#change({ [key]: text === "" ? null : number });
    };
    return html`<label>${label}
      <input name=${key} type="number" step="any" ?required=${!own} placeholder=${own ? "its own" : ""} .value=${value === null ? "" : String(value)} @change=${read} /></label>`;
  }

  #axis({ to, axis }: BindingDocument) {
    const axes = AXES[to.split("/").at(-1) ?? ""];
    if (axes === undefined) return nothing;
    return html`<label>Axis<select name="axis" required @change=${(event: Event) => this.#change({ axis: textOf(event) })}>
      <option value="" .selected=${axis === ""}></option>
      ${axes.map((option) => html`<option value=${option} .selected=${option === axis}>${option}</option>`)}</select></label>`;
  }

  /** What a call is given: a name and, after a comma, seconds or `hand`. */
  #arguments({ arguments: values }: BindingDocument) {
    return html`<label>with (name, seconds)<input name="arguments" .value=${values.join(", ")}
      @change=${(event: Event) => this.#change({ arguments: readArguments(textOf(event)) })} /></label>`;
  }

  #mode({ button, relative }: BindingDocument) {
    const mode = button || relative || "fader";
    const choose = (event: Event): void => {
      const chosen = textOf(event) as Mode;
      const isKey = chosen === "momentary" || chosen === "toggle";
      this.#change({
        button: isKey ? chosen : "",
        relative: isKey || chosen === "fader" ? "" : (chosen as BindingDocument["relative"]),
      });
    };
    return html`<label>Mode<select name="mode" @change=${choose}>
      ${MODES.map(([value, says]) => html`<option value=${value} .selected=${value === mode}>${says}</option>`)}</select></label>`;
  }

  #pickUp({ pick_up }: BindingDocument) {
    return html`<label title="It acts once it has crossed the value on air; else at once">Pick-up
      <input name="pick_up" type="checkbox" .checked=${pick_up} @change=${(event: Event) => this.#change({ pick_up: (event.target as HTMLInputElement).checked })} /></label>`;
  }

  /** Addresses that a control can play, of the characters that there are. */
  #addresses(): string[] {
    const characters = Object.keys(this.store.state?.characters ?? {});
    const own = ["face", "expression", "head", "gaze", "fade/face", "fade/expression", "panic"];
    const channels = this.store.expressions.map(({ name }) => `channel/${name}`);
    const of = characters.flatMap((who) =>
      [...own, ...this.#macros(who), ...channels].map((path) => `/omote/${who}/${path}`),
    );
    return [...of, ...SHOW_PATHS.map((path) => `/omote/${path}`)];
  }

  readonly #macros = (who: string): string[] =>
    Object.keys(this.store.state?.characters[who]?.macros ?? {}).map((name) => `macro/${name}`);

  readonly #keep = (event: Event): void => {
    event.preventDefault();
    this.devices.bind({ ...(this.edited as BindingDocument) }, this.draft.replaces);
    this.close();
  };
}
