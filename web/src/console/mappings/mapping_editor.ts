/** The chosen macro: what plays it, where it plays, and its targets. */

import { css, html, nothing } from "lit";
import { customElement, property, query, state } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import { LONGEST_MACRO, MOST_TARGETS } from "../../link/constants";
import type { MacroMapping, MacroTarget } from "../../link/messages";
import { base, entry, flow } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import type { ConditionChanged } from "./condition_form";
import { newTarget, wrongName } from "./macro_targets";
import { MappingsElement } from "./mappings_element";
import type { TargetChanged } from "./target_editor";
import "./condition_form";
import "./macro_bindings";
import "./target_editor";

const style = css`
  :host {
    display: grid;
    gap: 10px;
    align-content: start;
  }
  .row {
    ${flow}
    gap: 4px 8px;
  }
  input {
    ${entry}
    flex: 0 1 180px;
    min-height: 28px;
    font-weight: 700;
  }
  .wrong {
    flex: 1 1 100%;
    color: var(--attention);
  }
  .targets {
    display: grid;
    grid-template-columns: repeat(auto-fill, minmax(min(270px, 100%), 1fr));
    gap: 8px;
  }
  .row select {
    flex: 0 1 240px;
    min-width: 0;
    min-height: 28px;
  }
  section {
    display: grid;
    gap: 4px;
  }
  @media (pointer: coarse) {
    input,
    select {
      min-height: 44px;
    }
  }
`;

/** Tells `teach` where the macro is to be learned anew. */
@customElement("omote-mapping-editor")
export class MappingEditor extends MappingsElement {
  @property({ attribute: false }) mapping!: MacroMapping;
  /** Its page has faders that can be touched. */
  @property({ type: Boolean }) teaches = false;
  @state() private wrong = "";
  @query("input") private field!: HTMLInputElement;

  static override styles = [base, style];

  override willUpdate(changed: Map<PropertyKey, MacroMapping | undefined>): void {
    if (changed.get("mapping")?.name !== this.mapping.name) this.wrong = "";
  }

  override render() {
    const { mapping, context } = this;
    const { refused } = this.mappings;
    return html`
      <div class="row"><input aria-label="Name of the macro" maxlength=${LONGEST_MACRO} .value=${mapping.name} @change=${this.#rename} />
        ${this.teaches ? html`<button data-again title="What is touched from now on takes the place of its targets" @click=${() => this.tell("teach")}>Learn anew</button>` : nothing}
        <button data-copy @click=${() => this.mappings.copy(mapping)}>Copy</button>
        <button data-delete title="Undo brings it back" @click=${() => this.mappings.drop(mapping)}>Delete</button>
        ${this.wrong === "" ? nothing : html`<span class="wrong" role="alert">${this.wrong}</span>`}
        ${refused === "" ? nothing : html`<span class="wrong" role="alert">${refused}</span>`}</div>
      <section><h2>Played by</h2><omote-macro-bindings .context=${context} .name=${mapping.name}></omote-macro-bindings></section>
      <omote-condition-form .context=${context} .mapping=${mapping} @condition=${this.#condition}></omote-condition-form>
      <section><h2>Targets</h2><div class="targets">${repeat(
        mapping.targets,
        ({ to }) => `${mapping.name} ${to}`,
        (target) =>
          html`<omote-target-editor .context=${context} .mapping=${mapping} .target=${target} data-target=${target.to}
            @target=${(event: TargetChanged) => this.#change(target, event)}></omote-target-editor>`,
      )}</div>
      ${this.#more()}</section>`;
  }

  #more() {
    const { targets } = this.mapping;
    const taken = targets.map(({ to }) => to);
    if (taken.length >= MOST_TARGETS) return html`<p>It plays ${MOST_TARGETS}, which is as many as a macro does.</p>`;
    const free = this.mappings.choices.filter(([to]) => !taken.includes(to));
    return html`<div class="row"><select aria-label="One more target" @change=${this.#add}>
      <option value="" .selected=${true}>One more target …</option>
      ${free.map(([to, label]) => html`<option value=${to}>${label}</option>`)}</select></div>`;
  }

  readonly #add = (event: Event): void => {
    const to = textOf(event);
    (event.target as HTMLSelectElement).value = "";
    if (to !== "") this.#set({ targets: [...this.mapping.targets, newTarget(to)] }, `one more target of ${this.#name}`);
  };

  get #name(): string {
    return this.mapping.name;
  }

  #set(change: Partial<MacroMapping>, what: string): void {
    this.mappings.change({ ...this.mapping, ...change }, what);
  }

  #change(target: MacroTarget, { detail }: TargetChanged): void {
    const { targets } = this.mapping;
    const later =
      detail.target === null
        ? targets.filter((each) => each !== target)
        : targets.map((each) => (each === target ? (detail.target as MacroTarget) : each));
    const what = `${detail.what} in ${this.#name}`;
    if (detail.over) this.#set({ targets: later }, what);
    else this.mappings.play({ ...this.mapping, targets: later });
  }

  readonly #condition = ({ detail }: ConditionChanged): void => {
    this.#set({ when: detail }, `where ${this.#name} plays`);
  };

  readonly #rename = (): void => {
    const to = this.field.value.trim();
    if (to === this.#name) return;
    this.wrong = wrongName(
      to,
      this.mappings.list.map(({ name }) => name),
    );
    if (this.wrong === "") this.mappings.rename(this.#name, to);
  };
}
