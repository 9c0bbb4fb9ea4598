/** Set-ups: all macros and bindings under a name, called in one press. */

import { css, html, nothing } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { LONGEST_SETUP_NAME } from "../../link/constants";
import { base, entry, flow } from "../../ui/theme";
import type { ConsoleContext } from "../controls/console_element";
import { ConsoleElement } from "../controls/console_element";
import type { Topic } from "../store/page_store";
import { SetupCommands } from "./setup_commands";

const style = css`
  :host {
    ${flow}
    gap: 4px 6px;
  }
  h2 {
    margin-right: 4px;
  }
  .setup {
    display: inline-flex;
    min-width: 0;
  }
  .setup button:first-child {
    border-radius: 4px 0 0 4px;
    overflow: hidden;
    text-overflow: ellipsis;
  }
  .setup .delete {
    border-left: 0;
    border-radius: 0 4px 4px 0;
    min-width: 28px;
    padding: 0;
  }
  form {
    ${flow}
    gap: 4px;
    flex: 0 1 260px;
    flex-wrap: nowrap;
  }
  input {
    ${entry}
    flex: 1 1 120px;
    min-height: 26px;
  }
  .wrong {
    color: var(--attention);
  }
`;

@customElement("omote-setups")
export class SetupRow extends ConsoleElement<Pick<ConsoleContext, "store">> {
  /** The one that keeping once more replaces. */
  @state() private replaces = "";
  @state() private wrong = "";
  @query("input") private field!: HTMLInputElement;

  static override styles = [base, style];
  protected override readonly topics: readonly Topic[] = ["setup_list", "link"];

  get #setups(): SetupCommands {
    return new SetupCommands(this.store);
  }

  override render() {
    const { names, called } = this.#setups;
    return html`<h2 title="All macros and bindings under a name">Set-ups</h2>
      ${names.map((name) => this.#setup(name, name === called))}
      <form @submit=${this.#keep}><input aria-label="Name of the set-up" maxlength=${LONGEST_SETUP_NAME} placeholder="name of a set-up" @input=${this.#type} />
        <button type="submit" title="Keeps all macros and bindings as they are">${this.replaces === "" ? "Keep" : "Replace it"}</button></form>
      ${this.wrong === "" ? nothing : html`<span class="wrong" role="alert">${this.wrong}</span>`}`;
  }

  #setup(name: string, called: boolean) {
    return html`<span class="setup"><button data-setup=${name} aria-pressed=${called} title=${called ? "Plays now" : "Plays by it from now on"} @click=${() => this.#setups.call(name)}>${name}</button>
      <button class="delete" aria-label="Delete the set-up ${name}" title="Delete it; what plays goes on" @click=${() => this.#setups.drop(name)}>×</button></span>`;
  }

  readonly #type = (): void => {
    [this.replaces, this.wrong] = ["", ""];
  };

  /** One that is there is replaced by a second press alone. */
  readonly #keep = (event: Event): void => {
    event.preventDefault();
    const name = this.field.value.trim();
    const { names } = this.#setups;
    if (name === "") this.wrong = "Type a name for the set-up.";
    else if (names.includes(name) && this.replaces !== name) {
      [this.replaces, this.wrong] = [name, `There is a set-up ${name}: press once more to replace it.`];
    } else {
      this.#setups.keep(name);
      this.field.value = "";
      this.#type();
    }
  };
}
