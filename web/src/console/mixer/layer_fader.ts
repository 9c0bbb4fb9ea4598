/** The fader of a layer's influence: on the whole, or on one part of the character. */

import { css, html } from "lit";
import { customElement, property, query } from "lit/decorators.js";
import { LAYER_PARTS } from "../../link/constants";
import { base } from "../../ui/theme";
import { FaderElement } from "../controls/fader";
import { faderStyle } from "../controls/fader_style";
import { otherStyle, paintOther } from "../controls/other_hand";
import type { Knob } from "../store/knob";
import { firstInfluence, type LayerName, type LayerPart, layerOf } from "../store/layer_state";
import { LayerCommands } from "./layer_commands";

const style = css`
  .number {
    color: var(--dim);
  }
  .share {
    position: absolute;
    left: 50%;
    width: 4px;
    margin-left: -2px;
    bottom: 0;
    height: 100%;
    transform-origin: bottom;
    transform: scaleY(0);
    background: var(--air);
  }
`;

/** 0..1; the red column beside the whole is how much of the layer is on air. */
@customElement("omote-layer-fader")
export class LayerFader extends FaderElement {
  @property() layer: LayerName = "emotion";
  /** `null`: the whole. */
  @property({ attribute: false }) region: LayerPart | null = null;
  @query(".share") private share!: HTMLElement;

  static override styles = [base, faderStyle, style, otherStyle];

  override render() {
    const what = this.region === null ? "" : `, ${this.region}`;
    return html`<div class="number"></div>
      <div class="slot" role="slider" tabindex="0" aria-orientation="vertical" aria-valuemin="0" aria-valuemax="1"
        aria-label="Influence of ${this.layer}${what}" data-layer=${this.layer} data-part=${this.region ?? ""}>
        <div class="groove"></div>
        <div class="share"></div>
        <div class="carrier"></div>
        <span class="other"></span>
      </div>`;
  }

  protected override get knob(): Knob {
    return this.store.layer(this.layer, this.region);
  }

  /** As at first. */
  protected override rest(): void {
    if (this.region === null) new LayerCommands(this.store).reset(this.layer);
    else this.knob.nudge(firstInfluence(this.layer)[LAYER_PARTS.indexOf(this.region)] ?? 1);
  }

  paint(now: number): void {
    const { air } = this.store;
    if (air === null || this.offsetParent === null) return;
    const { write } = this;
    const influence = this.knob.value(now);
    write.style(this.carrier, "transform", `translateY(${-100 * influence}%)`);
    write.text(this.number, String(Math.round(100 * influence)));
    write.attribute(this.slotElement, "aria-valuenow", influence.toFixed(2));
    const share = this.region === null ? layerOf(air, this.layer).share : 0;
    write.style(this.share, "transform", `scaleY(${share.toFixed(3)})`);
    paintOther(write, this.other, this.store, this.knob, now);
  }
}
