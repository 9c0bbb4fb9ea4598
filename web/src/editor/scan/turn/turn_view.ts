/** A turn of the head before the webcam, as people see it: themselves as in a mirror, and the directions still wanted. */

import { html, LitElement, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { faceBox } from "../../../face_mesh/face_light";
import { openLandmarkWorker } from "../../../face_mesh/landmark_client";
import { drawLandmarks } from "../../../face_mesh/landmark_drawing";
import type { Landmarks } from "../../../face_mesh/landmark_messages";
import { base } from "../../../ui/theme";
import { textOf, whileShown } from "../../../ui/topic_element";
import { controls } from "../../controls/controls_style";
import { DIRECTIONS, type Direction, type DirectionName } from "./turn_directions";
import { TurnSession } from "./turn_session";
import { style } from "./turn_style";

/** Pixels a side of the picture in a mark. */
const MARK = 108;
const DEGREES = 180 / Math.PI;
/** Of the face's box, what a mark shows around it. */
const AROUND = 1.35;

/** Tells `use` with the pictures that were taken, files, or `leave`. */
@customElement("omote-turn")
export class TurnView extends LitElement {
  #session!: TurnSession;
  #using = false;

  static override styles = [base, controls, style];

  constructor() {
    super();
    whileShown(this, () => {
      this.#session = new TurnSession(openLandmarkWorker(), {
        changed: () => this.requestUpdate(),
        drawn: (landmarks) => this.#draw(landmarks),
        kept: (name, picture, points) => this.#show(name, picture, points),
        complete: () => void this.#use(),
      });
      void this.#session.start();
      return () => this.#session.end();
    });
  }

  override render() {
    const { sentence, faulty, model, trouble } = this.#session;
    const words = sentence === "" ? "Look straight into the camera, and be ready to turn your head." : sentence;
    return html`
      <figure>${this.#session.video}<canvas aria-hidden="true"></canvas>${this.#cover()}</figure>
      <div class="guide">
        <ol aria-label="Directions">${DIRECTIONS.map((direction) => this.#mark(direction))}</ol>
        <p class="sentence ${faulty ? "faulty" : ""}" role="status">${trouble === null && model.kind !== "failed" ? words : ""}</p>
      </div>
      ${this.#acts()}
    `;
  }

  /** What lies over the picture while there is none, or no model. */
  #cover() {
    const { trouble, model, device } = this.#session;
    if (trouble !== null)
      return html`<div class="cover" role="alert"><h2>${trouble.title}</h2><p>${trouble.advice}</p>
        <div class="row"><button @click=${() => this.#session.open(device)}>Try again</button>
        <omote-scan-button of="photographs"></omote-scan-button></div></div>`;
    if (model.kind === "failed")
      return html`<div class="cover" role="alert"><h2>The face model does not run here</h2>
        <p>${model.reason}. Load the page again, or choose photographs instead.</p></div>`;
    if (model.kind === "loading")
      return html`<div class="cover loading" role="status"><p>Loading the face model …</p>
        <progress aria-label="The face model" max="1" .value=${model.share}></progress></div>`;
    return nothing;
  }

  #mark({ name, yaw }: Direction) {
    const { choice, here } = this.#session;
    const share = choice.share(name);
    return html`<li class="${here === name ? "here" : ""} ${share >= 1 ? "done" : ""}" aria-label="${label(name)}: ${share >= 1 ? "taken" : "wanted"}">
      <div class="ring" style="--share: ${share}">
        <svg viewBox="0 0 40 40" aria-hidden="true"><ellipse cx="20" cy="20" rx="9" ry="12"></ellipse><path d=${faceTurned(yaw)}></path></svg>
        <canvas width=${MARK} height=${MARK} data-name=${name} aria-hidden="true"></canvas>
      </div>
      <span>${label(name)}</span></li>`;
  }

  #acts() {
    const { devices, device, choice } = this.#session;
    const none = choice.all.length === 0;
    return html`<div class="acts">
      <button class=${none ? "" : "main"} ?disabled=${none || this.#using} @click=${() => this.#use()}>Use these</button>
      <button @click=${() => this.dispatchEvent(new CustomEvent("leave"))}>Cancel</button>
      ${
        devices.length < 2
          ? nothing
          : html`<label>Camera <select @change=${(event: Event) => this.#session.open(textOf(event))}>
          ${devices.map(({ id, label }) => html`<option value=${id} ?selected=${id === device}>${label}</option>`)}
        </select></label>`
      }
      <p class="note">Face at rest, mouth shut, hair off the face, the light even. Nothing of the camera leaves this browser but the
        pictures in the rings: they go to the show's computer when you go on, for the fit alone, and are not stored.</p>
    </div>`;
  }

  #draw(landmarks: Landmarks): void {
    const canvas = this.renderRoot.querySelector<HTMLCanvasElement>("figure > canvas");
    if (canvas !== null) drawLandmarks(canvas, landmarks);
  }

  /** Shows the face of a picture in its mark. */
  #show(name: DirectionName, picture: ImageBitmap, points: Float32Array): void {
    const brush = this.renderRoot.querySelector<HTMLCanvasElement>(`[data-name="${name}"]`)?.getContext("2d");
    const [left, top, width, height] = faceBox(points, picture.width, picture.height);
    const side = AROUND * Math.max(width, height);
    const [x, y] = [left + (width - side) / 2, top + (height - side) / 2];
    brush?.setTransform(-1, 0, 0, 1, MARK, 0);
    brush?.drawImage(picture, x, y, side, side, 0, 0, MARK, MARK);
  }

  async #use(): Promise<void> {
    if (this.#using) return;
    this.#using = true;
    this.requestUpdate();
    const files = await this.#session.files();
    if (this.isConnected) this.dispatchEvent(new CustomEvent("use", { detail: files }));
  }
}

/** Midline, eyes and mouth of the drawn head, turned as a mirror shows it. */
function faceTurned(yaw: number): string {
  const [aside, narrow] = [-6 * Math.sin(yaw / DEGREES), Math.cos(yaw / DEGREES)];
  const tick = (x: number, y: number, wide: number): string =>
    `M${20 + aside + narrow * (x - wide / 2)} ${y}h${narrow * wide}`;
  return `M20 8Q${20 + 2.6 * aside} 20 20 32${tick(-4.4, 18, 3.4)}${tick(4.4, 18, 3.4)}${tick(0, 26, 4)}`;
}

const label = (name: DirectionName): string => name.charAt(0).toUpperCase() + name.slice(1);
