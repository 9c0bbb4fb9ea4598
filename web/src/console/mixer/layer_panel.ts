/** The layers of the character that is played, as a mixer in the place of faders and pads. */

import { html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { LAYER_PARTS, LAYERS } from "../../link/constants";
import type { CharacterState } from "../../link/messages";
import { base } from "../../ui/theme";
import { hearWhileShown } from "../../ui/topic_element";
import { AnimatedElement } from "../controls/console_element";
import { TIGHT } from "../controls/screen_sizes";
import type { MixerGroup } from "../store/arrangement";
import {
  feedWords,
  followTrend,
  isDriven,
  type LayerName,
  layerOf,
  shownChannels,
  type Trend,
} from "../store/layer_state";
import type { Topic } from "../store/page_store";
import { LayerCommands, layerLabel } from "./layer_commands";
import { style } from "./layer_panel_style";
import "./gaze_target_settings";
import "./motion_settings";
import "./speech_line";
import "./group_heads";
import "./layer_fader";
import "./source_settings";

/** What a layer is, and how it adds to those below it. */
const TITLES: Readonly<Record<LayerName, string>> = {
  breath: "A little is added to all below",
  gaze: "Takes the place of the gaze below",
  emotion: "What is called: faces' expressions",
  blink: "Closes what is open",
  tracker: "A performer's face, in the place of what is below",
  lips: "Speech, in the place of what is below",
  playback: "A recording or a program, in the place of what is below",
  hands: "Faders and pads, in the place of all below",
};
const ROWS = [0, 1, 2];
/** Where strips and groups take turns. */
const IN_TURN = matchMedia(TIGHT);

/** A strip for each layer, the lowest first; beside them the heads of all groups, and one of these. Tells `close`. */
@customElement("omote-layer-panel")
export class LayerPanel extends AnimatedElement {
  /** The layer whose parts and sources are shown; `null`: the first that a source drives. */
  @state() private chosen: LayerName | null = null;
  /** The source that is unfolded, "" for none; `null`: the first of the layer. */
  @state() private unfolded: string | null = null;
  readonly #trends = new Map<string, Trend>();
  #seen: LayerName | null = null;

  static override styles = [base, style];

  protected override readonly topics: readonly Topic[] = ["manifest", "characters", "link", "sources", "arrangement"];

  constructor() {
    super();
    this.addEventListener("keydown", ({ key }) => key === "Escape" && this.close());
    hearWhileShown(this, IN_TURN, ["change"], () => this.requestUpdate());
  }

  /** The group that is shown: beside strips, or in their place. */
  get #group(): MixerGroup {
    const { mixer } = this.store.arrangement;
    return IN_TURN.matches || mixer !== "strips" ? mixer : "sources";
  }

  get #shown(): LayerName {
    return this.chosen ?? this.store.sources[0]?.layer ?? "emotion";
  }

  get #commands(): LayerCommands {
    return new LayerCommands(this.store);
  }

  override render() {
    const label = this.store.air?.label ?? "";
    this.dataset.group = this.#group;
    return html`<div class="strips" role="region" aria-label="Layers of ${label}">${LAYERS.map((layer) => this.#strip(layer))}</div>
      <omote-group-heads role="tablist" aria-label="Groups of the mixer" .context=${this.context} .shown=${this.#group} .layer=${this.#shown}
        @group=${(event: CustomEvent<MixerGroup>) => this.store.arrange({ mixer: event.detail })}>
        <button class="close" aria-label="Close the layers" @click=${this.close}>Close</button></omote-group-heads>
      <section class="detail">${this.#content(this.#group)}</section>`;
  }

  #content(group: MixerGroup) {
    const { context } = this;
    if (group === "sources") return this.#sources();
    if (group === "parts") return this.#parts();
    if (group === "motion") return html`<omote-motion-settings .context=${context}></omote-motion-settings>`;
    if (group === "gaze") return html`<omote-gaze-target-settings .context=${context}></omote-gaze-target-settings>`;
    return group === "speech" ? html`<omote-speech-line .context=${context}></omote-speech-line>` : nothing;
  }

  #strip(layer: LayerName) {
    return html`<div class="strip" data-layer=${layer}>
      <button class="name" aria-pressed=${layer === this.#shown} title="${TITLES[layer]}; its parts and sources"
        @click=${() => this.#choose(layer)}>${layerLabel(layer)}</button>
      <div class="feed"></div>
      <div class="play">
        <omote-layer-fader .context=${this.context} .layer=${layer}></omote-layer-fader>
        <div class="bars" aria-label="What ${layer} does now">${ROWS.map(() => html`<div class="bar"><i></i><span></span></div>`)}</div>
      </div>
      <button class="on" aria-pressed="true" aria-label="${layerLabel(layer)} on" @click=${() => this.#commands.switch(layer)}>On</button>
    </div>`;
  }

  /** What is chosen is in sight, also where strips scroll sideways. */
  override updated(): void {
    const strip = this.renderRoot.querySelector(`.strip[data-layer=${this.#shown}]`);
    if (this.#seen !== this.#shown) strip?.scrollIntoView({ block: "nearest", inline: "nearest" });
    this.#seen = this.#shown;
  }

  /** Shows the sources of a layer, or its parts where nothing drives it. */
  #choose(layer: LayerName): void {
    [this.chosen, this.unfolded] = [layer, null];
    const stays = this.#group === "parts" || (this.#group === "sources" && isDriven(layer));
    if (!stays) this.store.arrange({ mixer: isDriven(layer) ? "sources" : "parts" });
  }

  #parts() {
    const layer = this.#shown;
    return html`<header><b>${layerLabel(layer)}</b><span class="of">shows in each part</span>
        <button class="reset" title="Its influence as at first" @click=${() => this.#commands.reset(layer)}>Reset</button></header>
      <div class="parts" role="group" aria-label="Influence of ${layer} by part">${LAYER_PARTS.map(
        (part) =>
          html`<div><omote-layer-fader .context=${this.context} .layer=${layer} .region=${part}></omote-layer-fader><span>${part}</span></div>`,
      )}</div>`;
  }

  /** All sources, those of the layer that is shown first. */
  #sources() {
    const layer = this.#shown;
    const sources = this.store.sources.toSorted(
      (source, other) => Number(other.layer === layer) - Number(source.layer === layer),
    );
    if (sources.length === 0)
      return html`<p class="none">No source sends. A tracker or a program that does appears here.</p>`;
    const open = this.unfolded ?? sources[0]?.name;
    return sources.map(
      (source) => html`<omote-source-settings .context=${this.context} .source=${source} ?open=${source.name === open}
        @fold=${() => this.#fold(source.name, source.name === open)}></omote-source-settings>`,
    );
  }

  #fold(name: string, open: boolean): void {
    this.unfolded = open ? "" : name;
  }

  paint(): void {
    const { air } = this.store;
    if (air === null || this.offsetParent === null) return;
    for (const strip of this.renderRoot.querySelectorAll<HTMLElement>(".strip")) this.#paintStrip(strip, air);
  }

  #paintStrip(strip: HTMLElement, air: CharacterState): void {
    const [layer, write] = [strip.dataset.layer as LayerName, this.write];
    const layerState = layerOf(air, layer);
    const key = `${this.store.played.lead}/${layer}/${layerState.source}`;
    const trend = followTrend(this.#trends.get(key) ?? null, layerState.trust);
    this.#trends.set(key, trend);
    const feed = strip.querySelector(".feed") as HTMLElement;
    const words = feedWords(
      layer,
      layerState,
      trend,
      this.store.sources.map(({ name }) => name),
    );
    write.text(feed, words);
    write.attribute(feed, "title", words);
    write.flag(feed, "wanted", layerState.source !== "" && layerState.trust < 0.5);
    write.flag(strip, "off", !layerState.on);
    write.flag(strip, "idle", isDriven(layer) && layerState.source === "");
    const on = strip.querySelector(".on") as HTMLElement;
    write.attribute(on, "aria-pressed", String(layerState.on));
    write.text(on, layerState.on ? "On" : "Off");
    this.#paintBars(strip, shownChannels(layerState));
  }

  #paintBars(strip: HTMLElement, channels: readonly (readonly [string, number])[]): void {
    const [write, shown] = [this.write, channels.toSorted(([name], [other]) => ORDER.compare(name, other))];
    for (const [at, bar] of [...strip.querySelectorAll<HTMLElement>(".bar")].entries()) {
      const [name, weight] = shown[at] ?? ["", 0];
      const [fill, text] = bar.children as unknown as [HTMLElement, HTMLElement];
      write.text(text, name === "" ? "" : this.store.label("expression", name));
      write.attribute(bar, "title", name === "" ? "" : `${name} ${weight.toFixed(2)}`);
      write.style(fill, "transform", `scaleX(${Math.min(1, Math.abs(weight)).toFixed(3)})`);
      write.flag(bar, "below", weight < 0);
    }
  }
}

/** Bars stay in their order while they grow and shrink. */
const ORDER = new Intl.Collator("en");
