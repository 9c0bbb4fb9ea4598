/** Marks a moment of the recording, and keeps what was played: of the show as a recording, of a character as a clip. */

import { css, html } from "lit";
import { customElement } from "lit/decorators.js";
import { base, entry, flow } from "../../ui/theme";
import { ConsoleDialog, sheet } from "../controls/console_dialog";
import type { ConsoleStore } from "../store/console_store";
import { numberIn } from "./clip_element";

/** What a moment is called that was marked without a word. */
const NO_WORD = "mark";
/** Minutes that a show records, and seconds that become a clip, at most. */
const MOST_MINUTES = 100;
const MOST_SECONDS = 600;

const style = css`
  section {
    width: min(520px, 100%);
  }
  form {
    ${flow}
    gap: 6px;
  }
  label {
    ${flow}
    gap: 5px;
    color: var(--dim);
  }
  input {
    ${entry}
    width: 64px;
    min-height: 36px;
    font-size: 14px;
  }
  input.wide {
    flex: 1 1 130px;
  }
  button {
    min-height: 36px;
    color: var(--text);
  }
  @media (pointer: coarse) {
    input,
    button {
      min-height: 44px;
      font-size: 16px;
    }
  }
`;

/** Marks this moment. */
export function markMoment(store: ConsoleStore, word: string): void {
  const text = word.trim() === "" ? NO_WORD : word.trim();
  if (store.ask({ type: "mark_moment", text })) store.say(`Marked in the recording: ${text}.`, "done");
}

/** Closes where something was asked for; says what has become of it. Tells `close`. */
@customElement("omote-keep-dialog")
export class KeepDialog extends ConsoleDialog {
  protected override readonly first = "input";

  static override styles = [base, sheet, style];

  override render() {
    const who = this.store.played.names.map((name) => this.store.state?.characters[name]?.label || name).join(", ");
    return html`<section class="panel" role="dialog" aria-modal="true" aria-label="Mark and keep">
      <h2>Mark this moment</h2>
      <form aria-label="Mark" @submit=${this.#mark}><input class="wide" name="word" maxlength="80" aria-label="Word, if you like" placeholder="a word, if you like" autocomplete="off"><button type="submit">Mark</button></form>
      <p>Shift M marks without this.</p>
      <h2>Keep the recording</h2>
      <form aria-label="Keep the recording" @submit=${this.#keep}><label>the last<input name="long" inputmode="decimal" value="10" aria-label="Minutes">minutes as</label><input class="wide" name="name" aria-label="Name of the recording" placeholder="name" autocomplete="off"><button type="submit">Keep</button></form>
      <h2>Keep as a clip</h2>
      <form aria-label="Keep as a clip" @submit=${this.#keepClip}><label>the last<input name="long" inputmode="decimal" value="10" aria-label="Seconds">seconds of ${who} as</label><input class="wide" name="name" maxlength="40" aria-label="Name of the clip" placeholder="name" autocomplete="off"><button type="submit">Keep clip</button></form>
      <div class="row"><a href="/clips" target="omote-clips">Record and edit clips</a><button @click=${this.close}>Close</button></div>
    </section>`;
  }

  readonly #mark = (event: SubmitEvent): void => {
    markMoment(this.store, given(event, "word"));
    this.close();
  };

  readonly #keep = (event: SubmitEvent): void => {
    const [name, minutes] = this.#named(event, MOST_MINUTES, "minutes");
    if (minutes === null) return;
    const done = (): void => this.store.say(`Kept: the last ${minutes} minutes as ${name}.`, "done");
    if (this.store.ask({ type: "keep_recording", name, minutes }, { recording_kept: done })) this.close();
  };

  readonly #keepClip = (event: SubmitEvent): void => {
    const [name, seconds] = this.#named(event, MOST_SECONDS, "seconds");
    if (seconds === null) return;
    this.store.say("The clip is cut from the recording ...", "done");
    for (const [place, character] of this.store.played.names.entries()) {
      const clip = place === 0 ? name : `${name} ${character}`;
      const done = (): void =>
        this.store.say(`Kept: the last ${seconds} s of ${character} as the clip ${clip}.`, "done");
      this.store.ask({ type: "keep_clip", character, name: clip, seconds }, { recording_kept: done });
    }
    this.close();
  };

  /** The name and the length that were typed; null for the length where something is wrong, which is said. */
  #named(event: SubmitEvent, most: number, unit: string): [string, number | null] {
    const [name, long] = [given(event, "name"), numberIn(given(event, "long"))];
    if (name === "") this.store.say("Give it a name.");
    else if (long === null || !(long > 0 && long <= most)) this.store.say(`Give a number of ${unit}, ${most} at most.`);
    else return [name, long];
    return [name, null];
  }
}

/** What a form has in a field. */
function given(event: SubmitEvent, field: string): string {
  event.preventDefault();
  return String(new FormData(event.target as HTMLFormElement).get(field) ?? "").trim();
}
