/** Frames over the panels of what somebody holds: the holder's colour, and the name in words, which takes or releases. */

import { css, html } from "lit";
import { customElement, property, state } from "lit/decorators.js";
import { base, ellipsis } from "../../ui/theme";
import { AnimatedElement } from "../controls/console_element";
import { heldByOthers, type LeasePart } from "./held_parts";

/** The panels of the page, and the parts that each plays; where that is one strip of a panel, which. */
const PANELS: readonly (readonly [string, readonly LeasePart[], string?])[] = [
  [".faces", ["face"]],
  [".facebar", ["face"]],
  [".expressions", ["expression"]],
  [".exprbar", ["expression"]],
  ["omote-bank", ["channels"]],
  [".hands omote-pad", ["head"]],
  [".hands omote-pad + omote-pad", ["gaze"]],
  ["omote-pad-panel", ["expression", "face"]],
  ["omote-lights", ["light"]],
  ["omote-lights", ["black"], ".black"],
  ["omote-scene-panel", ["place", "framing"]],
  ["omote-layer-panel", ["expression"], "[data-layer=emotion]"],
  ["omote-layer-panel", ["gaze"], "[data-layer=gaze]"],
  ["omote-layer-panel", ["channels"], "[data-layer=hands]"],
];
/** Milliseconds between two looks at where panels are. */
const PACE = 200;

/** What a panel's frame shows. */
interface Mark {
  readonly place: string;
  readonly colour: string;
  readonly name: string;
  readonly others: readonly string[];
  readonly own: readonly string[];
}

const style = css`
  :host {
    position: fixed;
    inset: 0;
    z-index: 5;
    pointer-events: none;
  }
  .frame {
    position: absolute;
    border: 2px solid var(--seat);
    border-radius: 6px;
  }
  button {
    position: absolute;
    top: -9px;
    left: 4px;
    max-width: calc(100% - 8px);
    min-height: 0;
    height: 16px;
    padding: 0 5px;
    border: 1px solid #000;
    border-radius: 3px;
    font-size: 11px;
    font-weight: 600;
    line-height: 14px;
    ${ellipsis}
    color: #000;
    background: var(--seat);
    pointer-events: auto;
  }
  @media (hover: hover) {
    button:hover {
      color: #000;
      background: #fff;
    }
  }
  @media (pointer: coarse) {
    button {
      height: 20px;
      min-height: 20px;
      top: -13px;
      line-height: 18px;
    }
  }
`;

/** A frame and a name over each panel that somebody holds; `page`: where the panels are. */
@customElement("omote-lease-marks")
export class LeaseMarks extends AnimatedElement {
  @property({ attribute: false }) page!: ParentNode;
  @state() private marks: readonly Mark[] = [];
  #looked = 0;

  static override styles = [base, style];

  override render() {
    return this.marks.map((mark) => this.#frame(mark));
  }

  #frame({ place, colour, name, others, own }: Mark) {
    const { leases } = this.context;
    const foreign = others.length > 0;
    const does = foreign ? "take over" : "release";
    const what = (foreign ? others : own).map((key) => leases.words(key)).join(", ");
    return html`<div class="frame" style="${place};--seat:${colour}">
      <button title="${does} ${what}" aria-label="${foreign ? name : "You"}: ${does} ${what}"
        @click=${() => (foreign ? leases.offer(heldByOthers(leases.report, others)) : leases.release(own))}>${name}</button>
    </div>`;
  }

  paint(now: number): void {
    const { on } = this.context.leases.report;
    if ((!on && this.marks.length === 0) || now - this.#looked < PACE) return;
    this.#looked = now;
    const marks = on
      ? PANELS.flatMap(([selector, parts, strip]) => this.#look(this.#panel(selector, strip), parts))
      : [];
    if (JSON.stringify(marks) !== JSON.stringify(this.marks)) this.marks = marks;
  }

  #panel(selector: string, strip?: string): Element | null {
    const panel = this.page.querySelector(selector);
    return strip === undefined ? panel : (panel?.shadowRoot?.querySelector(strip) ?? null);
  }

  /** The mark of a panel; none where it is not shown, or nobody holds its parts. */
  #look(panel: Element | null, parts: readonly LeasePart[]): readonly Mark[] {
    const { leases } = this.context;
    const others = new Map(parts.flatMap((part) => [...leases.others(part)]));
    const own = parts.flatMap((part) => leases.own(part));
    const colour = [...others.values()][0]?.colour ?? leases.seat?.colour;
    const box = panel?.getBoundingClientRect();
    if (box === undefined || box.width === 0 || colour === undefined || others.size + own.length === 0) return [];
    const place = `left:${box.left}px;top:${box.top}px;width:${box.width}px;height:${box.height}px`;
    const names = new Set([...others.values()].map(({ name }) => name));
    const name = [...names, ...(own.length > 0 ? ["you"] : [])].join(", ");
    return [{ place, colour, name: names.size > 0 ? name : "you ✕", others: [...others.keys()], own }];
  }
}
