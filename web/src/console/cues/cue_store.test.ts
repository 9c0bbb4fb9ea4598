import { beforeEach, describe, expect, it } from "vitest";
import type { Cue, CueListStatus, CueName, CueStatus, FromClient, State } from "../../link/messages";
import { ConsoleStore } from "../store/console_store";
import { CueStore } from "./cue_store";

const cue = (number: string, more: Partial<Cue> = {}): Cue => ({
  identity: `id${number}`,
  number,
  moves: {},
  label: `Cue ${number}`,
  note: "",
  colour: "",
  pre_wait: 0,
  post_wait: 0,
  goes_on: "",
  skip: false,
  actions: [],
  ...more,
});
const named = ({ identity, number, label, note, colour }: Cue): CueName => ({ identity, number, label, note, colour });

const FIRST = named(cue("1"));
const MAIN: CueListStatus = {
  current: null,
  standby: FIRST,
  waits: [],
  moving: [],
  follows: null,
  follows_in: 0,
  since: null,
  by: "",
  pressed: "",
};
const STATUS: CueStatus = {
  chosen: "main",
  lists: { main: MAIN },
  rate: 1,
  edits: 3,
  undo: "new cue 3",
  redo: "",
  ignored: "",
  ignored_count: 2,
  rejected: [],
  locked: false,
};
const CHARACTER = { panics: 0, label: "One", face_call: null, expression_call: null, home_face: "generic" };

let [sent, number, now]: [FromClient[], number, number] = [[], 0, 0];
let documents: Record<string, Cue[]>;
let edits: number;
let fetched: string[];
let [posted, refusal]: [string[], string] = [[], ""];
let show: ConsoleStore;
let cues: CueStore;

const heard = (change: Partial<CueStatus> = {}): void => {
  number += 1;
  const state = {
    type: "state",
    epoch: 1,
    number,
    time: 0,
    characters: { one: CHARACTER },
    cues: { ...STATUS, ...change },
  };
  show.receive(state as unknown as State);
};
const way = (change: Partial<CueListStatus>) => ({ lists: { main: { ...MAIN, ...change } } });
const settled = (): Promise<void> => new Promise((done) => setTimeout(done));
const last = (): FromClient | undefined => sent.at(-1);

const request = async (address: string | URL | Request, { method, body }: RequestInit = {}) => {
  const name = decodeURIComponent(String(address).split("/").at(-1) ?? "");
  if (method === "POST") {
    posted.push(`${name} ${body}`);
    return refusal === "" ? new Response("{}") : new Response(refusal, { status: 400 });
  }
  fetched.push(name);
  const found = documents[name];
  return found ? new Response(JSON.stringify({ edits, cues: found })) : new Response(null, { status: 204 });
};

beforeEach(async () => {
  [sent, number, now, fetched, edits] = [[], 0, 0, [], 3];
  documents = { main: [cue("1"), cue("2", { skip: true }), cue("3")] };
  [posted, refusal] = [[], "line 1: a cue has no number"];
  show = new ConsoleStore(
    (message) => sent.push(message),
    () => now,
    "page",
  );
  cues = new CueStore(show, "", () => now, request as typeof fetch);
  show.setOnline(true);
  heard();
  await settled();
});

describe("what a page of cues plays", () => {
  it("names the cue that its presser sees", () => {
    cues.go();
    expect(last()).toMatchObject({ type: "go", seen: "id1", cue_list: "main" });
    heard(way({ standby: named(cue("3")) }));
    cues.go();
    expect(last()).toMatchObject({ type: "go", seen: "id3" });
    expect(new Set(sent.map((message) => "id" in message && message.id)).size).toBe(sent.length);
  });

  it("calls a cue that it has just had stand by, though no state has said so yet", () => {
    cues.stepStandby(1);
    expect(last()).toMatchObject({ type: "set_standby", cue: "3" });
    heard(); // a state that was on its way
    cues.go();
    expect(last()).toMatchObject({ type: "go", seen: "id3" });
  });

  it("shows what the show has where nobody answers a standby", () => {
    cues.stepStandby(1);
    now = 1500;
    heard();
    expect(cues.standby?.number).toBe("1");
  });

  it("sends nothing that is not heard, and says so", () => {
    show.setOnline(false);
    expect(cues.unheard).toContain("Link lost");
    cues.go();
    show.setOnline(true);
    cues.setAccess({ role: "view", name: "", asked: true });
    cues.go();
    expect(show.notice).toContain('needs "operate"');
    expect(sent).toEqual([]);
  });

  it("says at the end of a list that nothing stands by, but lets paused cues go on", () => {
    heard(way({ standby: null }));
    cues.go();
    expect(show.notice).toContain("No cue stands by");
    heard({ ...way({ standby: null }), rate: 0 });
    cues.go();
    expect(last()).toMatchObject({ type: "go", seen: "" });
  });

  it("shows an ignored GO to everybody for a while, and none of before", () => {
    expect(cues.ignored).toBe("");
    heard({ ignored: "GO for 1 of Ada ignored.", ignored_count: 3 });
    expect(cues.ignored).toBe("GO for 1 of Ada ignored.");
    now = 20_000;
    heard({ ignored: "GO for 1 of Ada ignored.", ignored_count: 3 });
    expect(cues.ignored).toBe("");
  });
});

describe("what a page of cues says", () => {
  const panicked = (panics: number, change: Partial<CueListStatus> = {}): void => {
    number += 1;
    const characters = { one: { ...CHARACTER, panics }, two: CHARACTER };
    const state = { type: "state", epoch: 1, number, time: 0, characters, cues: { ...STATUS, ...way(change) } };
    show.receive(state as unknown as State);
  };

  it("says whose look a panic has taken off, who pressed it, and how it comes back, until that has come", () => {
    const current = named(cue("1"));
    panicked(0, { current });
    expect(cues.panicked).toBe("");
    panicked(1, { current });
    expect(cues.panicked).toBe(
      "PANIC One, pressed at another page. The look of cue 1 is off: Assert (A) brings it back.",
    );
    cues.assertLook();
    expect(cues.panicked).toBe("");
    cues.panic();
    panicked(2, { current });
    expect(cues.panicked).toContain("pressed here");
    panicked(2, { current: named(cue("3")) });
    expect(cues.panicked).toBe("");
  });

  it("takes away what is not true any more", async () => {
    heard(way({ standby: null }));
    cues.go();
    expect(show.notice).toContain("No cue stands by");
    heard();
    expect(show.notice).toBeNull();
    heard({ ignored: "GO ignored: 1 stands by.", ignored_count: 3 });
    expect(cues.ignored).not.toBe("");
    heard({ ...way({ standby: { ...FIRST, number: "5" } }), ignored: "GO ignored: 1 stands by.", ignored_count: 3 });
    expect(cues.ignored).toBe("");
    show.setOnline(false);
    show.setOnline(true);
    heard();
    expect(show.notice).toContain("is back");
    now = 6000;
    heard();
    expect(show.notice).toBeNull();
    documents.main = [];
    heard({ ...way({ standby: null }), edits: 4 });
    await settled();
    cues.go();
    expect(show.notice).toContain("No cues yet");
  });

  it("says that a record found nothing, once it is there", async () => {
    let came = 0;
    const told = (): void => {
      came += 1;
    };
    cues.add({ type: "record_cue" }, undefined, told);
    expect(came).toBe(0);
    documents.main = [cue("1"), cue("2"), cue("3"), cue("4")];
    heard({ edits: 4 });
    await settled();
    expect([came, show.notice]).toEqual([1, expect.stringContaining("Cue 4 is empty")]);
  });
});

describe("what a page of cues edits", () => {
  it("reads the list again whenever it was edited", async () => {
    heard();
    await settled();
    expect(fetched).toEqual(["main"]);
    documents.main = [cue("1")];
    edits = 4;
    heard({ edits: 4 });
    await settled();
    expect(cues.list.map((each) => each.number)).toEqual(["1"]);
  });

  it("opens what it has recorded once that is there", async () => {
    cues.setEditing(true);
    cues.add({ type: "record_cue" });
    documents.main = [cue("1"), cue("2"), cue("3"), cue("4")];
    heard({ edits: 4 });
    await settled();
    expect(cues.edited).toBe("id4");
  });

  it("tells the field alone why the show rejects what was typed there", () => {
    const reasons: string[] = [];
    cues.change({ type: "put_cue", cue: "id1", number: "x" }, (reason) => reasons.push(reason));
    const id = (last() as { id: string }).id;
    show.receive({ type: "refused", reason: "a cue cannot be numbered 'x'", id, held: [] });
    expect(reasons).toEqual(["a cue cannot be numbered 'x'"]);
    expect(show.notice).toBeNull();
  });

  it("begins another edit of a move from the one that is on its way, until the show rejects it or has it", async () => {
    const move = { goal: { dog: 1 }, seconds: 2, easing: "smooth", delay: 0 };
    documents.main = [cue("1", { moves: { "one/face": move } })];
    heard({ edits: 4 });
    await settled();
    const shown = cues.list[0] as Cue;
    const newest = () => cues.newest(shown).moves["one/face"];
    cues.change({ type: "put_move", cue: "id1", part: "one/face", ...move, goal: { cat: 1 } });
    expect(newest()).toEqual({ ...move, goal: { cat: 1 } });
    heard({ edits: 5 }); // another's edit
    await settled();
    cues.change({ type: "put_move", cue: "id1", part: "one/face", ...(newest() ?? move), seconds: 5 });
    const sent = { ...move, goal: { cat: 1 }, seconds: 5 };
    expect(last()).toMatchObject(sent);
    documents.main = [cue("1", { moves: { "one/face": sent } })];
    heard({ edits: 7 });
    await settled();
    documents.main = [cue("1", { moves: { "one/face": move } })]; // taken back
    heard({ edits: 8 });
    await settled();
    expect(newest()).toEqual(move);
    cues.change({ type: "put_move", cue: "id1", part: "one/face", ...move, goal: { dgo: 1 } }, () => undefined);
    show.receive({ type: "refused", reason: "no", id: (last() as { id: string }).id, held: [] });
    expect(newest()).toEqual(move);
  });

  it("believes an edit that never comes for five seconds alone", () => {
    cues.change({ type: "put_cue", cue: "id1", actions: [] });
    const action = { does: "osc", to: "desk:9000", what: "/go 1", delay: 0, voice: "", sound: "" } as const;
    cues.change({ type: "put_cue", cue: "id1", actions: [action] });
    const first = cues.list[0] as Cue;
    expect(cues.newest(first).actions).toEqual([action]);
    now = 5000;
    expect(cues.newest(first)).toEqual(first);
  });

  it("puts the cursor into the label of an empty cue that was begun here, and of no other", async () => {
    cues.setEditing(true);
    cues.edit("id3");
    cues.begin();
    expect([last(), cues.edited]).toMatchObject([{ type: "put_cue", after: "id3" }, null]);
    documents.main = [cue("1"), cue("2"), cue("3"), cue("4")];
    heard({ edits: 4 });
    await settled();
    expect([cues.edited, cues.begun]).toEqual(["id4", "id4"]);
    [cues.begun, documents.main] = [null, [...documents.main, cue("5")]];
    heard({ edits: 5 });
    await settled();
    expect([cues.edited, cues.begun]).toEqual(["id4", null]);
  });

  it("lets keys play while editing until a field is entered", () => {
    cues.setEditing(true);
    cues.letKeysPlay(true);
    cues.setTyping(true);
    cues.setTyping(false);
    expect(cues.keysPlay).toBe(false);
    cues.letKeysPlay(true);
    cues.setEditing(false);
    expect(cues.keysPlay).toBe(false);
  });

  it("takes in a list as text, with the lines that are wrong", async () => {
    expect(await cues.takeIn("[[cue]]")).toBe("line 1: a cue has no number");
    expect(posted).toEqual(["main [[cue]]"]);
    [refusal, posted] = ["", []];
    expect(await cues.takeIn("x")).toBe("");
    heard({ locked: true });
    expect(await cues.takeIn("x")).toContain("Show mode");
    expect(posted).toEqual(["main x"]);
  });

  it("goes on editing where the page before did", async () => {
    cues = new CueStore(show, "", () => now, request as typeof fetch);
    cues.resume("id3");
    heard();
    await settled();
    expect([cues.editing, cues.edited]).toEqual([true, "id3"]);
  });

  it("stops editing while the show mode is on", () => {
    cues.setEditing(true);
    heard({ locked: true });
    expect(cues.editing).toBe(false);
    const reasons: string[] = [];
    cues.change({ type: "drop_cue", cue: "id1" }, (reason) => reasons.push(reason));
    expect(reasons[0]).toContain("Show mode");
    expect(sent).toEqual([]);
  });

  it("takes back the edit that its presser saw", () => {
    cues.undo("undo");
    expect(last()).toMatchObject({ type: "undo_cues", seen: 3 });
    cues.undo("redo");
    expect(show.notice).toContain("No edit of cues");
  });

  it("follows a list that it renames, and falls to the chosen one when its own has gone", async () => {
    cues.renameList("Act 1", () => undefined);
    documents = { "Act 1": [cue("7")] };
    heard({ chosen: "Act 1", lists: { "Act 1": MAIN }, edits: 4 });
    await settled();
    expect([cues.name, cues.list[0]?.number]).toEqual(["Act 1", "7"]);
    documents = { main: [cue("1")] };
    heard({ edits: 5 });
    await settled();
    expect([cues.name, cues.list[0]?.number]).toEqual(["main", "1"]);
  });
});
