/** The panels of the open item, one at a time. */

import { css, html } from "lit";
import { customElement, state } from "lit/decorators.js";
import { base } from "../../ui/theme";
import { controls } from "../controls/controls_style";
import { EditorElement } from "../controls/editor_element";
import type { Topic } from "../session/draft_store";
import type { Kind } from "../session/item_commands";
import "../controls/amount";
import "./exchange_panel";
import "./complexion_panel";
import "./eyes_panel";
import "./history_panel";
import "./layers_panel";
import "./look_panel";
import "./muscles_panel";
import "./points_panel";
import "./pose_panel";
import "./recipe_panel";

type Tab = "layers" | "muscles" | "points" | "eyes" | "skin" | "recipe" | "look" | "pose" | "history" | "exchange";
const FOR_EXPRESSIONS: readonly (readonly [Tab, string])[] = [
  ["layers", "Layers"],
  ["muscles", "Muscles"],
  ["points", "Numbers"],
  ["eyes", "Eyes"],
  ["skin", "Skin"],
  ["history", "History"],
  ["exchange", "Import & export"],
];
const FOR_FACES: readonly (readonly [Tab, string])[] = [
  ["recipe", "Recipe"],
  ["look", "Look"],
  ["history", "History"],
  ["exchange", "Import & export"],
];

const FOR_POSES: readonly (readonly [Tab, string])[] = [
  ["pose", "Joints"],
  ["history", "History"],
];
const TABS = { expression: FOR_EXPRESSIONS, face: FOR_FACES, pose: FOR_POSES } as const;

const style = css`
  :host {
    display: grid;
    grid-template-rows: auto minmax(0, 1fr);
    min-height: 0;
  }
  [role="tablist"] {
    display: grid;
    grid-template-columns: repeat(auto-fit, minmax(88px, 1fr));
    gap: 2px;
    padding: 6px;
    border-bottom: 1px solid var(--line);
  }
  [role="tab"] {
    padding: 0 4px;
    font-size: 12.5px;
  }
  [role="tab"][aria-selected="true"] {
    background: var(--raised);
    color: var(--text);
    border-color: var(--edge);
  }
  .inside {
    overflow: hidden auto;
    scrollbar-width: thin;
    scrollbar-color: var(--edge) transparent;
    min-height: 0;
  }
  .welcome {
    display: block;
    padding: 16px 18px;
  }
  .welcome ol {
    margin: 10px 0 0;
    padding: 0 0 0 18px;
    list-style: decimal;
    display: grid;
    gap: 14px;
    color: var(--dim);
    font-size: 14px;
  }
  .welcome b {
    color: var(--text);
  }
  .welcome .row {
    margin-top: 6px;
  }
`;

/** What the open item is made of, one side of it at a time. */
@customElement("omote-panels")
export class Panels extends EditorElement {
  @state() private tab: Tab = "layers";
  /** What was open last. */
  #open: { item: number; kind: Kind } | null = null;

  static override styles = [base, controls, style];

  protected override readonly topics: readonly Topic[] = ["draft", "items"];

  /** Something new, or something of another kind, is seen from the beginning: what it is made of. */
  override willUpdate(): void {
    const { draft, item } = this.store;
    const now = draft === null ? null : { item: draft.item, kind: draft.recipe.kind };
    const other = now !== null && now.item !== this.#open?.item;
    if (other && (now.kind !== this.#open?.kind || item?.head === 0)) this.tab = TABS[now.kind][0]?.[0] ?? "layers";
    this.#open = now ?? this.#open;
  }

  override render() {
    const { store, context } = this;
    if (store.draft === null && store.opening !== "")
      return html`<section class="welcome" role="status"><h2>"${store.opening}" is being opened ...</h2></section>`;
    if (store.draft === null) return this.#welcome();
    const tabs = TABS[store.draft.recipe.kind];
    const tab = tabs.some(([name]) => name === this.tab) ? this.tab : (tabs[0] as (typeof tabs)[0])[0];
    return html`
      <div role="tablist" aria-label="Made of" @keydown=${this.#roam}>
        ${tabs.map(
          ([name, label]) => html`<button role="tab" id=${name} data-tab=${name} aria-selected=${name === tab}
            aria-controls="inside" tabindex=${name === tab ? 0 : -1} @click=${() => this.show(name)}>${label}</button>`,
        )}
      </div>
      <div class="inside" id="inside" role="tabpanel" aria-labelledby=${tab}>${PANELS[tab](context)}</div>
    `;
  }

  /** How to begin, where later stands what the open item is made of. Tells `make` with the kind of something new. */
  #welcome() {
    const make = (kind: Kind) => () => this.dispatchEvent(new CustomEvent("make", { detail: kind }));
    return html`<section class="welcome" aria-label="How to begin">
      <h2>How to begin</h2>
      <ol>
        <li><b>Pick or make an expression</b> in the library, or here:
          <div class="row">
            <button class="main" @click=${make("expression")}>New expression</button>
            <button @click=${make("face")}>New face</button>
            <button @click=${make("pose")}>New pose</button>
          </div></li>
        <li><b>Drag a white pin</b> (a needle): they stand on the large face as soon as something is open. The other faces follow while you drag.</li>
        <li><b>Save.</b> From then on the console can play it, on every face.</li>
      </ol>
      <omote-exchange .context=${this.context}></omote-exchange>
    </section>`;
  }

  show(tab: Tab): void {
    this.tab = tab;
  }

  /** Arrows go from tab to tab, as everywhere. */
  readonly #roam = (event: KeyboardEvent): void => {
    const by = event.key === "ArrowRight" ? 1 : event.key === "ArrowLeft" ? -1 : 0;
    if (by === 0) return;
    event.preventDefault();
    const tabs = [...this.renderRoot.querySelectorAll<HTMLElement>("[role=tab]")];
    const at = tabs.findIndex((tab) => tab.dataset.tab === (event.target as HTMLElement).dataset.tab);
    const next = tabs[(at + by + tabs.length) % tabs.length];
    next?.click();
    next?.focus();
  };
}

type Context = EditorElement["context"];
const PANELS: Readonly<Record<Tab, (context: Context) => unknown>> = {
  layers: (context) => html`<omote-layers .context=${context}></omote-layers>`,
  muscles: (context) => html`<omote-muscles .context=${context}></omote-muscles>`,
  points: (context) => html`<omote-points .context=${context}></omote-points>`,
  eyes: (context) => html`<omote-eyes .context=${context}></omote-eyes>`,
  skin: (context) => html`<omote-complexion .context=${context}></omote-complexion>`,
  recipe: (context) => html`<omote-recipe .context=${context}></omote-recipe>`,
  look: (context) => html`<omote-look .context=${context}></omote-look>`,
  pose: (context) => html`<omote-pose-words .context=${context}></omote-pose-words>`,
  history: (context) => html`<omote-history .context=${context}></omote-history>`,
  exchange: (context) => html`<omote-exchange .context=${context}></omote-exchange>`,
};
