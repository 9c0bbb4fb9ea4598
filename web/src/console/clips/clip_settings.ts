/** How the shown clip is played: where it begins and ends, how it comes and goes, its speed, and whether it begins again. */

import { css, html, nothing } from "lit";
import { customElement } from "lit/decorators.js";
import { live } from "lit/directives/live.js";
import { base, entry, flow } from "../../ui/theme";
import { textOf } from "../../ui/topic_element";
import { ClipElement, clipControls, numberIn } from "./clip_element";
import type { ClipTopic } from "./clip_store";

const style = css`
  :host {
    ${flow}
    gap: 4px 12px;
    min-height: 40px;
    padding: 4px 8px;
  }
  input {
    width: 62px;
  }
  select {
    ${entry}
    max-width: 180px;
    min-height: var(--finger, 30px);
    font-size: 14px;
  }
  .called {
    width: 120px;
  }
  .file {
    position: relative;
    padding: 0 8px;
    min-height: var(--finger, 32px);
    color: var(--text);
    background: var(--raised);
    border: 1px solid var(--line);
    border-radius: 4px;
    cursor: pointer;
  }
  .file input {
    position: absolute;
    inset: 0;
    width: 100%;
    opacity: 0;
    cursor: pointer;
  }
  .file:focus-within {
    outline: 2px solid var(--focus);
    outline-offset: 1px;
  }
  b {
    overflow-wrap: anywhere;
    font-size: 15px;
  }
  @media (pointer: coarse) {
    input {
      width: 80px;
    }
  }
  @media (max-width: 899px) {
    b {
      display: none;
    }
    :host {
      gap: 4px 8px;
    }
    input {
      width: 56px;
    }
  }
  @media (max-width: 599px) {
    :host {
      flex-wrap: nowrap;
      overflow-x: auto;
    }
    label {
      flex-wrap: nowrap;
    }
    button {
      flex: none;
    }
  }
`;

/** Each field: its name in messages, what people read, and what it is. */
const FIELDS = [
  ["start", "Start", "Where it begins, seconds of its lanes"],
  ["stop", "Stop", "Where it ends, seconds of its lanes"],
  ["blend_in", "In", "Seconds in which it comes"],
  ["blend_out", "Out", "Seconds in which it goes"],
  ["speed", "Speed", "1 is as it was recorded"],
] as const;

@customElement("omote-clip-settings")
export class ClipSettings extends ClipElement {
  static override styles = [base, clipControls, style];

  protected override readonly topics: readonly ClipTopic[] = ["clips", "view", "link"];

  override render() {
    const { outline, name, locked } = this.clips;
    if (outline === null) return html`<b>${name}</b>${name === "" ? nothing : this.#sound()}`;
    return html`<b>${name}</b>${FIELDS.map(
      ([
        field,
        label,
        title,
      ]) => html`<label title=${title}>${label}<input inputmode="decimal" ?disabled=${locked !== ""}
        .value=${shown(outline[field])} @change=${(event: Event) => this.#set(field, event)}></label>`,
    )}
      <button aria-pressed=${outline.loop} title=${locked || "Begins again at its end (L)"} ?disabled=${locked !== ""}
        @click=${() => this.clips.editClip({ loop: !outline.loop })}>Loop</button>${this.#sound()}`;
  }

  /** What is heard with it, to play along with. */
  #sound() {
    const { clips } = this;
    const { outline, sound, sounds, namedSound: named, locked } = clips;
    const barred = locked !== "";
    const chosen = named?.name ?? sound;
    const known = named !== null || sound === "";
    return html`<label title=${locked || "The sound that is heard with it, from the place that is marked on: passes are recorded along with it"}>♪<select aria-label="Sound of the clip" ?disabled=${barred} .value=${live(chosen)} @change=${(event: Event) => clips.setSound(textOf(event), clips.cursor)}>
        <option value="">no sound</option>${known ? nothing : html`<option value=${sound}>${sound.slice(0, 12)} (not kept)</option>`}${sounds.map(({ name }) => html`<option value=${name} ?selected=${name === chosen}>${name}</option>`)}</select></label>
      <label class="file" title=${locked || "Adds a WAV, MP3 or Ogg to the sounds of the show; or drop it on this page"}>Add a sound …<input type="file" accept="audio/*" aria-label="Add a sound" ?disabled=${barred} @change=${this.#bring}></label>
      ${
        sound === ""
          ? nothing
          : html`${outline === null ? html`<span>from the first pass on</span>` : html`<label title="Where the sound begins, seconds of the lanes">at<input inputmode="decimal" aria-label="The sound begins at" ?disabled=${barred} .value=${shown(outline.sound_at)} @change=${(event: Event) => this.#set("sound_at", event)}></label>`}
      ${named === null ? nothing : html`<label title="Its name in the show; clips and cues find it by the old one too">Name<input class="called" aria-label="Name of the sound" maxlength="60" autocomplete="off" ?disabled=${barred} .value=${named.name} @change=${(event: Event) => clips.renameSound(textOf(event).trim())}></label><button title="Deletes the sound from the show; Undo brings it back" ?disabled=${barred} @click=${() => clips.dropSound()}>Delete sound</button>`}`
      }`;
  }

  readonly #bring = (event: Event): void => {
    const field = event.target as HTMLInputElement;
    const [file] = field.files ?? [];
    field.value = "";
    if (file !== undefined) void this.clips.bringSound(file);
  };

  #set(field: (typeof FIELDS)[number][0] | "sound_at", event: Event): void {
    const { outline } = this.clips;
    const number = numberIn(textOf(event));
    if (number !== null && number !== outline?.[field]) this.clips.editClip({ [field]: number });
    if (number !== null || outline === null) return;
    (event.target as HTMLInputElement).value = shown(outline[field]);
    this.clips.show.say("Give a number, as 1.5.");
  }
}

const shown = (number: number): string => String(Math.round(number * 1000) / 1000);
