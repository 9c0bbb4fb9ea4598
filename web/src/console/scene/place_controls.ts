/** The place of one character as sliders and numbers: metres, times, degrees. */

import { css, html } from "lit";
import { customElement, property } from "lit/decorators.js";
import { base, ellipsis, entry } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import { AnimatedElement } from "../controls/console_element";
import type { Topic } from "../store/page_store";
import { facing, PLACE_PARTS, type PlaceField, type PlacePart, type Placing, shown, written } from "./placing";

const style = css`
  :host {
    display: grid;
    align-content: start;
    grid-auto-rows: max-content;
    gap: 4px;
    min-width: 0;
  }
  h2 {
    ${ellipsis}
  }
  label {
    display: grid;
    grid-template-columns: 66px minmax(50px, 1fr) 62px 12px;
    align-items: center;
    gap: 6px;
    min-height: 30px;
  }
  input {
    min-width: 0;
    width: 100%;
    margin: 0;
    accent-color: var(--hand);
  }
  input[type="number"] {
    ${entry}
    padding: 0 4px;
    min-height: 26px;
    text-align: right;
  }
  .row {
    display: flex;
    flex-wrap: wrap;
    gap: 6px;
  }
  @media (pointer: coarse) {
    input[type="range"],
    input[type="number"] {
      height: var(--finger);
    }
  }
`;

/** Sliders of the lead's place, and keys that turn those who are played. */
@customElement("omote-place-controls")
export class PlaceControls extends AnimatedElement {
  @property({ attribute: false }) placing!: Placing;
  /** Seconds that a place takes that is written, and a turn by key. */
  @property({ attribute: false }) seconds = 1;

  static override styles = [base, style];

  protected override readonly topics: readonly Topic[] = ["characters", "link"];

  override render() {
    const { state, played } = this.store;
    return html`<h2>Place of ${state?.characters[played.lead]?.label ?? ""}</h2>
      ${PLACE_PARTS.map((part) => this.#slider(part))}
      <div class="row">
        <button class="facing" ?disabled=${this.#turning.length < 2} title="Turns those who are played, or all on the stage, towards each other, at most 60° from the audience"
          @click=${this.#face}>Face each other</button>
        <button class="front" title="Turns those who are played to the audience" @click=${this.#front}>Face front</button>
      </div>`;
  }

  #slider(part: PlacePart) {
    const { label, unit, low, high, step } = part;
    return html`<label>${label}
      <input type="range" name=${part.part} aria-label="${label} (${unit})" min=${low} max=${high} step=${step}
        @input=${(event: Event) => this.#drag(part, event)} @change=${() => this.placing.release()} />
      <input type="number" name=${part.part} aria-label="${label} (${unit}), number" min=${part.least} max=${part.most} step=${step}
        @change=${(event: Event) => this.#write(part, event.target as HTMLInputElement)} /><span>${unit}</span></label>`;
  }

  /** Sliders and numbers follow what moves, but those that somebody is at. */
  paint(): void {
    const { lead } = this.store.played;
    const { held } = this.placing;
    const place = held?.character === lead ? held.now : this.store.air?.place;
    if (place === undefined || this.offsetParent === null) return;
    for (const input of this.renderRoot.querySelectorAll("input")) {
      const part = PLACE_PARTS.find((candidate) => candidate.part === input.name) as PlacePart;
      const value = shown(part, place[part.part]);
      const busy = input.type === "number" ? this.shadowRoot?.activeElement === input : input.matches(":active");
      if (!busy && input.value !== value) input.value = value;
    }
  }

  #drag({ part, scale }: PlacePart, event: Event): void {
    const value = Number(textOf(event)) / scale;
    this.placing.drag(this.store.played.lead, { [part]: value });
  }

  #write(part: PlacePart, input: HTMLInputElement): void {
    const value = written(part, input.value);
    if (typeof value === "string") this.store.say(value);
    else this.#move({ [this.store.played.lead]: { [part.part]: value } });
    input.blur(); // what stands there from now on is where the character is
  }

  /** Whom the key turns: those who are played, where they are several, else all on the stage. */
  get #turning(): readonly string[] {
    const [played, characters] = [this.store.played.names, this.store.state?.characters ?? {}];
    if (played.length > 1) return played;
    return Object.entries(characters).flatMap(([name, character]) =>
      character.presence > 0 && !character.leaves ? [name] : [],
    );
  }

  readonly #face = (): void => {
    const characters = this.store.state?.characters ?? {};
    const places = this.#turning.flatMap((name) => {
      const place = characters[name]?.place;
      return place === undefined ? [] : [[name, place] as const];
    });
    const turns = Object.entries(facing(Object.fromEntries(places)));
    this.#move(Object.fromEntries(turns.map(([name, turn]) => [name, { turn }])));
  };

  readonly #front = (): void => {
    this.#move(Object.fromEntries(this.store.played.names.map((name) => [name, { turn: 0 }])));
  };

  #move(changes: Readonly<Record<string, Partial<Record<PlaceField, number>>>>): void {
    this.placing.move(changes, this.seconds);
  }
}
