/** Play, record, keep and discard; what is armed; the span that is selected. */

import { css, html } from "lit";
import { customElement, query } from "lit/decorators.js";
import { CLIP_PARTS } from "../../link/constants";
import { base, flow } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import { armingOf } from "./armed_parts";
import { AnimatedClipElement, clipControls } from "./clip_element";
import { clipTime, PASS_SPEEDS } from "./clip_passes";
import type { ClipTopic } from "./clip_store";

const style = css`
  :host {
    ${flow}
    gap: 6px 14px;
    padding: 6px 8px;
  }
  .group {
    ${flow}
    gap: 4px;
  }
  button {
    min-height: 44px;
  }
  .main {
    min-width: 52px;
    font-size: 16px;
    font-weight: 700;
  }
  .main[aria-pressed="true"] {
    color: #fff;
    background: var(--air-deep);
    border-color: var(--air);
  }
  .record {
    color: #ff6a5a;
    border-color: #8e2318;
  }
  .record[aria-pressed="true"] {
    color: #fff;
    background: #c3170a;
    border-color: #ff9a8e;
  }
  time {
    min-width: 92px;
    font-size: 26px;
    font-weight: 600;
    text-align: right;
  }
  .arm[aria-pressed="true"] {
    color: #fff;
    background: #8e2318;
    border-color: #ff6a5a;
  }
  .arms small {
    color: inherit;
    opacity: 0.7;
  }
  .word {
    color: var(--dim);
  }
  select {
    min-height: 44px;
    max-width: 150px;
  }
  @media (pointer: coarse) and (max-width: 899px) {
    small {
      display: none;
    }
  }
  @media (max-width: 599px) {
    :host {
      gap: 4px 8px;
    }
    .group {
      gap: 3px;
    }
    .arms {
      display: grid;
      grid-template-columns: repeat(7, minmax(0, 1fr));
      flex: 1 0 100%;
    }
    .arms .word,
    .span .word {
      display: none;
    }
    .arms button {
      padding: 0;
    }
    time {
      min-width: 76px;
      font-size: 20px;
    }
    .main {
      min-width: 46px;
    }
  }
`;

const SPEED_SIGNS = { 1: "Full", 0.75: "¾", 0.5: "½", 0.25: "¼" } as const;

@customElement("omote-clip-transport")
export class ClipTransport extends AnimatedClipElement {
  @query("time") private clock!: HTMLElement;
  @query(".play") private play!: HTMLElement;

  static override styles = [base, clipControls, style];

  protected override readonly topics: readonly ClipTopic[] = ["clips", "work", "view", "link", "characters"];

  override render() {
    const { clips } = this;
    const { pass, locked } = clips;
    const recording = pass !== null || clips.counting !== null;
    return html`
      <div class="group">
        <button title="To the start (Home)" aria-label="To the start" @click=${() => clips.seek(clips.outline?.start ?? 0)}>|◀</button>
        <button class="main play" title="Play and stop (Space)" @click=${() => clips.togglePlay()}>▶</button>
        <button class="main record" title=${locked || "Record what is armed; again: end and keep (R)"} aria-label="Record" aria-pressed=${recording} ?disabled=${locked !== ""} @click=${() => clips.record()}>● Rec</button>
        <button title="Keep the pass (K)" ?disabled=${pass === null} @click=${() => clips.keep()}>Keep</button>
        <button title="Discard the pass (Esc)" ?disabled=${!recording} @click=${() => clips.discard()}>Discard</button>
        <time aria-label="Time of the clip"></time>
      </div>
      ${this.#arms()}${this.#span()}${this.#who()}`;
  }

  #arms() {
    const { clips } = this;
    return html`<div class="group arms" role="group" aria-label="Parts that are recorded"><span class="word">Arm</span>
      ${CLIP_PARTS.map((part, place) => html`<button class="arm" data-part=${part} title="Record the ${part} alone (${place + 1}); with Shift beside the others, or not" aria-pressed=${clips.armed.has(part)} @click=${(event: MouseEvent) => clips.arm(part, armingOf(event, matchMedia("(pointer: coarse)").matches))}>${part} <small>${place + 1}</small></button>`)}
      <button title="Record all parts (A)" aria-label="All parts" @click=${() => clips.armAll()}>all <small>A</small></button>
    </div>`;
  }

  #span() {
    const { clips } = this;
    const { span, begun, locked } = clips;
    const says =
      span !== null
        ? `${clipTime(span.from)} – ${clipTime(span.to)}`
        : begun === null
          ? "no span"
          : `from ${clipTime(begun)}`;
    return html`<div class="group span"><span class="word">Span</span><span class="says">${says}</span>
      <button title="It begins here (I)" aria-label="The span begins here" @click=${() => clips.mark("from")}>[</button>
      <button title="It ends here (O)" aria-label="The span ends here" @click=${() => clips.mark("to")}>]</button>
      <button title=${locked || "Record the chosen lane again over the span (G)"} ?disabled=${span === null || locked !== ""} @click=${() => clips.recordAgain()}>Again</button>
      <button aria-label="No span" title="No span (Esc)" ?disabled=${span === null && begun === null} @click=${() => clips.select(null)}>✕</button></div>`;
  }

  #who() {
    const { clips } = this;
    const names = Object.keys(clips.show.state?.characters ?? {});
    return html`<div class="group"><button title="Three seconds are counted in before a pass (C)" aria-pressed=${clips.countsIn} @click=${() => clips.setCountIn(!clips.countsIn)}>Count 3</button>
      <select class="speed" aria-label="Speed of passes" title="At what speed a pass is recorded, and what plays meanwhile (S: half, full); below the full one no sound is heard" @change=${(event: Event) => clips.setPassSpeed(Number(textOf(event)))}>
        ${PASS_SPEEDS.map((speed) => html`<option value=${speed} .selected=${speed === clips.passSpeed}>${SPEED_SIGNS[speed]} speed</option>`)}</select>
      <select aria-label="Character" title="Who plays the clip, and is recorded" @change=${(event: Event) => clips.chooseCharacter(textOf(event))}>
        ${names.map((name) => html`<option value=${name} .selected=${name === clips.character}>${clips.labelOf(name)}</option>`)}</select></div>`;
  }

  paint(): void {
    const { clips } = this;
    const plays = clips.playing !== null && clips.pass === null;
    this.write.text(this.clock, clipTime(clips.position));
    this.write.text(this.play, plays || clips.pass !== null ? "■" : "▶");
    this.write.attribute(this.play, "aria-label", plays ? "Stop" : clips.pass === null ? "Play" : "End and keep");
    this.write.attribute(this.play, "aria-pressed", String(plays));
  }
}
