import { afterEach, expect, test, vi } from "vitest";
import { listVoices, speak, usualVoice } from "./voices";

const VOICES = ["de", "en-gb", "en-us", "fr-be", "fr-fr"].map((name) => ({ name, label: name }));

afterEach(() => vi.unstubAllGlobals());

test("the voice of the reader's language is proposed, by its region, then without it, then any", () => {
  expect(usualVoice(VOICES, ["en-US", "de"])).toBe("en-us");
  expect(usualVoice(VOICES, ["en"])).toBe("en-gb");
  expect(usualVoice(VOICES, ["de-AT"])).toBe("de");
  expect(usualVoice(VOICES, ["fr-FR"])).toBe("fr-fr");
  expect(usualVoice(VOICES, ["tlh"])).toBe("de");
  expect(usualVoice([], ["en"])).toBe("");
});

test("what a voice has spoken is said with its sound, its visemes and their times", async () => {
  const spoken = { sound: "ab", seconds: 0.5, marks: ["PP", "aa"], times: [0, 0.25, 0.5] };
  const fetched = vi.fn(async () => Response.json(spoken));
  vi.stubGlobal("fetch", fetched);
  const said = await speak("Ma", "de");
  expect(fetched).toHaveBeenCalledWith("/voices", { method: "POST", body: '{"text":"Ma","voice":"de"}' });
  expect({ ...said, times: [...new Float32Array((said.times as Uint8Array).buffer)] }).toEqual({
    timing: "visemes",
    ...spoken,
  });
});

test("a voice that cannot speak says why, and a show that does not answer has none", async () => {
  vi.stubGlobal("fetch", async () => new Response("nothing was said: there is no text.", { status: 400 }));
  await expect(speak("...", "de")).rejects.toThrow("there is no text");
  expect(await listVoices()).toEqual([]);
  vi.stubGlobal("fetch", () => Promise.reject(new TypeError("offline")));
  await expect(speak("Ma", "de")).rejects.toThrow("does not answer; try again");
  expect(await listVoices()).toEqual([]);
});
