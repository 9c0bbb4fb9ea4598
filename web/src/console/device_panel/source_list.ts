/** Every source of a show: whether it is there, how much comes, and where its controls stand. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import type { DeviceState } from "../../link/messages";
import { base } from "../../ui/theme";
import { StyleWriter } from "../controls/console_element";
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

/** Tells `bind` with a control that somebody wants to bind. */
@customElement("omote-sources")
export class SourceList extends DevicesElement {
  readonly #written = new StyleWriter();
  /** The preset and the character that are chosen for a device, before they are loaded. */
  readonly #chosen = new Map<string, { preset: string; character: string }>();
  #shape = "";

  static override styles = [
    base,
    section,
    css`
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
        display: flex;
        flex-wrap: wrap;
        align-items: center;
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
        position: absolute;
        inset: 0;
        transform-origin: left;
        transform: scaleX(0);
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
        user-select: text;
        -webkit-user-select: text;
      }
      .missing {
        margin: 4px 0 0;
        font-size: 12px;
        color: var(--attention);
      }
    `,
  ];

  /** It renders again where something comes or goes; what moves is painted. */
  protected override listen(changed: () => void): (() => void)[] {
    const heard = (): void => {
      const shape = JSON.stringify(this.devices.devices.map(shapeOf));
      if (shape === this.#shape) return;
      this.#shape = shape;
      changed();
    };
    return [
      this.devices.listen("devices", heard),
      this.devices.listen("bindings", changed),
      this.store.listen("characters", changed),
    ];
  }

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
              (one) => this.#source(one),
            )
      }</div>`;
  }

  #source(one: DeviceState) {
    const controls = controlsOf(one);
    return html`<article class=${one.plugged ? "" : "gone"} data-device=${one.name}>
      <header><span class="lamp"></span><b>${one.name}</b>
        <span class="kind">${KINDS[one.kind]}${one.where === "" ? "" : `, ${one.plugged ? "at" : "was at"} ${one.where}`}${one.plugged ? "" : "; not plugged in, its bindings wait"}</span>
        <span class="numbers"></span></header>
      ${one.advice ? html`<p class="advice">${one.advice[0]?.toUpperCase()}${one.advice.slice(1)}.</p>` : nothing}
      ${this.#missing(one)}
      ${controls.length === 0 ? nothing : html`<div class="bars" role="group" aria-label="Controls of ${one.name}">${controls.map((control) => this.#bar(one, control))}</div>`}
      ${AT_PAGES.includes(one.kind) ? this.#presets(one) : nothing}
    </article>`;
  }

  /** How many of its bindings wait for a name that is not there; the table says which. */
  #missing({ name }: DeviceState) {
    const count = this.devices.bindings.filter(
      (one) => one.device === name && this.devices.whyMissing(one) !== "",
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
    const fitting = this.devices.presets.filter((one) => one.kind === kind);
    const made = fitting.find((one) => one.matches.some((match) => matchesName(match, name)));
    const chosen = this.#chosen.get(name) ?? {
      preset: preset || (made?.name ?? fitting[0]?.name ?? ""),
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
          : html`<select aria-label="Preset of ${name}" @change=${(event: Event) => choose({ preset: (event.target as HTMLSelectElement).value })}>
        ${fitting.map((one) => html`<option value=${one.name} .selected=${one.name === chosen.preset}>${one.label}${one === made ? " (made for it)" : ""}</option>`)}
      </select>
      <select aria-label="Whom ${name} plays" @change=${(event: Event) => choose({ character: (event.target as HTMLSelectElement).value })}>
        <option value="*" .selected=${chosen.character === "*"}>all characters</option>
        ${Object.entries(this.store.state?.characters ?? {}).map(([id, { label }]) => html`<option value=${id} .selected=${chosen.character === id}>${label}</option>`)}
      </select>
      <button data-load title="In the place of all its bindings" @click=${() => this.#load(name, chosen)}>Load preset</button>`
      }
      ${banks.length === 0 ? nothing : html`<span class="kind">Bank</span>${["", ...banks].map((one) => html`<button data-bank=${one} aria-pressed=${one === bank} @click=${() => this.devices.chooseBank(name, one)}>${one || "none"}</button>`)}`}
    </div>`;
  }

  #load(device: string, { preset, character }: { preset: string; character: string }): void {
    const found = this.devices.presets.find(({ name }) => name === preset);
    if (found !== undefined) this.devices.loadPreset(device, found, character);
  }

  override paint(): void {
    const write = this.#written;
    for (const article of this.renderRoot.querySelectorAll<HTMLElement>("article")) {
      const one = this.devices.device(article.dataset.device as string);
      if (one === null) continue;
      const rejected = one.rejected > 0 ? `, ${one.rejected} rejected` : "";
      const there = one.plugged && (one.kind !== "tracker" || one.rate > 0);
      article.querySelector(".lamp")?.classList.toggle("on", there);
      write.text(article.querySelector(".numbers") as Element, `${rate(one.rate)}/s, ${one.heard} heard${rejected}`);
      for (const bar of article.querySelectorAll<HTMLElement>(".bar")) this.#paintBar(bar, one);
    }
  }

  #paintBar(bar: HTMLElement, { values, waiting }: DeviceState): void {
    const control = bar.dataset.control as string;
    const [fill, mark] = bar.children as unknown as [HTMLElement, HTMLElement];
    this.#written.style(fill, "transform", `scaleX(${(values[control] ?? 0).toFixed(3)})`);
    const at = waiting[control];
    mark.hidden = at === undefined;
    if (at !== undefined) this.#written.style(mark, "transform", `translateX(${(100 * at).toFixed(1)}%)`);
  }
}

const rate = (value: number): string => (value < 9.95 && value > 0 ? value.toFixed(1) : value.toFixed(0));

/** What a source is rendered again for. */
const shapeOf = (one: DeviceState): unknown[] => [
  one.name,
  one.kind,
  one.where,
  one.plugged,
  one.bank,
  one.banks,
  one.preset,
  controlsOf(one),
];

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
