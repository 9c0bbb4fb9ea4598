/** The panel of an item's revisions. */

import { css, html, nothing } from "lit";
import { customElement, state } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import type { RevisionDocument } from "../../link/editing_messages";
import { base } from "../../ui/theme";
import { controls, panel } from "../controls/controls_style";
import { EditorElement } from "../controls/editor_element";
import type { Topic } from "../session/draft_store";
import { askHistory, bringBack } from "../session/item_commands";
import type { ComparedContent } from "./comparison";
import "./comparison";

const style = css`
  li.card.shown {
    border-color: var(--attention);
  }
  b {
    color: var(--text);
  }
  .aside {
    color: var(--attention);
  }
  .plays {
    color: var(--coming);
  }
  omote-comparison {
    pointer-events: auto;
  }
`;

/** Every save of the open item: to look at, to compare, to bring back. */
@customElement("omote-history")
export class HistoryPanel extends EditorElement {
  @state() private compared: readonly [ComparedContent, ComparedContent] | null = null;
  #asked = -1;

  static override styles = [base, controls, panel, style];

  protected override readonly topics: readonly Topic[] = ["history", "draft", "items"];

  override willUpdate(): void {
    const open = this.store.draft?.item ?? -1;
    if (open >= 0 && open !== this.#asked) askHistory(this.store);
    this.#asked = open;
  }

  override render() {
    const newest = this.store.revisions.toReversed();
    return html`
      <p>Every save is kept. Look at one, compare it with your draft, bring it back.</p>
      ${newest.length === 0 ? html`<p class="note">Not saved yet.</p>` : nothing}
      <ol>
        ${repeat(
          newest,
          ({ number }) => number,
          (revision) => this.#revision(revision),
        )}
      </ol>
      ${
        this.compared === null
          ? nothing
          : html`<omote-comparison .context=${this.context} .sides=${this.compared}
              @close=${() => (this.compared = null)}></omote-comparison>`
      }
    `;
  }

  #revision(revision: RevisionDocument) {
    const { number, written, editor, note, aside, content } = revision;
    const looked = this.store.look === content;
    const when = new Date(written * 1000).toLocaleString([], { dateStyle: "medium", timeStyle: "short" });
    return html`<li class="card ${looked ? "shown" : ""}" data-revision=${number}>
      <div class="row"><b>${number}</b><span class="grow">${when}</span><span>${editor}</span></div>
      ${note === "" ? nothing : html`<span>“${note}”</span>`}
      ${aside ? html`<span class="aside">aside: saved after another's, never played</span>` : nothing}
      ${number === this.store.item?.head ? html`<span class="plays">this one plays</span>` : nothing}
      <div class="row">
        <button aria-pressed=${looked} title="Shows it instead of your draft"
          @click=${() => this.store.setLook(looked ? null : content)}>Look</button>
        <button title="A picture of how it differs from your draft" @click=${() => this.#compare(revision)}>Compare</button>
        <button title="Makes it the newest step of your draft; Save makes it play"
          @click=${() => void bringBack(this.store, revision)}>Bring back</button>
      </div>
    </li>`;
  }

  #compare({ number, content }: RevisionDocument): void {
    const { draft } = this.store;
    if (draft !== null)
      this.compared = [
        { content, label: `Revision ${number}` },
        { content: draft.content, label: "Your draft" },
      ];
  }
}
