/** The scene in the place of faders and pads: who is played and on the stage, where, and what the picture holds. */

import { html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { ALL, FRAMING_JOINT, SHOT_SIZES } from "../../link/constants";
import { heldBy, type ShotSize, sizeOf, weightsBy } from "../../link/framings";
import type { CharacterState } from "../../link/messages";
import { base } from "../../ui/theme";
import { whileShown } from "../../ui/topic_element";
import { AnimatedElement } from "../controls/console_element";
import type { Topic } from "../store/page_store";
import { standing } from "../store/played_characters";
import { Placing } from "./placing";
import { SceneCommands, SECONDS } from "./scene_commands";
import { style } from "./scene_panel_style";
import "./place_controls";
import "./place_map";

const LONGEST_LABEL = 80;
const LONGEST_SECONDS = 60;

/** What shots of each size show. */
const SIZES: Readonly<Record<ShotSize, string>> = {
  portrait: "Heads alone, as on a stage of faces",
  head: "The head on its body",
  bust: "Head and shoulders",
  half: "Down to the hips",
  full: "The whole figure, on the floor",
};

/** Characters, places and framing. Tells `close`. */
@customElement("omote-scene-panel")
export class ScenePanel extends AnimatedElement {
  /** Of coming and going, framing, and places that are written. */
  @state() private seconds = SECONDS;
  #placing: Placing | null = null;

  static override styles = [base, style];

  protected override readonly topics: readonly Topic[] = ["characters", "link"];

  constructor() {
    super();
    this.addEventListener("keydown", this.#key);
    whileShown(this, () => () => this.#placing?.release());
  }

  override render() {
    const { context, seconds } = this;
    this.#placing ??= new Placing(this.store);
    return html`<section class="who" role="region" aria-label="Scene">
        <header><h2>Scene</h2>
          <label>in <input type="number" aria-label="Seconds of coming, going, framing and places" min="0" max=${LONGEST_SECONDS} step="0.5"
            .value=${String(seconds)} @change=${(event: Event) => this.#time(event.target as HTMLInputElement)} /> s</label>
          <button class="close" aria-label="Close the scene" @click=${this.close}>Close</button></header>
        <div class="shots" role="group" aria-label="Framing"><h2>Shot</h2>${this.#framings()}</div>
        ${this.store.manifest?.figures?.bodies.length ? html`<div class="shots" role="group" aria-label="Size of the shot"><h2>Size</h2>${this.#sizes()}</div>` : nothing}
        ${Object.entries(this.#commands.characters).map(([name, character]) => this.#character(name, character))}
      </section>
      <omote-place-map .context=${context} .placing=${this.#placing}></omote-place-map>
      <omote-place-controls .context=${context} .placing=${this.#placing} .seconds=${seconds}></omote-place-controls>`;
  }

  #character(name: string, character: CharacterState) {
    const { store } = this;
    const [{ label, leaves }, there] = [character, standing(character) === ""];
    const several = Object.keys(this.#commands.characters).length > 1;
    return html`<div class="row ${there ? "" : "off"}" data-character=${name}>
      <input type="checkbox" aria-label="Play ${label}" .checked=${store.played.names.includes(name)}
        @change=${() => store.play(store.played.pressed(name, true))} />
      <input type="text" aria-label="Name of ${label}" maxlength=${LONGEST_LABEL} .value=${label}
        @keydown=${commit} @change=${(event: Event) => this.#rename(name, event.target as HTMLInputElement)} />
      <button class="move" aria-label="${there ? "Leave" : "Enter"}: ${label}" @click=${() => this.#commands.move(name, !there)}>${there ? "Leave" : "Enter"}</button>
      <button class="remove" aria-label="Remove ${label}" ?disabled=${!several || leaves} @click=${() => this.#commands.remove(name)}>Remove</button>
    </div>`;
  }

  /** A key for each shot: all, one of each, those who are played, and one that somebody else has called. */
  #framings() {
    const [characters, played] = [this.#commands.characters, this.store.played.names];
    const names = Object.keys(characters);
    const keys = new Map<string, readonly string[]>([[ALL, []], ...names.map((name) => [name, [name]] as const)]);
    if (played.length > 1 && played.length < names.length) keys.set(framingOf(played), played);
    for (const framing of this.#onAir) if (!keys.has(framing)) keys.set(framing, framing.split(FRAMING_JOINT));
    const label = (held: readonly string[]): string =>
      held.length === 0 ? "All" : held.map((name) => characters[name]?.label ?? name).join(" + ");
    return [...keys].map(
      ([framing, held]) => html`<button class="shot" data-framing=${framing} aria-pressed="false"
        @click=${() => this.#commands.frame(held)}><i></i><span>${label(held)}</span></button>`,
    );
  }

  /** A key for each size of a shot. */
  #sizes() {
    return SHOT_SIZES.map(
      (size) => html`<button class="shot" data-size=${size} aria-pressed="false" title=${SIZES[size]}
        @click=${() => this.#commands.size(size)}><i></i><span>${size}</span></button>`,
    );
  }

  get #onAir(): readonly string[] {
    const state = this.store.state;
    const called = state?.framing_call?.target;
    return [...Object.keys(state?.framing ?? {}), ...(called === undefined ? [] : [called])].map(heldBy);
  }

  #shots = "";

  /** Marks the shot that is on air or called, and how far each is. */
  paint(): void {
    const { state } = this.store;
    if (state === null || this.offsetParent === null) return;
    const shots = this.#onAir.join();
    if (shots !== this.#shots) this.requestUpdate();
    this.#shots = shots;
    const [heaviest] = Object.entries(state.framing).sort(([, weight], [, other]) => other - weight);
    const chosen = state.framing_call?.target ?? heaviest?.[0] ?? ALL;
    this.#mark("framing", weightsBy(state.framing, heldBy), heldBy(chosen));
    this.#mark("size", weightsBy(state.framing, sizeOf), sizeOf(chosen));
  }

  /** Marks keys of one kind. */
  #mark(kind: "framing" | "size", weights: ReadonlyMap<string, number>, chosen: string): void {
    for (const key of this.renderRoot.querySelectorAll<HTMLElement>(`.shot[data-${kind}]`)) {
      const name = key.dataset[kind] ?? "";
      const weight = weights.get(name) ?? 0;
      this.write.attribute(key, "aria-pressed", String(name === chosen));
      if (kind === "framing")
        this.write.attribute(key, "title", weight > 0 && weight < 1 ? `${Math.round(100 * weight)} %` : "");
      this.write.style(key.querySelector("i") as HTMLElement, "transform", `scaleX(${weight.toFixed(3)})`);
    }
  }

  #rename(name: string, input: HTMLInputElement): void {
    this.#commands.rename(name, input.value.trim());
    if (input.value.trim() === "") input.value = this.#commands.characters[name]?.label ?? "";
  }

  #time(input: HTMLInputElement): void {
    const seconds = input.value.trim() === "" ? Number.NaN : Number(input.value);
    if (seconds >= 0 && seconds <= LONGEST_SECONDS) this.seconds = seconds;
    else {
      this.store.say(`${input.value || "Nothing"} is no time; give 0 to ${LONGEST_SECONDS} seconds.`);
      input.value = String(this.seconds);
    }
  }

  get #commands(): SceneCommands {
    return new SceneCommands(this.store, this.seconds);
  }

  readonly #key = (event: KeyboardEvent): void => {
    const typing = event.composedPath()[0] instanceof HTMLInputElement;
    if (event.key === "Escape" && !typing) this.close();
  };
}

const framingOf = (names: readonly string[]): string => [...names].sort().join(FRAMING_JOINT);

/** Enter ends the writing of a name. */
function commit(event: KeyboardEvent): void {
  if (event.key === "Enter") (event.target as HTMLInputElement).blur();
}
