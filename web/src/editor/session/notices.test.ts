import { describe, expect, it } from "vitest";
import { EditorNotices } from "./notices";

describe("notices", () => {
  const texts = (notices: EditorNotices): string[] => notices.all.map(({ text }) => text);

  it("stand with the newest first, each sentence once", () => {
    const notices = new EditorNotices();
    for (const text of ["a.txt was not taken in.", "b.json was not taken in.", "a.txt was not taken in."])
      notices.say(text, "refusal", []);
    expect(texts(notices)).toEqual(["a.txt was not taken in.", "b.json was not taken in."]);
    notices.say("Saved.", "done", []);
    notices.say("Restored.", "done", []);
    expect(texts(notices)).toEqual(["Restored.", "a.txt was not taken in.", "b.json was not taken in."]);
    notices.clear("refusal");
    expect(texts(notices)).toEqual(["Restored."]);
    notices.dismiss(notices.all[0]?.id ?? -1);
    expect(texts(notices)).toEqual([]);
  });
});
