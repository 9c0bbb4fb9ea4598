/** The poses of the figures as tiles of the palette, with pictures: a press calls one, of the whole figure or of a region; and bodies. */

import { css, html, nothing } from "lit";
import { customElement, property, queryAll, state } from "lit/decorators.js";
import { FACES_OWN, POSE_REGIONS } from "../../link/constants";
import type { PoseDocument } from "../../link/messages";
import { onRoam } from "../../ui/gestures";
import { base } from "../../ui/theme";
import { THUMBNAIL_SIZE } from "../../ui/thumbnails";
import { textOf } from "../../ui/topic_element";
import { AnimatedElement } from "../controls/console_element";
import { keyLabel } from "../store/keys";
import type { Topic } from "../store/page_store";
import type { PoseRegion } from "../store/region_calls";
import { LookCarry } from "./look_carry";
import { carryLook } from "./look_drag";
import { ModelFace } from "./model_face";
import { style as tiles } from "./palette_style";
import { bodiesOf, bodyOf, callBody, posesComing, posesFound, poseWeight } from "./pose_commands";

const WHOLE = "whole";
const REGION_LABELS: Readonly<Record<PoseRegion, string>> = {
  head: "head",
  trunk: "trunk",
  arm_left: "left arm",
  arm_right: "right arm",
  stance: "stance",
};

const style = css`
  :host {
    grid-area: tiles;
    grid-template: "tiles" minmax(0, 1fr) "means" auto / minmax(0, 1fr);
    gap: 6px;
    padding: 0;
  }
  .means {
    grid-area: means;
    display: flex;
    gap: 6px;
    min-width: 0;
  }
  .means label {
    display: flex;
    flex: 1 1 0;
    align-items: center;
    gap: 4px;
    min-width: 0;
    font-size: 12px;
    color: var(--dim);
  }
  .means select {
    flex: 1;
    min-width: 0;
  }
  .chosen {
    border-color: var(--hand);
    color: var(--hand);
  }
`;

@customElement("omote-pose-tiles")
export class PoseTiles extends AnimatedElement {
  @property() search = "";
  /** Where the next pose is called; null: of the whole figure. */
  @state() private region: PoseRegion | null = null;
  /** The face that poses are shown with. */
  @state() private model = "generic";
  @queryAll(".tile") private tiles!: NodeListOf<HTMLElement>;
  readonly #model = new ModelFace("generic");
  #body = "";

  static override styles = [base, tiles, style];

  protected override readonly topics: readonly Topic[] = ["manifest", "arrangement", "characters", "pad_edit"];

  override firstUpdated(): void {
    const list = this.renderRoot.querySelector(".tiles") as HTMLElement;
    onRoam(list, ".tile");
    new LookCarry(
      list,
      () => "pose",
      "omote-pad-editor",
      () => this.store.editedPad !== "",
    );
  }

  /** Calls the pose at an index of what is shown, as its hot key does. */
  callIndex(index: number): void {
    const pose = posesFound(this.store, "")[index];
    if (pose !== undefined) this.store.call("pose", pose.name, this.region);
  }

  /** Calls the pose that is found first; false where none is. */
  callFirst(): boolean {
    const [pose] = posesFound(this.store, this.search);
    if (pose !== undefined) this.store.call("pose", pose.name, this.region);
    return pose !== undefined;
  }

  override render() {
    const found = posesFound(this.store, this.search);
    const worn = bodyOf(this.store.air);
    return html`<div class="tiles">${found.map((pose, index) => this.#tile(pose, index))}
        ${found.length > 0 ? nothing : html`<div class="none">${this.search === "" ? "This cast has no figures." : `No pose is called "${this.search}".`}</div>`}</div>
      <div class="means">
        <label>Of<select class=${this.region === null ? "" : "chosen"} aria-label="Where poses are called" title="Where the next poses are called: the whole figure, or one region of it alone, in its own time"
          @change=${this.#choose}>
          ${[null, ...POSE_REGIONS].map((region) => html`<option value=${region ?? WHOLE} .selected=${region === this.region}>${region === null ? WHOLE : REGION_LABELS[region]}</option>`)}
        </select></label>
        <label>Body<select class=${worn === FACES_OWN ? "" : "chosen"} aria-label="Body" title="The body that is worn under the face, in the time of a face" @change=${(event: Event) => callBody(this.store, textOf(event))}>
          ${bodiesOf(this.store).map((name) => html`<option value=${name} .selected=${name === worn}>${name === FACES_OWN ? "the face's own" : name}</option>`)}
        </select></label>
      </div>`;
  }

  #tile({ name, label, source }: PoseDocument, index: number) {
    const key = this.search === "" ? keyLabel("expression", index) : null;
    return html`<button class="tile" data-name=${name} data-source=${source} aria-label="Pose ${label}${key === null ? "" : `, key ${key}`}" title=${name} draggable=${this.store.editedPad === "" ? "false" : "true"}
      @dragstart=${(event: DragEvent) => carryLook(event, "pose", name)} @click=${(event: MouseEvent) => this.#press(event, name)}>
      <canvas width=${THUMBNAIL_SIZE.width} height=${THUMBNAIL_SIZE.height} aria-hidden="true"></canvas>
      <span class="name">${label}</span>${key === null ? nothing : html`<span class="key">${key}</span>`}<span class="weight"></span></button>`;
  }

  readonly #choose = (event: Event): void => {
    const chosen = textOf(event);
    this.region = POSE_REGIONS.find((region) => region === chosen) ?? null;
    this.store.warnOfHand(this.region);
  };

  /** A tile that was clicked keeps no focus: the space bar would call it again. */
  #press(event: MouseEvent, name: string): void {
    this.store.call("pose", name, this.region);
    if (event.detail > 0) (event.currentTarget as HTMLElement).blur();
  }

  override updated(): void {
    const face = this.store.faces.find(({ name }) => name === this.model)?.source ?? this.model;
    for (const tile of this.tiles)
      this.context.thumbnails.ask(tile.querySelector("canvas") as HTMLCanvasElement, {
        face,
        expression: "neutral",
        pose: tile.dataset.source ?? "",
      });
  }

  paint(now: number): void {
    const { air } = this.store;
    const coming = posesComing(air);
    for (const tile of this.tiles) {
      const name = tile.dataset.name ?? "";
      const weight = poseWeight(air, name);
      this.write.flag(tile, "coming", coming.has(name));
      this.write.flag(tile, "air", !coming.has(name) && weight >= 0.001);
      this.write.style(tile.querySelector(".weight") as HTMLElement, "transform", `scaleX(${weight.toFixed(3)})`);
    }
    this.model = this.#model.follow(air?.faces ?? {}, this.store.callOf("face")?.target ?? null, now);
    const body = bodyOf(air);
    if (body !== this.#body) this.requestUpdate();
    this.#body = body;
  }
}
