/** The operator's own seat in the bar: colour, name, and how much it holds; opens the list of leases. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { base, ellipsis } from "../../ui/theme";
import { ConsoleElement } from "../controls/console_element";
import type { Topic } from "../store/page_store";
import { seatStyle } from "./seat_style";

const style = css`
  button {
    display: flex;
    align-items: center;
    gap: 6px;
    max-width: 190px;
    min-height: 34px;
    color: var(--text);
    text-align: left;
  }
  small {
    display: block;
    font-size: 10px;
    color: var(--dim);
  }
  .words,
  .name {
    min-width: 0;
    ${ellipsis}
  }
  .words {
    display: var(--words, block); /* a bar that asks something has no room for them */
  }
  .initials {
    display: none;
    font-weight: 700;
    color: #000;
  }
  @media (pointer: coarse) {
    button {
      min-height: var(--finger, 34px);
    }
  }
  /* messages need the room: the first letters of the name, on its colour */
  @media (max-width: 899px) {
    button {
      justify-content: center;
      width: 34px;
      padding: 0;
      background: var(--seat);
    }
    .colour,
    .words {
      display: none;
    }
    .initials {
      display: block;
    }
  }
`;

/** The seat of this console, while leases are on. Tells `leases`. */
@customElement("omote-seat")
export class SeatKey extends ConsoleElement {
  static override styles = [base, seatStyle, style];

  protected override readonly topics: readonly Topic[] = ["leases", "welcome"];

  override render() {
    const { report, seat, isManager, mine } = this.context.leases;
    if (!report.on || seat === null) return nothing;
    const role = isManager ? "stage manager" : "your seat";
    const holds = mine.length === 0 ? "holds nothing" : `holds ${mine.length}`;
    return html`<button aria-label="Leases: you are ${seat.name}, ${role}, ${holds}" title="Leases: who holds what (,)" style="--seat:${seat.colour}"
      @click=${() => this.tell("leases")}>
      <span class="colour" style="background:${seat.colour}"></span>
      <span class="initials" aria-hidden="true">${initialsOf(seat.name)}</span>
      <span class="words"><span class="name">${seat.name}</span><small>${role}, ${holds}</small></span>
    </button>`;
  }
}

/** The first letters of the first words of a name: two at most. */
const initialsOf = (name: string): string =>
  name
    .split(/\s+/)
    .slice(0, 2)
    .map((word) => [...word][0] ?? "")
    .join("")
    .toUpperCase();
