/** The camera page: the picture with the landmarks, its health, the performer and the calibration. */

import { html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { drawBody } from "../body/body_drawing";
import type { Body } from "../body/body_messages";
import { drawLandmarks } from "../face_mesh/landmark_drawing";
import type { Landmarks } from "../face_mesh/landmark_messages";
import { drawHands } from "../hands/hand_drawing";
import type { Hands } from "../hands/hand_messages";
import { listenToKeys } from "../ui/key_presses";
import { base, palette, toolPage } from "../ui/theme";
import { textOf, whileShown } from "../ui/topic_element";
import { CameraElement } from "./camera_element";
import { cameraPageStyle } from "./camera_page_style";
import "./body_panel";
import "./guide_view";
import "./hand_guide_view";
import "./hand_panel";
import "./performer_panel";
import "./tracked_panel";

/** Bars of what the face is read as: the rest would not be read. */
const BARS = 52;

@customElement("omote-camera-page")
export class CameraPage extends CameraElement {
  static override styles = [palette, base, toolPage, cameraPageStyle];

  /** Draws the page anew: the session has changed. */
  changed(): void {
    this.count += 1;
  }

  /** Draws what is found in pictures: the newest face, the newest hands and the newest body. */
  readonly drawing = {
    face: (landmarks: Landmarks): void => {
      this.#face = landmarks;
      this.#draw();
    },
    hands: (hands: Hands, playing: number): void => {
      this.#hands = [hands, playing];
      this.#draw();
    },
    body: (body: Body): void => {
      this.#body = body;
      this.#draw();
    },
  };
  #face: Landmarks | null = null;
  #hands: [Hands, number] | null = null;
  #body: Body | null = null;

  #draw(): void {
    const canvas = this.renderRoot.querySelector("canvas");
    const { tracksFace, tracksHand, tracksBody } = this.session;
    const size = this.#body ?? this.#hands?.[0] ?? this.#face;
    if (canvas === null || size === null) return;
    const { width, height, time, cost } = size;
    const face = tracksFace ? this.#face : null;
    drawLandmarks(canvas, face ?? { width, height, time, cost, points: new Float32Array(), light: 0 });
    const context = canvas.getContext("2d");
    if (context !== null && this.#body !== null && tracksBody) drawBody(context, this.#body);
    if (context !== null && this.#hands !== null && tracksHand) drawHands(context, ...this.#hands);
  }

  /** Whether a guide stood under the picture when the page was drawn last. */
  #guides = false;

  /** Who begins a guide below its picture, on a phone, is led back to it. */
  protected override updated(): void {
    const figure = this.renderRoot.querySelector("figure.guided");
    if (figure !== null && !this.#guides) figure.scrollIntoView({ block: "start" });
    this.#guides = figure !== null;
  }

  constructor() {
    super();
    whileShown(this, () => listenToKeys({ page: this.#key }));
  }

  override render() {
    const { session, count } = this;
    const byFace = session.tracksFace;
    const asked = byFace && (session.status === null ? session.model.kind === "loading" : session.status.guide);
    const awaited = session.trouble === null && asked; // the picture keeps its size when loading ends
    const [guided, offered] = [session.model.kind === "ready" && awaited, byFace && session.status?.unused];
    const minute = session.hand.minute !== null;
    return html`${this.#header()}
      <main>
        <div class="left">
          <figure class=${awaited || offered || minute ? "guided" : ""}>${session.video}<canvas aria-hidden="true"></canvas>${this.#cover()}</figure>
          <omote-guide ?hidden=${!guided && !offered} .session=${session} .count=${count}></omote-guide>
          <omote-hand-guide ?hidden=${!minute} .session=${session} .count=${count}></omote-hand-guide>
          ${this.#health()}
        </div>
        <div class="right">
          <omote-performer .session=${session} .count=${count}></omote-performer>
          <omote-tracked .session=${session} .count=${count}></omote-tracked>
          <omote-hand .session=${session} .count=${count}></omote-hand>
          <omote-body .session=${session} .count=${count}></omote-body>
          ${byFace ? this.#bars() : nothing}
        </div>
      </main>`;
  }

  #header() {
    const { session } = this;
    return html`<header>
      <h1>CAMERA</h1>
      <label>Camera
        <select @change=${(event: Event) => session.choose(textOf(event))}>
          ${session.devices.length === 0 ? html`<option>none</option>` : nothing}
          ${session.devices.map(({ id, label }) => html`<option value=${id} ?selected=${id === session.device}>${label}</option>`)}
        </select></label>
      ${this.#linkState()}
      ${
        session.notice
          ? html`<span class="notice" role="alert">${session.notice}
        <button aria-label="Dismiss" @click=${() => session.dismiss()}>✕</button></span>`
          : nothing
      }
    </header>`;
  }

  #linkState() {
    const { online, displaced, name, trouble, noPicture } = this.session;
    if (displaced) {
      return html`<span class="lost" role="alert">Another page plays as ${name} now
        <button @click=${() => this.session.perform(name)}>Take it back</button></span>`;
    }
    if (online && noPicture) {
      return html`<span class="waiting" role="status">${trouble ? "No camera" : noPicture}: the show gets no ${this.#sought}</span>`;
    }
    if (online) return html`<span class="online" role="status">The show hears you</span>`;
    return html`<span class="lost" role="alert">No link to the show – trying again</span>`;
  }

  /** What the camera is for first. */
  get #sought(): "face" | "hand" | "body" {
    const { tracked } = this.session;
    return tracked === "both" ? "face" : tracked;
  }

  /** What lies over the picture while there is none. */
  #cover() {
    const { trouble, device, tracked, hand, body } = this.session;
    const apart = tracked === "hand" ? hand.model : tracked === "body" ? body.model : null;
    const model = apart ?? this.session.model;
    if (trouble) {
      return html`<div class="cover" role="alert"><h2>${trouble.title}</h2><p>${trouble.advice}</p>
        <button @click=${() => this.session.choose(device)}>Try again</button></div>`;
    }
    if (model.kind === "failed") {
      return html`<div class="cover" role="alert"><h2>The ${this.#sought} model does not run here</h2>
        <p>${model.reason}. Load the page again; a current Chrome, Edge, Firefox or Safari can.</p></div>`;
    }
    if (model.kind === "loading") {
      return html`<div class="cover" role="status"><p>Loading ${model.what} …</p>
        <progress max="1" .value=${model.share}></progress></div>`;
    }
    return nothing;
  }

  #health() {
    const { health, model, noPicture, tracksFace } = this.session;
    if (!tracksFace) return nothing;
    const where = model.kind === "ready" && !noPicture ? `${model.backend}, ${model.cost.toFixed(0)} ms` : "";
    return html`<ul class="health" aria-label="Health">${health.map(
      ({ what, good, advice }) => html`<li class=${good ? "good" : "bad"}><b>${what}</b> ${advice}</li>`,
    )}${where ? html`<li class="where">${where}</li>` : nothing}</ul>`;
  }

  #bars() {
    const weights = Object.entries(this.session.status?.weights ?? {}).slice(0, BARS);
    if (weights.length === 0) return nothing;
    return html`<details class="panel"><summary>What is read of your face</summary>
      <div class="bars">${weights.map(
        ([name, value]) => html`<span>${name}</span><meter min="0" max="1" .value=${value} aria-label=${name}></meter>`,
      )}</div></details>`;
  }

  readonly #key = (event: KeyboardEvent, typing: boolean): void => {
    if (typing || event.key !== "Escape") return;
    const { hand, status } = this.session;
    if (hand.minute === null && (status?.guide?.of ?? 0) < 2) return;
    event.preventDefault();
    if (hand.minute !== null) hand.cancelMinute();
    else this.session.send({ type: "cancel_guide" });
  };
}
