/** How far the show is with a file that it takes in, and what stops it. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { progressWords } from "../../ui/long_requests";
import { base, ellipsis } from "../../ui/theme";
import { ConsoleElement } from "../controls/console_element";
import type { Topic } from "../store/page_store";

const style = css`
  :host {
    display: flex;
    align-items: center;
    gap: 8px;
    min-width: 0;
    padding: 0 6px;
    border-radius: 4px;
    background: var(--raised);
    font-size: 12px;
  }
  :host([idle]) {
    display: none;
  }
  span {
    min-width: 0;
    ${ellipsis}
  }
  button {
    flex: none;
  }
  @media (max-width: 899px) {
    progress {
      display: none; /* numbers say it */
    }
  }
  progress {
    flex: 0 0 64px;
    width: 64px;
    height: 8px;
    accent-color: var(--hand);
  }
`;

@customElement("omote-import-progress")
export class ImportProgress extends ConsoleElement {
  static override styles = [base, style];

  protected override readonly topics: readonly Topic[] = ["import"];

  override render() {
    const { running } = this.context.imports;
    this.toggleAttribute("idle", running === null);
    if (running === null) return nothing;
    const { file, waiting, request } = running;
    const words = request === null ? "..." : progressWords(request);
    const [done, total] = [request?.done ?? 0, request?.total ?? 0];
    return html`<span role="status" title="${file}: ${words}">${file}${waiting === 0 ? "" : ` and ${waiting} more`}: ${words}</span>
      <progress aria-label="Import of ${file}" max=${Math.max(1, total)} .value=${total === 0 ? null : done}></progress>
      <button ?disabled=${request?.ending === true} @click=${() => this.context.imports.cancel()}>Cancel</button>`;
  }
}
