/** The synthetic voices of a show: which there are, and texts that they speak, as `say` takes them. */

import type { Say } from "../../link/messages";

/** A voice, and its language for people. */
export interface Voice {
  readonly name: string;
  readonly label: string;
}

/** What a voice made of a text: the key of its sound, its visemes and their times. */
interface Spoken {
  readonly sound: string;
  readonly seconds: number;
  readonly marks: readonly string[];
  readonly times: readonly number[];
}

export const HOW_TO_GET_A_VOICE = "Only lips move: for a voice, pip install 'omote[voice]' where the show runs";
const ADDRESS = "/voices";
const NO_ANSWER = "Nothing was said: the show's computer does not answer; try again.";

/** The voices that there are, none where none is installed or the show does not answer. */
export async function listVoices(): Promise<readonly Voice[]> {
  const answer = await fetch(ADDRESS, { cache: "no-store" }).catch(() => null);
  return answer?.ok === true ? ((await answer.json()) as Voice[]) : [];
}

/** The voice that is proposed to somebody who reads these languages, the first that there is; "" for none. */
export function usualVoice(voices: readonly Voice[], languages: readonly string[]): string {
  const names = voices.map(({ name }) => name);
  for (const language of languages.map((each) => each.toLowerCase()))
    for (const wanted of [language, language.split("-")[0] ?? ""]) {
      const found = names.find((name) => name === wanted) ?? names.find((name) => name.startsWith(`${wanted}-`));
      if (wanted !== "" && found !== undefined) return found;
    }
  return names[0] ?? "";
}

/** A text as a voice says it; an Error with a sentence where it does not. */
export async function speak(
  text: string,
  voice: string,
): Promise<Pick<Say, "sound" | "seconds" | "timing" | "marks" | "times">> {
  const body = JSON.stringify({ text, voice });
  const answer = await fetch(ADDRESS, { method: "POST", body }).catch(() => null);
  if (answer === null) throw new Error(NO_ANSWER);
  if (!answer.ok) throw new Error(await answer.text());
  const { sound, seconds, marks, times } = (await answer.json()) as Spoken;
  return { timing: "visemes", sound, seconds, marks: [...marks], times: packTimes(times) };
}

/** Times as the wire has them. */
function packTimes(times: readonly number[]): Uint8Array {
  const bytes = new Uint8Array(4 * times.length);
  const view = new DataView(bytes.buffer);
  times.forEach((time, place) => {
    view.setFloat32(4 * place, time, true);
  });
  return bytes;
}
