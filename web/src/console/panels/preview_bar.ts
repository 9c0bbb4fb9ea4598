/** The bar of a page that looks at the preview: it says so, and takes what was built up on air. */

import { css, html, nothing } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { addressOn, PREVIEW_WORDS } from "../../link/bus";
import type { CueName } from "../../link/messages";
import { base, ellipsis, entry, palette, previewColours } from "../../ui/theme";
import { hearWhileShown, TopicElement } from "../../ui/topic_element";
import type { ConsoleStore } from "../store/console_store";
import type { Topic } from "../store/page_store";

const LONGEST = 3600;
const FIRST_SECONDS = "2";

const style = css`
  :host {
    ${previewColours}
    box-sizing: border-box;
    position: fixed;
    inset: auto 0 0;
    z-index: 4;
    height: var(--bar);
    display: flex;
    align-items: center;
    gap: 8px;
    padding: 0 10px;
  }
  strong {
    letter-spacing: 0.08em;
    white-space: nowrap;
  }
  .cue {
    flex: 1;
    min-width: 0;
    ${ellipsis}
  }
  button,
  a {
    flex: none;
    min-height: 36px;
    color: #fff;
  }
  a {
    display: inline-flex;
    align-items: center;
  }
  .take {
    font-weight: 700;
    color: #fff;
    background: #a5281b;
    border-color: #fff;
  }
  input {
    ${entry}
    width: 52px;
    height: 36px;
  }
  label {
    white-space: nowrap;
  }
  @media (max-width: 620px) {
    .cue,
    .words {
      display: none;
    }
    :host {
      gap: 5px;
      padding: 0 5px;
      justify-content: space-between;
      font-size: 12px;
    }
    strong {
      white-space: normal;
      letter-spacing: 0;
      max-width: 76px;
    }
    input {
      width: 40px;
    }
    button {
      padding: 0 6px;
    }
  }
`;

@customElement("omote-preview-bar")
export class PreviewBar extends TopicElement<Topic> {
  @property({ attribute: false }) store!: ConsoleStore;
  /** Seconds of the next take, as they are typed. */
  @state() private seconds = FIRST_SECONDS;
  @state() private cue: CueName | null = null;

  static override styles = [palette, base, style];

  protected override readonly topics: readonly Topic[] = ["state", "link"];

  constructor() {
    super();
    hearWhileShown<KeyboardEvent>(this, window, ["keydown"], this.#key, true);
  }

  protected override changed(topic: Topic): void {
    if (topic !== "state") this.requestUpdate();
    const cue = this.store.state?.looked_at ?? null;
    if (JSON.stringify(cue) !== JSON.stringify(this.cue)) this.cue = cue;
  }

  override render() {
    const { online } = this.store;
    const { cue } = this;
    return html`<strong role="status">${PREVIEW_WORDS}</strong>
      <span class="cue">${cue === null ? nothing : `Cue ${cue.number}${cue.label === "" ? "" : ` · ${cue.label}`}`}</span>
      ${cue === null ? nothing : html`<button class="update" title="Write what was changed here into cue ${cue.number}" ?disabled=${!online} @click=${() => this.#update(cue)}>Update ${cue.number}</button>`}
      <button class="take" title="Brings what differs on air (Shift Enter)" ?disabled=${!online} @click=${this.take}>TAKE</button>
      <label><span class="words">in </span><input inputmode="decimal" aria-label="Seconds of the take" .value=${this.seconds}
        @input=${(event: InputEvent) => {
          this.seconds = (event.target as HTMLInputElement).value;
        }} /> s</label>
      <button class="reset" title="Preview is what is on air now; what was built up is forgotten" ?disabled=${!online} @click=${this.#reset}>Reset</button>
      <a href=${addressOn("air", location)} title="Back to what is on air (Shift P)">On air</a>
      ${online ? nothing : html`<span role="alert">NO LINK</span>`}`;
  }

  /** Brings on air what differs, in the seconds beside the button. */
  readonly take = (): void => {
    const seconds = Number(this.seconds.replace(",", "."));
    if (this.seconds.trim() === "" || !(seconds >= 0 && seconds <= LONGEST))
      this.store.say(`The seconds of a take are "${this.seconds}"; give a number from 0 to ${LONGEST}.`);
    else if (this.store.ask({ type: "take", seconds })) this.store.say(`Taken on air in ${seconds} s.`, "done");
  };

  #update({ identity, number }: CueName): void {
    const done = (): void => this.store.say(`Cue ${number} has what was changed here.`, "done");
    if (this.store.ask({ type: "update_cue", cue: identity })) done();
  }

  readonly #reset = (): void => {
    if (this.store.ask({ type: "reset_preview" })) this.store.say("Preview is what is on air now.", "done");
  };

  readonly #key = (event: KeyboardEvent): void => {
    if (event.code !== "Enter" || !event.shiftKey || event.ctrlKey || event.altKey || event.metaKey) return;
    event.preventDefault();
    event.stopPropagation();
    if (!event.repeat) this.take();
  };
}

/** Adds the bar to a page that looks at the preview, which is as much lower. */
export function showPreviewBar(store: ConsoleStore): void {
  if (store.bus !== "preview") return;
  document.title = `${PREVIEW_WORDS} · ${document.title}`;
  document.documentElement.style.setProperty("--bar", "46px");
  const bar = new PreviewBar();
  bar.store = store;
  document.body.append(bar);
}

/** Loads the page again on the other bus. */
export function changeBus(store: ConsoleStore): void {
  location.assign(addressOn(store.bus === "air" ? "preview" : "air", location));
}
