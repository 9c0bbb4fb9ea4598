/** How the hand is read, and what it plays. */

import { css, html, nothing, svg } from "lit";
import { customElement, state } from "lit/decorators.js";
import { FEW_PICTURES, sayDelay } from "../hands/hand_calibration";
import { HAND_AXES, type HandAxes } from "../hands/hand_guide";
import { adviseOnAbsence } from "../hands/hand_tracker";
import { base, flow, palette } from "../ui/theme";
import { textOf } from "../ui/topic_element";
import { CameraElement } from "./camera_element";
import { mainButton } from "./camera_page_style";
import { FILM_SECONDS, FilmRecorder } from "./film_recorder";
import { drawHand, drawStand } from "./hand_picture";
import type { HandChoice } from "./session/camera_messages";

/** What a hand takes of a face; the rest is played by who has it. */
const REGIONS: readonly (readonly [string, HandChoice["regions"]])[] = [
  ["mouth and head", ["mouth", "head"]],
  ["mouth, brows and head", ["brows", "mouth", "head"]],
  ["mouth alone", ["mouth"]],
  ["head alone", ["head"]],
  ["the whole face", []],
];
const ALL_PARTS = 6;
const OPEN: HandAxes = { opening: 0.6, index: 0, little: 0, yaw: 0, pitch: 0, roll: 0 };

const style = css`
  section {
    display: grid;
    gap: 8px;
    padding: 12px;
    margin-top: 8px;
  }
  .row {
    ${flow}
    gap: 6px;
  }
  button,
  select {
    min-height: 34px;
  }
  p {
    line-height: 1.35;
    color: var(--dim);
  }
  .warn {
    color: var(--attention);
  }
  figure {
    display: grid;
    grid-template-columns: 1fr 1fr;
    gap: 6px;
    margin: 0;
  }
  svg {
    width: 100%;
    color: var(--hand);
  }
  .axes {
    display: grid;
    grid-template-columns: auto minmax(60px, 1fr);
    gap: 1px 8px;
    align-items: center;
    font-size: 12px;
  }
  meter {
    width: 100%;
    height: 9px;
  }
`;

@customElement("omote-hand")
export class HandPanel extends CameraElement {
  static override styles = [palette, base, mainButton, style];
  /** Whether the question about a film is open. */
  @state() private asksForFilm = false;
  readonly #film = new FilmRecorder(() => this.requestUpdate());

  override render() {
    const { tracksHand, status } = this.session;
    return html`${tracksHand ? html`${this.#calibration()}${status ? this.#plays(status.hand) : nothing}${this.#axes()}` : nothing}
      ${tracksHand || this.#film.records ? this.#saving() : nothing}`;
  }

  #calibration() {
    const { hand, noHand } = this.session;
    const known = hand.calibration !== null;
    const advice = hand.failed || adviseOnAbsence(hand.reading?.away ?? 0) || hand.advice(Date.now());
    return html`<section class="panel" aria-label="Hand"><h2>How your hand is read</h2>
      ${
        known
          ? nothing
          : html`<figure><svg viewBox="0 0 220 140" role="img" aria-label="The camera stands at the side of the hand">${svg`${drawStand()}`}</svg>
        <svg viewBox="0 0 220 140" role="img" aria-label="What the camera sees: the hand in profile">${svg`${drawHand(OPEN)}`}</svg></figure>
        <p>Put the camera at the side of your hand, at an arm's length: it sees the hand in profile, fingers to the side, little finger to the lens. With the fingers to the lens it cannot be read.</p>`
      }
      <p role="status">${this.#sayCalibration()}</p>
      ${advice ? html`<p class="warn">${advice}</p>` : nothing}
      ${hand.reading?.turned ? html`<p class="warn" role="alert">Your hand has turned to the camera, or from it, by more than 20 degrees: turn it back into profile, or make the guided minute again.</p>` : nothing}
      <div class="row">
        <button class=${known ? "" : "main"} ?disabled=${noHand !== "" || hand.minute !== null} title=${noHand} @click=${this.#beginMinute}>
          ${known ? "Guided minute again" : "Guided minute of the hand"}</button>
        <button ?disabled=${!known} @click=${() => hand.forget()}>Forget this hand</button>
      </div>
      <div class="row"><label>Hands <select aria-label="Hands" @change=${(event: Event) => hand.chooseCount(textOf(event) === "2" ? 2 : 1)}>
        <option value="1" ?selected=${hand.count === 1}>one</option>
        <option value="2" ?selected=${hand.count === 2}>two: the other is a point</option></select></label></div></section>`;
  }

  readonly #beginMinute = (): void => {
    this.#film.noteMinute();
    this.session.hand.beginMinute(performance.now() / 1000);
  };

  #sayCalibration(): string {
    const { calibration, model, rate, reading } = this.session.hand;
    const speed = rate > 0 && rate < FEW_PICTURES ? ` ${rate.toFixed(0)} pictures a second: that lags.` : "";
    if (model?.kind !== "ready") return this.session.noHand;
    const seen = reading !== null && reading.playing >= 0 ? "Your hand is seen." : "No hand is seen.";
    if (calibration === null) return `${seen} It plays after its guided minute.${speed}`;
    const made = new Date(calibration.made).toLocaleString();
    return `${seen} Read by the guided minute of ${made}: your ${calibration.side} hand${sayDelay(calibration)}.${speed}`;
  }

  #plays({ characters, regions, pads }: HandChoice) {
    const played = characters.filter((character) => character.played).map(({ name }) => name);
    const parts = regions.length === ALL_PARTS ? [] : regions;
    const play = (chosen: string[], taken: HandChoice["regions"]): void =>
      this.session.send({ type: "play_hand", characters: chosen, regions: taken });
    const toggle = (name: string): string[] =>
      played.includes(name) ? played.filter((other) => other !== name) : [...played, name];
    const first = this.session.tracked === "both" ? (REGIONS[0]?.[1] ?? []) : [];
    return html`<section class="panel" aria-label="Hand plays"><h2>Your hand plays</h2>
      <div class="row">${characters.map(
        ({ name, label, played: on }) =>
          html`<button aria-pressed=${on} @click=${() => play(toggle(name), played.length ? parts : first)}>${label}</button>`,
      )}</div>
      <label>Takes <select aria-label="Takes" ?disabled=${played.length === 0} @change=${(event: Event) =>
        play(played, REGIONS[Number(textOf(event))]?.[1] ?? [])}>${REGIONS.map(
        ([label, taken], place) =>
          html`<option value=${place} ?selected=${taken.join() === parts.join()}>${label}</option>`,
      )}</select></label>
      ${this.session.hand.count === 2 ? this.#pad(pads) : nothing}
      <p>Thumb against fingers is the jaw, the wrist the head; index and middle finger move the brows, ring and little finger the corners of the mouth.</p></section>`;
  }

  #pad(pads: string[]) {
    const { hand } = this.session;
    return html`<label>The other hand moves <select aria-label="The other hand moves" @change=${(event: Event) => hand.choosePad(textOf(event))}>
      <option value="" ?selected=${hand.pad === ""}>nothing</option>
      ${pads.map((pad) => html`<option value=${pad} ?selected=${pad === hand.pad}>the pad ${pad}</option>`)}</select></label>`;
  }

  #axes() {
    const { axes, other } = this.session.hand.reading ?? { axes: null, other: null };
    if (axes === null && other === null) return nothing;
    return html`<details class="panel" open><summary>What is read of your hand</summary><div class="axes">
      ${HAND_AXES.map((axis) => meter(axis, axes?.[axis] ?? 0, axis === "opening" ? 0 : -1))}
      ${other === null ? nothing : html`${meter("other hand, right", other[0], -1)}${meter("other hand, up", other[1], -1)}`}
    </div></details>`;
  }

  /** A film for tests of hands, by its performer alone. */
  #saving() {
    const stream = this.session.video.srcObject;
    const open = stream instanceof MediaStream && "MediaRecorder" in globalThis;
    const film = this.#film;
    if (film.records) {
      return html`<section class="panel" aria-label="Film"><p class="warn" role="status">A film of this camera is being taken</p>
        <p>It ends by itself in ${Math.ceil(film.left)} s.</p>
        <div class="row"><button @click=${() => film.stop()}>End it and save</button></div></section>`;
    }
    if (!this.asksForFilm) {
      return html`<section class="panel" aria-label="Film">
        ${film.saved ? html`<p role="status">Handed to the browser's downloads as ${film.saved}. Look at it before you pass it on; Omote keeps no copy.</p>` : nothing}
        ${film.failed ? html`<p class="warn" role="alert">This browser takes no film: ${film.failed}</p>` : nothing}
        <div class="row"><button ?disabled=${!open} @click=${() => this.#ask(true)}>Save a film of this camera…</button></div></section>`;
    }
    const begin = (): void => {
      this.#ask(false);
      if (stream instanceof MediaStream) film.start(stream);
    };
    return html`<section class="panel" aria-label="Film"><p>The browser saves what this camera sees, without sound, for ${FILM_SECONDS} seconds or until you end it, as a file on this machine. Omote sends it to nobody and has no film of a real hand: one of a guided minute helps most, if you pass it on to who develops Omote. All who are in the picture should agree to that first.</p>
      <div class="row"><button class="main" @click=${begin}>We agree: take it</button><button @click=${() => this.#ask(false)}>No film</button></div></section>`;
  }

  #ask(asks: boolean): void {
    this.asksForFilm = asks;
  }
}

const meter = (label: string, value: number, least: number) =>
  html`<span>${label}</span><meter min=${least} max="1" .value=${value} aria-label=${label}></meter>`;
