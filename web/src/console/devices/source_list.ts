/** Every source of a show: whether it is there, how much comes, and where its controls stand. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import type { DeviceState } from "../../link/messages";
import { base, emptyBar, flow, selectable } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import type { Topic } from "../store/page_store";
import { DevicesElement, section } from "./devices_element";

const KINDS: Readonly<Record<DeviceState["kind"], string>> = {
  midi: "MIDI",
  gamepad: "gamepad",
  space_mouse: "space mouse",
  osc: "OSC",
  sacn: "sACN",
  artnet: "Art-Net",
  tracker: "tracker",
};
/** Kinds whose controls are bound by a preset. */
const AT_PAGES: readonly DeviceState["kind"][] = ["midi", "gamepad", "space_mouse"];

/** A control that was pressed to be bound: the binding form opens with it. */
export type ControlPicked = CustomEvent<{ readonly device: string; readonly control: string }>;

const style = css`
  .sources {
    display: grid;
    gap: 8px;
  }
  article {
    padding: 8px 10px;
    border: 1px solid var(--line);
    border-radius: 6px;
    background: var(--raised);
  }
  article.gone {
    opacity: 0.65;
  }
  header {
    ${flow}
    gap: 2px 8px;
  }
  header b {
    overflow-wrap: anywhere;
  }
  .kind,
  .numbers {
    font-size: 12px;
    color: var(--dim);
  }
  .numbers {
    margin-left: auto;
    white-space: nowrap;
  }
  .bars {
    display: grid;
    grid-template-columns: repeat(auto-fill, minmax(82px, 1fr));
    gap: 4px;
    max-height: 190px;
    margin: 6px 0 0;
    overflow: auto;
  }
  .bar {
    position: relative;
    min-height: 26px;
    padding: 0 4px;
    overflow: hidden;
    font-size: 11px;
    text-align: left;
    color: var(--text);
    background: #000;
  }
  .bar:disabled {
    opacity: 1;
    color: var(--dim);
  }
  .bar i {
    ${emptyBar}
    background: #3c4656;
  }
  .bar em {
    position: absolute;
    inset: 0 auto 0 0;
    width: 100%;
    border-left: 2px solid var(--attention);
    pointer-events: none;
  }
  .bar span {
    position: relative;
  }
  .presets,
  .advice {
    margin: 6px 0 0;
  }
  .advice {
    font-size: 12px;
    ${selectable}
  }
  .missing {
    margin: 4px 0 0;
    font-size: 12px;
    color: var(--attention);
  }
`;

/** Tells `bind` with a control that somebody wants to bind. */
@customElement("omote-sources")
export class SourceList extends DevicesElement {
  /** The preset and the character that are chosen for a device, before they are loaded. */
  readonly #chosen = new Map<string, { preset: string; character: string }>();

  static override styles = [base, section, style];

  protected override shape(): unknown {
    return this.devices.devices.map((device) => {
      const { name, kind, where, plugged, bank, banks, preset } = device;
      return [name, kind, where, plugged, bank, banks, preset, controlsOf(device)];
    });
  }

  protected override readonly topics: readonly Topic[] = ["devices", "binding_list", "characters"];

  override render() {
    const all = this.devices.devices;
    return html`<h2>Sources</h2>
      <div class="sources">${
        all.length === 0
          ? html`<p class="none">Nothing has come yet. Use MIDI devices above, press a button on a gamepad, or send OSC,
              sACN or Art-Net to the show: each source appears here with what it sends.</p>`
          : repeat(
              all,
              ({ name, kind }) => `${kind} ${name}`,
              (device) => this.#source(device),
            )
      }</div>`;
  }

  #source(device: DeviceState) {
    const controls = controlsOf(device);
    return html`<article class=${device.plugged ? "" : "gone"} data-device=${device.name}>
      <header><span class="lamp"></span><b>${device.name}</b>
        <span class="kind">${KINDS[device.kind]}${device.where === "" ? "" : `, ${device.plugged ? "at" : "was at"} ${device.where}`}${device.plugged ? "" : "; not plugged in, its bindings wait"}</span>
        <span class="numbers"></span></header>
      ${device.advice ? html`<p class="advice">${device.advice[0]?.toUpperCase()}${device.advice.slice(1)}.</p>` : nothing}
      ${this.#missing(device)}
      ${controls.length === 0 ? nothing : html`<div class="bars" role="group" aria-label="Controls of ${device.name}">${controls.map((control) => this.#bar(device, control))}</div>`}
      ${AT_PAGES.includes(device.kind) ? this.#presets(device) : nothing}
    </article>`;
  }

  /** How many of its bindings wait for a name that is not there; the table says which. */
  #missing({ name }: DeviceState) {
    const count = this.devices.bindings.filter(
      (binding) => binding.device === name && this.devices.whyMissing(binding) !== "",
    ).length;
    if (count === 0) return nothing;
    const says = count === 1 ? "binding waits: what it plays" : "bindings wait: what they play";
    return html`<p class="missing">${count} ${says} is not there. The table says why.</p>`;
  }

  #bar({ name, kind }: DeviceState, control: string) {
    const pick = (): boolean =>
      this.dispatchEvent(new CustomEvent("bind", { detail: { device: name, control } }) satisfies ControlPicked);
    const may = kind !== "osc" && kind !== "tracker";
    return html`<button class="bar" data-control=${control} ?disabled=${!may} title="${control}${may ? ": bind it" : ""}" @click=${pick}>
      <i></i><em hidden></em><span>${control}</span></button>`;
  }

  #presets({ name, kind, banks, bank, preset }: DeviceState) {
    const fitting = this.devices.presets.filter((candidate) => candidate.kind === kind);
    const matching = fitting.find((candidate) => candidate.matches.some((match) => matchesName(match, name)));
    const chosen = this.#chosen.get(name) ?? {
      preset: preset || (matching?.name ?? fitting[0]?.name ?? ""),
      character: "*",
    };
    const choose = (change: Partial<typeof chosen>): void => {
      this.#chosen.set(name, { ...chosen, ...change });
      this.requestUpdate();
    };
    return html`<div class="row presets">
      ${
        fitting.length === 0
          ? nothing
          : html`<select aria-label="Preset of ${name}" @change=${(event: Event) => choose({ preset: textOf(event) })}>
        ${fitting.map((option) => html`<option value=${option.name} .selected=${option.name === chosen.preset}>${option.label}${option === matching ? " (made for it)" : ""}</option>`)}
      </select>
      <select aria-label="Whom ${name} plays" @change=${(event: Event) => choose({ character: textOf(event) })}>
        <option value="*" .selected=${chosen.character === "*"}>all characters</option>
        ${Object.entries(this.store.state?.characters ?? {}).map(([id, { label }]) => html`<option value=${id} .selected=${chosen.character === id}>${label}</option>`)}
      </select>
      <button data-load title="In the place of all its bindings" @click=${() => this.#load(name, chosen)}>Load preset</button>`
      }
      ${banks.length === 0 ? nothing : html`<span class="kind">Bank</span>${["", ...banks].map((choice) => html`<button data-bank=${choice} aria-pressed=${choice === bank} @click=${() => this.devices.chooseBank(name, choice)}>${choice || "none"}</button>`)}`}
    </div>`;
  }

  #load(device: string, { preset, character }: { preset: string; character: string }): void {
    const presetDocument = this.devices.presets.find(({ name }) => name === preset);
    if (presetDocument !== undefined) this.devices.loadPreset(device, presetDocument, character);
  }

  override paint(): void {
    const { write } = this;
    for (const article of this.renderRoot.querySelectorAll<HTMLElement>("article")) {
      const device = this.devices.device(article.dataset.device as string);
      if (device === null) continue;
      const rejected = device.rejected > 0 ? `, ${device.rejected} rejected` : "";
      const there = device.plugged && (device.kind !== "tracker" || device.rate > 0);
      article.querySelector(".lamp")?.classList.toggle("on", there);
      write.text(
        article.querySelector(".numbers") as Element,
        `${rate(device.rate)}/s, ${device.heard} heard${rejected}`,
      );
      for (const bar of article.querySelectorAll<HTMLElement>(".bar")) this.#paintBar(bar, device);
    }
  }

  #paintBar(bar: HTMLElement, { values, waiting }: DeviceState): void {
    const control = bar.dataset.control as string;
    const [fill, mark] = bar.children as unknown as [HTMLElement, HTMLElement];
    this.write.style(fill, "transform", `scaleX(${(values[control] ?? 0).toFixed(3)})`);
    const at = waiting[control];
    mark.hidden = at === undefined;
    if (at !== undefined) this.write.style(mark, "transform", `translateX(${(100 * at).toFixed(1)}%)`);
  }
}

const rate = (value: number): string => (value < 9.95 && value > 0 ? value.toFixed(1) : value.toFixed(0));

/** The controls in an order that stays: by name, numbers by their size. */
const controlsOf = ({ values }: DeviceState): string[] => Object.keys(values).sort(ORDER.compare);
const ORDER = new Intl.Collator("en", { numeric: true });

/** Whether a preset is made for a device: its patterns are regular expressions of Python's. */
function matchesName(pattern: string, name: string): boolean {
  try {
    return new RegExp(pattern, "i").test(name);
  } catch {
    return false;
  }
}
