/** The macros of a character: a fader for each, and the curves of the chosen one. */

import { css, html, nothing } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import { LONGEST_MACRO } from "../../link/constants";
import type { MacroMapping } from "../../link/messages";
import { base, ellipsis, entry, flow } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import type { Topic } from "../store/page_store";
import { isTwoWay, newTarget, wrongName } from "./macro_targets";
import { MappingsElement } from "./mappings_element";
import "./macro_fader";
import "./mapping_editor";

/** A macro that is to be learned by touch. */
export type TeachAsked = CustomEvent<{ readonly name: string }>;

const style = css`
  :host {
    display: grid;
    grid-template: "head head" auto "list chosen" minmax(0, 1fr) / minmax(180px, 0.3fr) minmax(0, 1fr);
    gap: 8px;
    min-height: 0;
  }
  .panel {
    padding: 10px 12px;
    min-width: 0;
    overflow: auto;
  }
  .head {
    grid-area: head;
    ${flow}
    gap: 6px 10px;
  }
  form {
    ${flow}
    gap: 4px 6px;
    flex: 1 1 340px;
  }
  input {
    ${entry}
    flex: 0 1 160px;
    min-height: 28px;
  }
  select {
    flex: 0 1 190px;
    min-width: 0;
    min-height: 28px;
  }
  .wrong,
  .missing {
    flex: 1 1 100%;
    color: var(--attention);
  }
  .list {
    grid-area: list;
    display: grid;
    grid-template-columns: repeat(auto-fill, minmax(64px, 1fr));
    grid-auto-rows: 186px;
    gap: 6px;
    align-content: start;
  }
  .strip {
    display: grid;
    grid-template-rows: minmax(0, 1fr) auto;
    justify-items: stretch;
    padding: 2px;
    border: 1px solid var(--line);
    border-radius: 4px;
    min-width: 0;
  }
  .strip.chosen {
    border-color: var(--focus);
  }
  .strip button {
    ${ellipsis}
    width: 100%;
    padding: 0 2px;
  }
  .chosen-one {
    grid-area: chosen;
  }
  .none {
    grid-column: 1 / -1;
    max-width: 62ch;
    color: var(--dim);
  }
  @media (max-width: 899px) {
    :host {
      grid-template: "head" max-content "list" max-content "chosen" max-content / minmax(0, 1fr);
    }
    .panel {
      overflow: visible;
    }
    .list {
      grid-template-columns: none;
      grid-auto-flow: column;
      grid-auto-columns: 72px;
      grid-auto-rows: 178px;
      overflow-x: auto;
    }
    .list .none {
      width: calc(100vw - 60px);
    }
  }
  @media (pointer: coarse) {
    input,
    select,
    button {
      min-height: 44px;
    }
  }
`;

/** Tells `teach` where one is to be learned by touch. */
@customElement("omote-mappings")
export class MappingsPanel extends MappingsElement {
  /** Its page has faders that can be touched. */
  @property({ type: Boolean }) teaches = false;
  @state() private wrong = "";
  @query("form input") private field!: HTMLInputElement;

  static override styles = [base, style];
  protected override readonly topics: readonly Topic[] = [
    "mapping_list",
    "mapping_learned",
    "manifest",
    "characters",
    "link",
  ];

  override render() {
    const { mappings, context } = this;
    const { chosen, list } = mappings;
    return html`${this.#head()}
      <div class="list panel" role="group" aria-label="Macros">${list.length === 0 ? this.#none() : nothing}${repeat(
        list,
        (mapping) => `${mappings.character} ${mapping.name} ${isTwoWay(mapping)}`,
        (mapping) => this.#strip(mapping, mapping === chosen),
      )}</div>
      <div class="chosen-one panel">${
        chosen === null
          ? nothing
          : html`<omote-mapping-editor .context=${context} .mapping=${chosen} .teaches=${this.teaches} @teach=${() => this.#teach(chosen.name)}></omote-mapping-editor>`
      }</div>`;
  }

  #head() {
    const characters = Object.entries(this.store.state?.characters ?? {});
    const { character, missing, learned } = this.mappings;
    return html`<div class="head panel">
      <h2>Macros</h2>
      ${
        characters.length < 2
          ? nothing
          : html`<select aria-label="Character" @change=${(event: Event) => this.store.play([textOf(event)])}>
        ${characters.map(([name, { label }]) => html`<option value=${name} .selected=${name === character}>${label}</option>`)}</select>`
      }
      <form @submit=${this.#byTouch} autocomplete="off"><input aria-label="Name of a new macro" maxlength=${LONGEST_MACRO} placeholder="name of a macro" @input=${this.#type} />
        ${
          this.teaches
            ? html`<button type="submit" data-teach title="Move a control, then touch what it shall play">Learn by touch</button>`
            : html`<a href="/console" target="omote-console" title="There Set-up, Mappings, Learn by touch">Learn by touch: at the console</a>`
        }
        <select aria-label="Begin with" @change=${this.#begin}><option value="" .selected=${true}>or begin with …</option>
          ${this.mappings.choices.map(([to, label]) => html`<option value=${to}>${label}</option>`)}</select></form>
      ${this.wrong === "" ? nothing : html`<span class="wrong" role="alert">${this.wrong}</span>`}
      ${learned === null ? nothing : html`<span class="missing">${learned.by === this.store.name ? "This console" : learned.by} is teaching the macro ${learned.name}.</span>`}
      ${missing.length === 0 ? nothing : html`<span class="missing">Not there, so they give nothing: ${missing.join(", ")}.</span>`}
    </div>`;
  }

  #none() {
    return html`<p class="none">No macro yet. One number under a hand plays up to eight targets, each by its own curve: type a name, then ${this.teaches ? html`press <b>Learn by touch</b>, move a dial or stick and touch the faders that it shall play` : "choose what it begins with"}.</p>`;
  }

  #strip(mapping: MacroMapping, chosen: boolean) {
    const { name } = mapping;
    return html`<div class="strip ${chosen ? "chosen" : ""}"><omote-macro-fader .context=${this.context} .name=${name} .both=${isTwoWay(mapping)}></omote-macro-fader>
      <button data-macro=${name} aria-pressed=${chosen} title=${name} @click=${() => this.mappings.choose(name)}>${name}</button></div>`;
  }

  readonly #type = (): void => {
    this.wrong = "";
  };

  /** The name that was typed, "" where it cannot be, which is said. */
  #typed(): string {
    const name = this.field.value.trim();
    const taken = this.mappings.list.map((each) => each.name);
    this.wrong = wrongName(name, taken);
    if (this.wrong === "") return name;
    this.field.focus();
    return "";
  }

  readonly #byTouch = (event: Event): void => {
    event.preventDefault();
    const name = this.teaches ? this.#typed() : "";
    if (name !== "") this.#teach(name);
  };

  #teach(name: string): void {
    this.dispatchEvent(new CustomEvent("teach", { detail: { name }, bubbles: true, composed: true }));
  }

  readonly #begin = (event: Event): void => {
    const to = textOf(event);
    (event.target as HTMLSelectElement).value = "";
    const name = to === "" ? "" : this.#typed();
    if (name === "") return;
    this.mappings.change({ name, targets: [newTarget(to)], when: null }, `new macro ${name}`);
    this.field.value = "";
    this.mappings.choose(name);
  };
}
