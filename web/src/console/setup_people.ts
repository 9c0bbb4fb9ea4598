/** The people of a show, in the set-up of an admin's console: who has a token, new ones, their codes, and their end. */

import { css, html, LitElement, nothing } from "lit";
import { customElement, query, state } from "lit/decorators.js";
import { type AccessRole, PeopleList, readAccess, roleAllows } from "../access/page_access";
import { ACCESS_ROLES } from "../link/constants";
import type { CodeDocument, PersonDocument } from "../link/messages";
import { base, entry, row } from "../ui/theme";

const LONGEST_NAME = 24;
/** For how many hours a token is made; null: for ever. */
const TIMES: readonly (readonly [string, number | null])[] = [
  ["for ever", null],
  ["for 4 hours", 4],
  ["for a day", 24],
  ["for a week", 168],
];
const FIRST_ROLE: AccessRole = "operate";
const READ_EVERY = 2000;

const style = css`
  :host {
    display: grid;
    gap: 10px;
  }
  p {
    color: var(--dim);
  }
  .name {
    flex: 1 1 140px;
    min-width: 0;
    overflow-wrap: anywhere;
  }
  .said {
    color: var(--attention);
  }
  input {
    ${entry}
    flex: 1 1 120px;
    min-height: 26px;
  }
  img {
    width: min(260px, 100%);
    justify-self: center;
    background: #fff;
  }
  .address {
    user-select: all;
    overflow-wrap: anywhere;
    color: var(--text);
  }
`;

/** Shows nothing on a console that may not change the list, or of a show that asks nobody. */
@customElement("omote-people")
export class SetupPeople extends LitElement {
  @state() private people: readonly PersonDocument[] | null = null;
  @state() private code: CodeDocument | null = null;
  @state() private said = "";
  /** Whose token the next press revokes. */
  @state() private sure = "";
  @query("form") private form!: HTMLFormElement;
  readonly #list = new PeopleList();
  #timer: ReturnType<typeof setInterval> | undefined;

  static override styles = [base, row, style];

  override connectedCallback(): void {
    super.connectedCallback();
    void this.#open();
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    clearInterval(this.#timer);
  }

  override render() {
    if (this.people === null) return nothing;
    return html`
      <h2>People</h2>
      <p>Who may enter this show from other machines. A token that carries its role's name is shared.</p>
      ${this.people.map((person) => this.#person(person))}
      <form class="row" @submit=${this.#make}>
        <input name="name" aria-label="Name of a person" maxlength=${LONGEST_NAME} placeholder="name of a person" required />
        <select name="role" aria-label="Role">${ACCESS_ROLES.map((role) => html`<option ?selected=${role === FIRST_ROLE}>${role}</option>`)}</select>
        <select name="hours" aria-label="For how long">${TIMES.map(([label], place) => html`<option value=${place}>${label}</option>`)}</select>
        <button type="submit">Make a token</button>
      </form>
      ${this.said === "" ? nothing : html`<p class="said" role="status">${this.said}</p>`}
      ${this.code === null ? nothing : this.#code(this.code)}
    `;
  }

  #person({ id, name, role, until, links, own }: PersonDocument) {
    const ends =
      until === null
        ? ""
        : `, until ${new Date(until * 1000).toLocaleString([], { dateStyle: "short", timeStyle: "short" })}`;
    const here = links === 0 ? "" : `${links} connected`;
    const remarks = [role === name ? "" : role, ends, here, own ? "you" : ""];
    return html`<div class="row" data-person=${name}>
      <span class="name">${name} <small>${remarks.filter((remark) => remark !== "").join(", ")}</small></span>
      <button @click=${() => this.#show(id)}>QR code</button>
      <button @click=${() => this.#revoke(id)}>${this.sure === id ? "Really revoke" : "Revoke"}</button>
    </div>`;
  }

  #code({ address, picture }: CodeDocument) {
    return html`<img src=${picture} alt="QR code of the address below" />
      <p class="address">${address}</p>
      <div class="row"><button @click=${() => this.#hide()}>Hide the code</button></div>`;
  }

  async #open(): Promise<void> {
    const { role, asked } = await readAccess();
    if (!asked || !roleAllows(role, "admin") || !this.isConnected) return;
    await this.#read();
    this.#timer = setInterval(() => void this.#read(), READ_EVERY);
  }

  readonly #read = (): Promise<void> =>
    this.#attempt(async () => {
      this.people = await this.#list.read();
    });

  #show(id: string): void {
    void this.#attempt(async () => {
      this.code = await this.#list.code(id);
      this.said = "";
    });
  }

  #hide(): void {
    this.code = null;
  }

  #revoke(id: string): void {
    if (this.sure !== id) {
      this.sure = id;
      return;
    }
    void this.#attempt(async () => {
      this.sure = "";
      this.people = await this.#list.revoke(id);
      if (this.code?.id === id) this.code = null;
      this.said = "";
    });
  }

  readonly #make = (event: Event): void => {
    event.preventDefault();
    const fields = new FormData(this.form);
    const hours = TIMES[Number(fields.get("hours"))]?.[1] ?? null;
    const wish = { name: String(fields.get("name")).trim(), role: fields.get("role") as AccessRole, hours };
    void this.#attempt(async () => {
      this.code = await this.#list.make(wish);
      this.said = "";
      this.form.reset();
      await this.#read();
    });
  };

  async #attempt(work: () => Promise<void>): Promise<void> {
    try {
      await work();
    } catch (error) {
      this.said = error instanceof Error ? error.message : String(error);
    }
  }
}
