/** The bank of faders: channels by region of the face, and macros. */

import { html } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import type { ExpressionDocument, MacroMapping } from "../../link/messages";
import { base } from "../../ui/theme";
import { AnimatedElement } from "../controls/console_element";
import { isTwoWay } from "../mappings/macro_targets";
import type { BankTab } from "../store/arrangement";
import { byRegion, type Region, type Strip, stripsOf } from "../store/channels";
import { handsOf } from "../store/held_state";
import type { Topic } from "../store/page_store";
import { style } from "./bank_style";
import "../controls/fader";
import "../mappings/macro_fader";

const KINDS: Readonly<Record<ExpressionDocument["kind"], string>> = {
  neutral: "",
  performed: "performed",
  arkit: "ARKit",
  makehuman: "MakeHuman",
  omote: "Omote",
  spring: "spring",
  limb: "limb",
  own: "own",
};

/** A fader for every channel, a region at a time; what is touched can be gathered on one tab. */
@customElement("omote-bank")
export class Bank extends AnimatedElement {
  /** The channels gathered when the tab "touched" was opened; a fader brought back to zero stays under the hand. */
  @state() private gathered: readonly string[] = [];
  @query("nav") private nav!: HTMLElement;
  @query(".strips") private list!: HTMLElement;

  static override styles = [base, style];

  protected override readonly topics: readonly Topic[] = ["manifest", "arrangement", "mapping_list", "characters"];

  private get tab(): BankTab {
    return this.store.arrangement.tab;
  }

  /** The channels of the tab now open. */
  #shown(): readonly ExpressionDocument[] {
    const playable = this.store.expressions.filter((expression) => expression.kind !== "neutral");
    if (this.tab === "touched") return playable.filter((expression) => this.gathered.includes(expression.name));
    return this.tab === "macros" ? [] : (byRegion(playable).get(this.tab) ?? []);
  }

  get #macros(): readonly MacroMapping[] {
    return this.context.mappings.list;
  }

  #touched(): string[] {
    const channels = this.store.air ? handsOf(this.store.air).channels : {};
    return Object.keys(channels).filter((name) => channels[name] !== 0);
  }

  #movedMacros(): string[] {
    return Object.entries(this.store.air?.macros ?? {}).flatMap(([name, { value }]) => (value === 0 ? [] : [name]));
  }

  #open(tab: BankTab): void {
    this.gathered = this.#touched();
    this.store.arrange({ tab });
  }

  override render() {
    const macros: BankTab[] = this.#macros.length > 0 || this.tab === "macros" ? ["macros"] : [];
    const tabs: BankTab[] = ["touched", ...macros, ...byRegion(this.store.expressions).keys()];
    const shown = this.#shown();
    return html`
      <header>
        <nav role="tablist" aria-label="Channels by region">
          ${tabs.map(
            (tab) => html`<button role="tab" data-tab=${tab} aria-selected=${tab === this.tab}
              @click=${() => this.#open(tab)}>
              ${tab}<span class="count"></span>
            </button>`,
          )}
        </nav>
        <button
          aria-pressed=${this.store.linked}
          title="Left and right of a pair move together"
          @click=${() => {
            this.store.arrange({ linked: !this.store.linked });
          }}
        >
          Link R L
        </button>
        <button data-clear="region" @click=${() => this.#clear(shown)}>
          Clear ${this.tab}
        </button>
        <button data-clear="all" @click=${() => this.store.clearChannels(this.#touched())}>Clear all</button>
      </header>
      <div class="strips" @scroll=${this.#hint}>${this.tab === "macros" ? this.#macroStrips() : this.#strips(stripsOf(shown))}</div>
    `;
  }

  /** Puts what is shown to rest. */
  #clear(shown: readonly ExpressionDocument[]): void {
    if (this.tab !== "macros") this.store.clearChannels(shown.map(({ name }) => name));
    else for (const { name } of this.#macros) this.store.macro(name).nudge(0);
  }

  #macroStrips() {
    if (this.#macros.length === 0) return html`<div class="empty">No macro: Set-up, Mappings</div>`;
    return repeat(
      this.#macros,
      (mapping) => `${this.context.mappings.character} ${mapping.name} ${isTwoWay(mapping)}`,
      (mapping) => html`<div class="strip single"><div class="faders">
          <omote-macro-fader .context=${this.context} .name=${mapping.name} .both=${isTwoWay(mapping)}></omote-macro-fader></div>
        <div class="label" title=${mapping.name}>${mapping.name}</div></div>`,
    );
  }

  override firstUpdated(): void {
    new ResizeObserver(this.#hint).observe(this.list);
  }

  override updated(): void {
    this.#hint();
  }

  /** Fades what goes on to the right: scroll bars are hidden on tablets until they are used. */
  readonly #hint = (): void => {
    const { scrollLeft, clientWidth, scrollWidth } = this.list;
    this.write.flag(this.list, "more", scrollWidth - clientWidth - scrollLeft > 4);
  };

  #strips(strips: readonly Strip[]) {
    if (strips.length === 0)
      return html`<div class="empty">${this.tab === "touched" ? "No channel is on air" : ""}</div>`;
    const kinds = [...new Set(strips.map((strip) => strip.kind))];
    return kinds.map(
      (kind) => html`
        <div class="kind">${KINDS[kind]}</div>
        ${repeat(
          strips.filter((strip) => strip.kind === kind),
          (strip) => strip.key,
          (strip) => this.#strip(strip),
        )}
      `,
    );
  }

  #strip(strip: Strip) {
    return html`<div class="strip ${strip.channels.length > 1 ? "pair" : "single"}">
      <div class="faders">
        ${strip.channels.map(
          ({ name, side }) => html`<omote-fader .context=${this.context} .channel=${name} .side=${side}></omote-fader>`,
        )}
      </div>
      <div class="label" title=${strip.channels.map(({ name }) => name).join(", ")}>
        ${strip.label}<small>${strip.unit.split(/(?=[A-Z])/).map((part) => html`${part}<wbr>`)}</small>
      </div>
    </div>`;
  }

  paint(): void {
    const touched = new Set(this.#touched());
    const regions = byRegionCached(this.store.expressions);
    for (const button of this.nav.querySelectorAll<HTMLElement>("button")) {
      const tab = button.dataset.tab as BankTab;
      const names =
        tab === "macros"
          ? this.#movedMacros()
          : tab === "touched"
            ? [...touched]
            : (regions.get(tab) ?? []).filter((name) => touched.has(name));
      this.write.text(button.querySelector(".count") as Element, names.length === 0 ? "" : String(names.length));
    }
  }
}

let cached: { of: readonly ExpressionDocument[]; regions: Map<Region, string[]> } | null = null;

/** The names of each region, worked out once per cast. */
function byRegionCached(of: readonly ExpressionDocument[]): Map<Region, string[]> {
  if (cached?.of !== of) {
    const regions = [...byRegion(of)].map(
      ([region, inside]) => [region, inside.map((expression) => expression.name)] as const,
    );
    cached = { of, regions: new Map(regions) };
  }
  return cached.regions;
}
