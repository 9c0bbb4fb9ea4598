/** The leases over the console: the switch, who is here, and who holds what. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import type { SeatState } from "../../link/messages";
import { base } from "../../ui/theme";
import { ConsoleDialog, sheet } from "../controls/console_dialog";
import type { Topic } from "../store/page_store";
import { CHARACTER_PARTS, heldByOthers, type LeasePart, SCENE_PARTS } from "./held_parts";
import { waited, wanting } from "./lease_wishes";
import { seatStyle } from "./seat_style";

const style = css`
  section {
    width: min(640px, 100%);
  }
  .seat {
    min-height: 30px;
  }
  .seat b {
    color: var(--text);
  }
  .part {
    display: flex;
    align-items: center;
    gap: 6px;
    min-height: 34px;
  }
  .part.held {
    color: var(--text);
    border: 2px solid var(--seat);
  }
  @media (pointer: coarse) {
    button {
      min-height: 44px;
    }
  }
`;

/** All leases of the show. Tells `close`. */
@customElement("omote-lease-dialog")
export class LeaseDialog extends ConsoleDialog {
  static override styles = [base, sheet, seatStyle, style];

  protected override readonly topics: readonly Topic[] = ["leases", "characters", "link"];

  override render() {
    const { leases } = this.context;
    return html`<section class="panel" role="dialog" aria-modal="true" aria-label="Leases">
      <h2>Leases</h2>
      ${this.#switch()}
      ${leases.report.on ? this.#lists() : nothing}
      <div class="row">
        ${leases.mine.length > 0 ? html`<button data-do="release" @click=${() => leases.releaseAll()}>Release all that is yours</button>` : nothing}
        ${leases.isManager ? html`<button data-do="all" @click=${() => leases.takeAll()}>Take over everything</button>` : nothing}
        <button class="close" @click=${this.close}>Close</button>
      </div>
    </section>`;
  }

  #switch() {
    const { report, isManager, manager } = this.context.leases;
    const { barred: role } = this.context.leases;
    const other = report.on && !isManager && manager !== null;
    const why = role ?? (other ? `${manager.name} is the stage manager, who alone switches leases off` : null);
    const says = report.on
      ? "The first touch of a part makes it yours until you release it, leave, or another takes it over."
      : "Off: whoever touches a control last has it. On: whoever touches a part first.";
    return html`<p>${says}</p>
      <div class="row">
        <button role="switch" aria-checked=${report.on} ?disabled=${why !== null} title=${why ?? nothing}
          @click=${() => this.context.leases.switch(!report.on)}>Leases ${report.on ? "on" : "off"}</button>
        ${role === null ? nothing : html`<p>${role}</p>`}
        ${report.on && manager === null && role === null ? html`<button data-do="manage" @click=${() => this.context.leases.switch(true)}>Become stage manager</button>` : nothing}
      </div>`;
  }

  #lists() {
    const characters = Object.entries(this.store.state?.characters ?? {});
    return html`<h2>Seats</h2>
      ${this.context.leases.report.seats.map((seat) => this.#seat(seat))}
      <h2>Who holds what</h2>
      <p>Press a free part to hold it, your own to release it, another's to take it over.</p>
      ${characters.map(([name, { label }]) => this.#parts(label, name, CHARACTER_PARTS))}
      ${this.#parts("Scene", "*", SCENE_PARTS)}`;
  }

  #seat(seat: SeatState) {
    const { report, isManager } = this.context.leases;
    const words = [
      seat.number === report.you ? "you" : "",
      seat.manager ? "stage manager" : "",
      seat.here ? "" : "link lost: what it holds is free soon",
    ];
    const said = words.filter((word) => word !== "").join(", ");
    return html`<div class="row seat" data-seat=${seat.name}>
      <span class="colour" style="background:${seat.colour}"></span><b>${seat.name}</b> ${said}
      ${isManager && !seat.manager && seat.here ? html`<button @click=${() => this.context.leases.appoint(seat.number)}>Make stage manager</button>` : nothing}
    </div>`;
  }

  #parts(title: string, character: string, parts: readonly LeasePart[]) {
    return html`<div class="row" role="group" aria-label=${title}><b>${title}</b>
      ${parts.map((part) => this.#part(`${character}/${part}`, part))}</div>`;
  }

  #part(key: string, part: LeasePart) {
    const { leases } = this.context;
    const holder = leases.report.held[key] ?? heldByOthers(leases.report, [key]).get(key);
    const own = holder?.number === leases.report.you;
    const [says, does] =
      holder === undefined ? ["free", "hold it"] : own ? ["you", "release it"] : [holder.name, "take it over"];
    return html`<button class="part ${holder === undefined ? "" : "held"}" data-key=${key} style="--seat:${holder?.colour ?? "none"}"
      aria-label="${leases.words(key)}: ${says}; ${does}" title=${does}
      @click=${() => (own ? leases.release([key]) : holder === undefined ? leases.hold([key]) : leases.takeOver([key]))}>
      ${holder === undefined ? nothing : html`<span class="colour" style="background:${holder.colour}"></span>`}${part}: ${says}${this.#wanting(key)}
    </button>`;
  }

  /** Who wants a part, and for how long. */
  #wanting(key: string) {
    const wishes = wanting(this.context.leases.report, key);
    return wishes.map(({ by, seconds }) => html`<small>wanted by ${by.name}, ${waited(seconds)}</small>`);
  }
}
