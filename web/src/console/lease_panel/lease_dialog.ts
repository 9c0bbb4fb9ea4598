/** The leases over the console: the switch, who is here, and who holds what. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import type { SeatState } from "../../link/messages";
import { closeOutside, curtainBelowBar } from "../../ui/dialog_style";
import { layerWhileShown } from "../../ui/key_presses";
import { base } from "../../ui/theme";
import { ConsoleElement } from "../controls/console_element";
import { CHARACTER_PARTS, heldByOthers, type Part, SCENE_PARTS } from "../leases/held_parts";
import { waited, wanting } from "../leases/lease_wishes";
import type { Topic } from "../store/page_store";
import { seatStyle } from "./seat_style";

/** All leases of the show. Tells `close`. */
@customElement("omote-lease-dialog")
export class LeaseDialog extends ConsoleElement {
  static override styles = [
    base,
    curtainBelowBar,
    seatStyle,
    css`
      section {
        width: min(640px, 100%);
        max-height: 100%;
        overflow: auto;
        padding: 14px 16px;
        display: grid;
        gap: 8px;
      }
      p {
        margin: 0;
        color: var(--dim);
      }
      .row {
        display: flex;
        flex-wrap: wrap;
        align-items: center;
        gap: 6px;
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
    `,
  ];

  constructor() {
    super();
    closeOutside(this, this.#close);
    layerWhileShown(this, "dialog", this.#close);
  }

  protected override topics(): readonly Topic[] {
    return ["leases", "characters", "link"];
  }

  override firstUpdated(): void {
    this.renderRoot.querySelector("button")?.focus();
  }

  override render() {
    const { leases } = this.context;
    return html`<section class="panel" role="dialog" aria-modal="true" aria-label="Leases">
      <h2>Leases</h2>
      ${this.#switch()}
      ${leases.told.on ? this.#lists() : nothing}
      <div class="row">
        ${leases.mine.length > 0 ? html`<button data-do="release" @click=${() => leases.releaseAll()}>Release all that is yours</button>` : nothing}
        ${leases.isManager ? html`<button data-do="all" @click=${() => leases.takeAll()}>Take over everything</button>` : nothing}
        <button class="close" @click=${this.#close}>Close</button>
      </div>
    </section>`;
  }

  #switch() {
    const { told, isManager, manager } = this.context.leases;
    const barred = told.on && !isManager && manager !== null;
    const says = told.on
      ? "The first touch of a part makes it yours until you release it, leave, or another takes it over."
      : "Off: whoever touches a control last has it. On: whoever touches a part first.";
    return html`<p>${says}</p>
      <div class="row">
        <button role="switch" aria-checked=${told.on} ?disabled=${barred} title=${barred ? `${manager.name} is the stage manager, who alone switches leases off` : nothing}
          @click=${() => this.context.leases.switch(!told.on)}>Leases ${told.on ? "on" : "off"}</button>
        ${told.on && manager === null ? html`<button data-do="manage" @click=${() => this.context.leases.switch(true)}>Become stage manager</button>` : nothing}
      </div>`;
  }

  #lists() {
    const characters = Object.entries(this.store.state?.characters ?? {});
    return html`<h2>Seats</h2>
      ${this.context.leases.told.seats.map((seat) => this.#seat(seat))}
      <h2>Who holds what</h2>
      <p>Press a free part to hold it, your own to release it, another's to take it over.</p>
      ${characters.map(([name, { label }]) => this.#parts(label, name, CHARACTER_PARTS))}
      ${this.#parts("Scene", "*", SCENE_PARTS)}`;
  }

  #seat(seat: SeatState) {
    const { told, isManager } = this.context.leases;
    const words = [
      seat.number === told.you ? "you" : "",
      seat.manager ? "stage manager" : "",
      seat.here ? "" : "link lost: what it holds is free soon",
    ];
    const said = words.filter((word) => word !== "").join(", ");
    return html`<div class="row seat" data-seat=${seat.name}>
      <span class="colour" style="background:${seat.colour}"></span><b>${seat.name}</b> ${said}
      ${isManager && !seat.manager && seat.here ? html`<button @click=${() => this.context.leases.appoint(seat.number)}>Make stage manager</button>` : nothing}
    </div>`;
  }

  #parts(title: string, character: string, parts: readonly Part[]) {
    return html`<div class="row" role="group" aria-label=${title}><b>${title}</b>
      ${parts.map((part) => this.#part(`${character}/${part}`, part))}</div>`;
  }

  #part(key: string, part: Part) {
    const { leases } = this.context;
    const holder = leases.told.held[key] ?? heldByOthers(leases.told, [key]).get(key);
    const own = holder?.number === leases.told.you;
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
    const wishes = wanting(this.context.leases.told, key);
    return wishes.map(({ by, seconds }) => html`<small>wanted by ${by.name}, ${waited(seconds)}</small>`);
  }

  readonly #close = (): void => {
    this.dispatchEvent(new CustomEvent("close"));
  };
}
