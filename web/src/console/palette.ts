import { html, nothing } from "lit";
import { customElement, property, query, queryAll, state } from "lit/decorators.js";
import { repeat } from "lit/directives/repeat.js";
import type { ExpressionDocument, FaceDocument } from "../link/messages";
import { REGIONS, regionOf } from "./channels";
import type { Topic } from "./desk";
import { PaintedElement, Written } from "./element";
import { onRoam } from "./gesture";
import { type Axis, keyLabel } from "./keys";
import { style } from "./palette_style";
import { PICTURE, type Sitting } from "./portraits";
import { base } from "./theme";
import "./timing_row";

type Kind = "performed" | "arkit" | "makehuman";
const KINDS: readonly (readonly [Kind, string])[] = [
  ["performed", "Performed"],
  ["arkit", "ARKit"],
  ["makehuman", "MakeHuman"],
];
/** How long a face must be alone on air before the expressions are drawn anew on it, in milliseconds. */
const SETTLED = 800;

/** The faces or the expressions, as pictures: a tap calls one in the chosen time. */
@customElement("omote-palette")
export class Palette extends PaintedElement {
  @property() axis: Axis = "face";
  @state() private kind: Kind = "performed";
  @state() private search = "";
  /** The face that the expressions are shown on. */
  @state() private model = "generic";
  @query("input") private input!: HTMLInputElement | null;
  @queryAll(".tile") private tiles!: NodeListOf<HTMLElement>;
  readonly #written = new Written();
  #candidate: [string, number] = ["", 0];

  static override styles = [base, style];

  protected override topics(): readonly Topic[] {
    return ["cast"];
  }

  /** What the palette shows now, in order; its first nine have hot keys. */
  get shown(): readonly (FaceDocument | ExpressionDocument)[] {
    return this.axis === "face" ? this.desk.faces : this.#sections().flatMap(([, inside]) => inside);
  }

  /** The expressions under their headings: units by region; what is performed or searched needs none. */
  #sections(): [string, ExpressionDocument[]][] {
    const words = this.search.toLowerCase().split(/\s+/).filter(Boolean);
    if (words.length > 0)
      return [["", this.desk.expressions.filter((one) => words.every((word) => textOf(one).includes(word)))]];
    const inside = this.desk.expressions.filter((one) => this.#inTab(one));
    if (this.kind === "performed") return [["", inside]];
    const regions = REGIONS.map((region): [string, ExpressionDocument[]] => [
      region,
      inside.filter((one) => regionOf(one) === region),
    ]);
    return regions.filter(([, units]) => units.length > 0);
  }

  #inTab(one: ExpressionDocument): boolean {
    return one.kind === this.kind || (this.kind === "performed" && (one.kind === "neutral" || one.kind === "own"));
  }

  /** Calls the tile at an index, as its hot key does. */
  callIndex(index: number): void {
    const name = this.shown[index]?.name;
    if (name !== undefined) this.desk.call(this.axis, name);
  }

  override focus(): void {
    this.input?.focus();
  }

  override render() {
    return html`
      ${this.axis === "face" ? html`<header><h2>Faces</h2></header>` : this.#expressionHeader()}
      <div class="tiles">${this.#tiles()}</div>
      <omote-timing .rig=${this.rig} .axis=${this.axis}></omote-timing>
    `;
  }

  #expressionHeader() {
    return html`<header>
      <div class="tabs" role="tablist" aria-label="Kinds of expressions">
        ${KINDS.map(
          ([kind, label]) => html`<button
            role="tab"
            data-kind=${kind}
            aria-selected=${this.kind === kind && this.search === ""}
            @click=${() => {
              this.kind = kind;
              this.search = "";
            }}
          >
            ${label}
          </button>`,
        )}
      </div>
      <input
        type="search"
        placeholder="search /"
        aria-label="Search expressions by name or region"
        .value=${this.search}
        @input=${(event: Event) => {
          this.search = (event.target as HTMLInputElement).value;
        }}
      />
    </header>`;
  }

  #tiles() {
    const shown = this.shown;
    if (shown.length === 0 && this.search !== "")
      return html`<div class="none">Nothing is called "${this.search}".</div>`;
    const sections = this.axis === "face" ? [["", shown] as const] : this.#sections();
    return sections.map(
      ([heading, inside]) => html`${heading === "" ? nothing : html`<div class="region">${heading}</div>`}
        ${repeat(
          inside,
          (one) => one.name,
          (one) => this.#tile(one, shown.indexOf(one)),
        )}`,
    );
  }

  #tile(one: FaceDocument | ExpressionDocument, index: number) {
    const key = keyLabel(this.axis, index);
    return html`<button
      class="tile"
      data-name=${one.name}
      aria-label="${one.label}${key === null ? "" : `, key ${key}`}"
      title=${one.name}
      @click=${() => this.desk.call(this.axis, one.name)}
    >
      <canvas width="${PICTURE.width}" height="${PICTURE.height}" aria-hidden="true"></canvas>
      <span class="name">${one.label}</span>
      ${key === null ? nothing : html`<span class="key">${key}</span>`}
      <span class="weight"></span>
    </button>`;
  }

  override firstUpdated(): void {
    onRoam(this.renderRoot.querySelector(".tiles") as HTMLElement, ".tile");
  }

  override updated(): void {
    for (const tile of this.tiles) {
      const name = tile.dataset.name ?? "";
      const sitting: Sitting =
        this.axis === "face" ? { face: name, expression: "neutral" } : { face: this.model, expression: name };
      this.rig.portraits.ask(tile.querySelector("canvas") as HTMLCanvasElement, sitting);
    }
  }

  paint(now: number): void {
    const state = this.desk.state;
    const weights = (this.axis === "face" ? state?.faces : state?.expressions) ?? {};
    const target = this.desk.callOf(this.axis)?.target;
    for (const tile of this.tiles) {
      const name = tile.dataset.name ?? "";
      const weight = weights[name] ?? 0;
      this.#written.flag(tile, "coming", name === target);
      this.#written.flag(tile, "air", name !== target && weight >= 0.001);
      const bar = tile.lastElementChild as HTMLElement;
      this.#written.style(bar, "transform", `scaleX(${weight.toFixed(3)})`);
    }
    if (this.axis === "expression") this.#followModel(now);
  }

  /** The expressions are drawn on the face on air once it stands there alone for a while. */
  #followModel(now: number): void {
    const faces = Object.entries(this.desk.state?.faces ?? {}).filter(([, weight]) => weight > 0.999);
    const alone = this.desk.callOf("face") === null ? faces[0]?.[0] : undefined;
    if (alone === undefined || alone !== this.#candidate[0]) this.#candidate = [alone ?? "", now];
    else if (alone !== this.model && now - this.#candidate[1] > SETTLED) this.model = alone;
  }
}

const textOf = (one: ExpressionDocument): string =>
  `${one.name} ${one.label} ${one.kind} ${regionOf(one)}`.toLowerCase();
