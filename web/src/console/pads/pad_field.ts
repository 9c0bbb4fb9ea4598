/** What a pad looks like, played or edited: the fields of its looks in colour, and each look's picture at its place. */

import { html, nothing } from "lit";
import { property, query, queryAll, state } from "lit/decorators.js";
import type { PadLook } from "../../link/messages";
import { THUMBNAIL_SIZE, type ThumbnailSubject } from "../../ui/thumbnails";
import { AnimatedElement } from "../controls/console_element";
import { ModelFace } from "../palette/model_face";
import { PAD_AXES, type PadAxis } from "../store/knob";
import type { Topic } from "../store/page_store";
import { type PadPlace, softBands } from "./blend_space";
import { drawFields, lookColour } from "./pad_colours";
import { heaviest, kindOf, PART_WORDS, type PadContent, restOf } from "./pad_layout";

/** Of a field's width: what lies around the way of the point, so that pictures at its ends have room. */
const MARGIN = 0.1;

/** Where a place from -1 to 1 lies across a field, 0..1. */
export const across = (at: number): number => MARGIN + ((1 - 2 * MARGIN) * (at + 1)) / 2;
/** The place from -1 to 1 at a part of a field; beyond its ends in the margin. */
export const placeAt = (part: number): number => (2 * (part - MARGIN)) / (1 - 2 * MARGIN) - 1;
/** How far a place moves where a pointer crosses a part of the field. */
export const wayOf = (part: number): number => (2 * part) / (1 - 2 * MARGIN);

export abstract class PadFieldElement extends AnimatedElement {
  @property({ attribute: false }) pad!: PadContent & { readonly missing?: readonly string[] };
  /** The face that expressions are shown on. */
  @state() private model = "generic";
  @query(".field") protected field!: HTMLElement;
  @query(".fields") private fields!: HTMLCanvasElement;
  @queryAll(".look") protected pictures!: NodeListOf<HTMLElement>;
  readonly #model = new ModelFace("generic");
  #drawn = "";

  protected override readonly topics: readonly Topic[] = ["manifest", "link"];

  /** What stands on it now: of a look that is dragged the newest place. */
  protected get looks(): readonly PadLook[] {
    return this.pad.looks;
  }

  get axes(): readonly PadAxis[] {
    return PAD_AXES.slice(0, this.pad.dimensions);
  }

  /** Where the field is cut that is shown, of a pad with three dimensions. */
  protected abstract depth(now: number): number;

  /** How much of each look shows at a point. */
  weightsAt(point: PadPlace): number[] {
    return softBands(
      this.looks.map(({ place }) => place),
      point,
    );
  }

  /** The looks that show at a point, heaviest first, in per cent. */
  protected wordsAt(point: PadPlace): string {
    return this.weightsAt(point)
      .map((weight, at) => [Math.round(100 * weight), this.looks[at]?.label] as const)
      .filter(([percent]) => percent > 0)
      .sort(([x], [y]) => y - x)
      .slice(0, 3)
      .map(([percent, label]) => `${label} ${percent}`)
      .join(" · ");
  }

  protected heading() {
    const { name, part } = this.pad;
    return html`<h2 title=${name}>${name}</h2><span class="part">${PART_WORDS[part]}</span>`;
  }

  protected picture(look: PadLook, at: number) {
    const name = heaviest(look);
    const missing = Object.keys(look.mix).filter((each) => this.pad.missing?.includes(each));
    const [red, green, blue] = lookColour(at, this.#rests(look));
    const lost = missing.length === 0 ? "" : `: the cast has no ${missing.join(", ")}`;
    return html`<div class="look ${lost === "" ? "" : "lost"}" data-at=${at} data-name=${name} title="${look.label}${lost}"
      style="left:${100 * across(look.place[0] as number)}%;top:${this.pad.dimensions === 1 ? 50 : 100 * (1 - across(look.place[1] as number))}%;--look-colour:rgb(${red} ${green} ${blue})">
      <canvas width=${THUMBNAIL_SIZE.width} height=${THUMBNAIL_SIZE.height} aria-hidden="true"></canvas><span>${look.label}</span></div>`;
  }

  /** The field without what is on it. */
  protected get ground() {
    return html`<canvas class="fields" width="1" height="1" aria-hidden="true"></canvas>`;
  }

  protected get depthSlider() {
    return this.pad.dimensions < 3
      ? nothing
      : html`<div class="depth" role="slider" tabindex="0" aria-label="${this.pad.name}, third dimension" aria-valuemin="-1" aria-valuemax="1" aria-valuenow="0" title="The third dimension of the pad"><div class="carrier knob"></div></div>`;
  }

  #rests({ mix }: PadLook): boolean {
    return (mix[restOf(this.pad.part)] ?? 0) > 0.999;
  }

  override updated(): void {
    this.classList.toggle("line", this.pad.dimensions === 1);
    for (const picture of this.pictures) this.#ask(picture);
  }

  #ask(picture: HTMLElement): void {
    const { name = "" } = picture.dataset;
    this.context.thumbnails.ask(picture.querySelector("canvas") as HTMLCanvasElement, this.#subject(name));
  }

  /** What the picture of a look shows of which this name weighs most. */
  #subject(name: string): ThumbnailSubject {
    const kind = kindOf(this.pad.part);
    const face = this.store.faces.find((each) => each.name === this.model)?.source ?? this.model;
    if (kind === "pose") return { face, expression: "neutral", pose: name };
    const all = kind === "face" ? this.store.faces : this.store.expressions;
    const source = all.find((each) => each.name === name)?.source ?? restOf(this.pad.part);
    return kind === "face" ? { face: source, expression: "neutral" } : { face, expression: source };
  }

  paint(now: number): void {
    if (this.offsetParent === null) return;
    if (this.pad.part !== "face")
      this.model = this.#model.follow(this.store.air?.faces ?? {}, this.store.callOf("face")?.target ?? null, now);
    this.#paintFields(now);
    this.paintHands(now);
  }

  protected abstract paintHands(now: number): void;

  #paintFields(now: number): void {
    const depth = this.pad.dimensions < 3 ? 0 : Math.round(20 * this.depth(now)) / 20;
    const places = this.looks.map(({ place }) => place);
    const key = JSON.stringify([places, depth]);
    if (key === this.#drawn) return;
    this.#drawn = key;
    const colours = this.looks.map((look, at) => lookColour(at, this.#rests(look)));
    drawFields(this.fields, places, colours, depth);
    if (this.pad.dimensions < 3) return;
    for (const [at, picture] of [...this.pictures].entries()) // what lies in another depth is seen to
      this.write.style(picture, "--near", (1 - Math.abs((places[at]?.[2] ?? 0) - depth) / 2.5).toFixed(2));
  }
}
