/** The field for the name of what was kept, or of an own thing that is renamed: what is typed in it plays nothing. */

import { css, html, nothing, type PropertyValues } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { layerWhileShown } from "../../ui/key_presses";
import { base, ellipsis, entry } from "../../ui/theme";
import { ConsoleElement } from "../controls/console_element";
import { LONGEST_ITEM_NAME, type Naming } from "../show_file/own_items";
import type { Topic } from "../store/page_store";

/** Milliseconds for which the field of what was kept waits for a first letter, from when it is in the cast. */
const PATIENCE = 8000;

const style = css`
  :host(:not([open])) {
    display: none;
  }
  form {
    display: flex;
    gap: 4px;
  }
  input {
    ${entry}
    flex: 1 1 150px;
    width: 150px;
    min-height: 28px;
    border-color: var(--hand);
  }
  input::placeholder {
    color: var(--dim);
  }
  label {
    align-self: center;
    max-width: 110px;
    ${ellipsis}
  }
  .why {
    flex: 1 1 150px;
    align-self: center;
    color: var(--attention);
  }
  button {
    min-height: 28px;
    white-space: nowrap;
  }
`;

@customElement("omote-name-field")
export class NameField extends ConsoleElement {
  @state() private naming: Naming | null = null;
  @query("input") private field!: HTMLInputElement | null;
  #waiting: ReturnType<typeof setTimeout> | undefined;

  static override styles = [base, style];

  constructor() {
    super();
    layerWhileShown(this, "form", () => this.#end(""));
  }

  protected override readonly topics: readonly Topic[] = ["naming"];

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    clearTimeout(this.#waiting);
  }

  override willUpdate(): void {
    const { naming } = this.context.items;
    if (naming === this.naming) return;
    if (this.naming !== null && this.field !== null) this.context.items.endNaming(this.naming, this.field.value);
    this.naming = naming;
  }

  override updated(changed: PropertyValues): void {
    if (changed.has("naming")) this.#begin();
    const { naming, field } = this;
    if (naming === null || !naming.fresh || naming.item === null || this.#waiting !== undefined) return;
    if (field?.value === "") this.#waiting = setTimeout(() => this.#end(""), PATIENCE);
  }

  #begin(): void {
    clearTimeout(this.#waiting);
    this.#waiting = undefined;
    const { naming, field } = this;
    this.toggleAttribute("open", naming !== null);
    if (naming === null || field === null) return;
    field.value = naming.refused?.label ?? (naming.fresh ? "" : (naming.item?.label ?? ""));
    if (naming.refused?.left === true) return;
    field.focus();
    field.select();
  }

  override render() {
    const { naming } = this;
    if (naming === null) return nothing;
    const { refused, item } = naming;
    const what = item?.label ?? `the ${naming.kind}`;
    return html`<form @submit=${this.#submit}>
      ${naming.fresh ? nothing : html`<label for="name" title=${what}>${what}:</label>`}
      <input id="name" aria-label="Name of ${what}" maxlength=${LONGEST_ITEM_NAME} placeholder="type a name" autocomplete="off"
        @input=${() => clearTimeout(this.#waiting)} @blur=${this.#left} />
      <button>Name it</button>
      ${refused === undefined ? nothing : html`<button type="button" aria-label="Leave the name of ${what}" title="Leave the name as it is" @click=${() => this.#end("")}>✕</button><span class="why" role="alert">${refused.reason}</span>`}
    </form>`;
  }

  readonly #submit = (event: Event): void => {
    event.preventDefault();
    this.#end(this.field?.value ?? "");
  };

  /** Whoever goes on elsewhere has typed the name; the field of what was kept stays while nothing was. */
  readonly #left = (event: FocusEvent): void => {
    const inside = event.relatedTarget instanceof Node && this.renderRoot.contains(event.relatedTarget);
    const typed = this.field?.value ?? "";
    if (!inside && document.hasFocus()) this.#end(typed, true);
  };

  #end(typed: string, left = false): void {
    const { naming } = this;
    if (naming === null) return;
    this.naming = null;
    this.context.items.endNaming(naming, typed, left);
  }
}
