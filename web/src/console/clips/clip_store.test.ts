import { beforeEach, describe, expect, it } from "vitest";
import type { ClipOutline, ClipPass, FromClient, FromServer, State } from "../../link/messages";
import { ConsoleStore } from "../store/console_store";
import { ClipStore } from "./clip_store";
import type { Marks } from "./page_marks";

const LANE = { parts: ["mouth" as const], weight: 1, muted: false, shift: 0, start: 0, stop: 8, spans: [], moves: {} };
const outline = (...names: string[]): ClipOutline => ({
  name: "line",
  start: 0.5,
  stop: 8,
  trimmed: true,
  blend_in: 0.3,
  blend_out: 0.3,
  loop: false,
  speed: 1,
  sound: "",
  sound_at: 0,
  lanes: names.map((name) => ({ ...LANE, name })),
  edits: 1,
});

let [sent, number, time]: [FromClient[], number, number] = [[], 0, 0];
let stored: Record<string, ClipOutline>;
let waiting: (() => void)[];
let [panics, cues]: [number, object[]] = [0, []];
let show: ConsoleStore;
let clips: ClipStore;

const tick = (at: number, playing: object[] = [], channels: Record<string, number> = {}): void => {
  number += 1;
  time = at;
  const one = {
    channels,
    head: [0, 0, 0],
    gaze: [0, 0],
    held: null,
    panics,
    label: "Kaori",
    face_call: null,
    expression_call: null,
    home_face: "",
    clips: playing,
  };
  show.receive({ type: "state", epoch: 1, number, time, characters: { one, two: one } } as unknown as State);
};
const work = (edits: number, ...passes: Partial<ClipPass>[]): void =>
  show.receive({ type: "clip_work", edits, passes: passes as ClipPass[] });
const settle = async (): Promise<void> => {
  for (let turn = 0; turn < 6; turn += 1) await Promise.resolve();
};
const kinds = (): string[] => {
  show.flush();
  return sent.map(({ type }) => type);
};
const last = (): FromClient | undefined => {
  show.flush();
  return sent.at(-1);
};

beforeEach(async () => {
  [sent, stored, waiting] = [[], { line: outline("mouth", "brows") }, []];
  show = new ConsoleStore(
    (message) => sent.push(message),
    () => 0,
    "page",
  );
  const request = async (address: string) => {
    if (address === "/sounds?name=monologue")
      return { ok: true, json: async () => ({ sound: "key", name: "monologue", seconds: 4 }) } as Response;
    if (address.startsWith("/sounds")) return { ok: false, text: async () => "send WAV, MP3 or Ogg." } as Response;
    if (address.startsWith("/cue_lists")) return { status: 200, json: async () => ({ cues }) } as unknown as Response;
    const found = stored[decodeURIComponent(address.replace("/clip_outlines/", ""))];
    return { ok: true, status: found ? 200 : 204, json: async () => found } as unknown as Response;
  };
  clips = new ClipStore(show, "page", request as typeof fetch, (act) => waiting.push(act));
  show.setOnline(true);
  tick(100);
  show.receive({ type: "clips", names: ["line"] });
  await settle();
});

describe("the store of clips", () => {
  it("shows the first clip from its start, and reads it again after each edit", async () => {
    expect([clips.name, clips.cursor, clips.lanes.length]).toEqual(["line", 0.5, 2]);
    const pass = {
      character: "one",
      name: "line",
      lane: "head",
      parts: ["head" as const],
      began: 100,
      start: 0,
      speed: 1,
    };
    work(1, pass);
    stored.line = outline("mouth", "brows", "head");
    work(2);
    await settle();
    expect([clips.lanes.length, clips.lane]).toEqual([3, 2]); // what is new is chosen
  });

  it("plays from the place that is marked, goes on from another, and stops", () => {
    clips.seek(2.5);
    clips.togglePlay();
    expect(last()).toMatchObject({ type: "play_clip", character: "one", name: "line", start: 2 });
    tick(101, [{ name: "line", elapsed: 3, seconds: 7.5, share: 1 }]);
    expect(clips.position).toBe(3.5);
    clips.seek(6);
    expect(last()).toMatchObject({ type: "play_clip", start: 5.5 });
    clips.togglePlay();
    expect(last()).toMatchObject({ type: "stop_clip", name: "line" });
  });

  it("records what is armed after three seconds, which can be called off", () => {
    clips.arm("mouth", "only");
    clips.record();
    expect([clips.counting, kinds()]).toEqual([3, []]);
    clips.discard();
    for (const act of waiting.splice(0)) act();
    expect([clips.counting, kinds()]).toEqual([null, []]);
    clips.record();
    for (let second = 0; second < 3; second += 1) for (const act of waiting.splice(0)) act();
    expect(last()).toMatchObject({ type: "record_clip", name: "line", parts: ["mouth"], lane: "mouth 2", start: 0.5 });
  });

  it("records at the speed that is chosen, and says that no sound is heard then", () => {
    clips.setCountIn(false);
    clips.setPassSpeed(0.5);
    clips.record();
    expect(last()).toMatchObject({ type: "record_clip", name: "line", speed: 0.5 });
    expect(show.notice).toBe(null);
    const pass = { character: "one", name: "line", lane: "2", parts: [], by: "Anna", began: 100, start: 1, speed: 0.5 };
    work(1, pass);
    tick(104);
    expect(clips.position).toBe(3);
    work(2);
    clips.choose("new");
    clips.setSound("monologue");
    clips.record();
    expect(last()).toMatchObject({ name: "new", sound: "monologue", speed: 0.5 });
    expect(show.notice).toBe("Not at full speed: no sound is heard in this pass.");
  });

  it("keeps and discards the pass, and says which", () => {
    show.receive({ type: "welcome", name: "Anna" } as unknown as FromServer);
    const pass = {
      character: "one",
      name: "line",
      lane: "mouth 2",
      parts: ["mouth" as const],
      by: "Anna",
      began: 100,
      start: 0.5,
      speed: 1,
    };
    work(1, pass);
    tick(102);
    expect(clips.position).toBe(2.5);
    clips.togglePlay();
    expect(kinds()).toEqual(["copy_clip", "drop_clip", "keep_pass"]);
    expect(last()).toMatchObject({ type: "keep_pass", character: "one", keep: true });
    work(2);
    expect(show.notice).toContain("Kept in line: mouth, lane mouth 2, is a lane now");
    work(2, pass);
    clips.discard();
    expect(last()).toMatchObject({ type: "keep_pass", keep: false });
    work(2);
    expect(show.notice).toBe("The pass is discarded.");
  });

  it("records a span of a lane again from before it, and puts the pass in its place", () => {
    clips.setCountIn(false);
    clips.select({ from: 3, to: 5 });
    clips.recordAgain();
    expect(last()).toMatchObject({ type: "record_clip", parts: ["mouth"], lane: "again", start: 1 });
    work(1, {
      character: "one",
      name: "line",
      lane: "again",
      parts: ["mouth"],
      by: "",
      began: 100,
      start: 1,
      speed: 1,
    });
    tick(103.9);
    expect(last()).toMatchObject({ type: "record_clip" });
    tick(104.2);
    expect(kinds().slice(1)).toEqual(["copy_clip", "drop_clip", "keep_pass", "replace_span"]);
    expect(last()).toMatchObject({ lane: "1", by: "again", start: 3, stop: 5 });
    work(2);
    expect(show.notice).toBe("Recorded again from 0:03.0 to 0:05.0.");
  });

  it("takes back what no message takes back by the clip as it was, and does it again by the clip as it is", () => {
    clips.dropLane(1);
    expect(kinds()).toEqual(["copy_clip", "drop_clip", "drop_lane"]);
    const [{ to: before }] = sent as unknown as [{ to: string }];
    sent = [];
    show.undo();
    expect(kinds()).toEqual(["copy_clip", "drop_clip", "drop_clip", "restore_clip", "rename_clip"]);
    expect(last()).toMatchObject({ name: before, to: "line" });
    const [{ to: after }] = sent as unknown as [{ to: string }];
    sent = [];
    show.redo();
    expect(kinds()).toEqual(["copy_clip", "drop_clip", "drop_clip", "restore_clip", "rename_clip"]);
    expect(last()).toMatchObject({ name: after, to: "line" });
  });

  it("takes nothing back that a server of before has laid aside", () => {
    clips.dropLane(1);
    clips.shift(0, 0.1);
    const state = show.state as State;
    show.receive({ ...state, epoch: 2, number: 1 });
    expect(show.history.steps.undo.map(({ what }) => what)).toEqual(["Lane 1 0.1 s later"]);
  });

  it("drops a clip again that a pass has made", () => {
    clips.choose("new");
    work(1, { character: "one", name: "new", lane: "all", parts: ["mouth"], by: "", began: 100, start: 0, speed: 1 });
    clips.keep();
    expect(kinds()).toEqual(["keep_pass"]);
    show.undo();
    expect(last()).toMatchObject({ type: "drop_clip", name: "new" });
    show.redo();
    expect(last()).toMatchObject({ type: "restore_clip", name: "new" });
  });

  it("keeps the lane that is chosen while the clip is gone for a moment", async () => {
    clips.chooseLane(1);
    clips.select({ from: 3, to: 5 });
    show.receive({ type: "clips", names: [] });
    await settle();
    expect(clips.outline).toBeNull();
    show.receive({ type: "clips", names: ["line"] });
    await settle();
    expect([clips.lane, clips.span]).toEqual([1, { from: 3, to: 5 }]);
  });

  it("takes edits of lanes and deleted clips back", () => {
    clips.shift(1, 0.25);
    expect(last()).toMatchObject({ type: "edit_lane", lane: "2", shift: 0.25 });
    show.undo();
    expect(last()).toMatchObject({ type: "edit_lane", lane: "2", shift: 0 });
    clips.drop();
    show.undo();
    expect(last()).toMatchObject({ type: "restore_clip", name: "line" });
  });

  it("adds up quick presses that shift a lane, and takes them back in one step", () => {
    for (let press = 0; press < 8; press += 1) clips.shift(1, 0.01); // nothing of it is heard yet
    expect(last()).toMatchObject({ type: "edit_lane", lane: "2", shift: 0.08 });
    expect(show.history.steps.undo).toHaveLength(1);
    clips.shift(0, 0.1); // another lane: another step
    expect(show.history.steps.undo).toHaveLength(2);
    show.undo();
    show.undo();
    expect(last()).toMatchObject({ lane: "2", shift: 0 });
    clips.shift(1, 0.01);
    for (const act of waiting.splice(0)) act(); // a second later
    clips.shift(1, 0.01);
    expect(show.history.steps.undo).toHaveLength(2);
    clips.shiftTo(1, 0.25);
    expect(last()).toMatchObject({ shift: 0.25 });
  });

  it("marks a span by its ends, and none that ends before it begins", () => {
    clips.seek(2);
    clips.mark("from");
    clips.seek(4);
    clips.mark("to");
    expect(clips.span).toEqual({ from: 2, to: 4 });
    clips.select(null);
    clips.mark("to");
    expect([clips.span, show.notice]).toEqual([null, expect.stringContaining("press I")]);
  });

  it("has a sound heard with the clip, and with a new one from its first pass on", async () => {
    clips.seek(2);
    await clips.bringSound(new File([], "monologue.wav"));
    expect(last()).toMatchObject({ type: "edit_clip", sound: "monologue", sound_at: 2 });
    clips.choose("new");
    await clips.bringSound(new File([], "monologue.wav"));
    clips.setCountIn(false);
    clips.record();
    expect(last()).toMatchObject({ type: "record_clip", name: "new", sound: "monologue", start: null });
    await clips.bringSound(new File([], "story.txt"));
    expect(show.notice).toBe("story.txt was not added: send WAV, MP3 or Ogg.");
  });

  it("knows the sound of a clip by its name, by one of before, and by its key", () => {
    show.receive({ type: "sounds", sounds: [{ name: "line 1", sound: "ab", seconds: 4, former: ["first"] }] });
    clips.choose("new");
    for (const called of ["line 1", "first", "ab"]) {
      clips.setSound(called);
      expect(clips.namedSound?.name).toBe("line 1");
    }
    clips.setSound("gone");
    expect(clips.namedSound).toBeNull();
    clips.setSound("ab");
    clips.renameSound("Opening");
    expect(last()).toMatchObject({ type: "rename_sound", name: "line 1", to: "Opening" });
    clips.dropSound();
    expect(last()).toMatchObject({ type: "drop_sound", name: "line 1" });
    show.receive({ type: "sound_dropped", name: "line 1", needed_by: ["the clip new"] });
    expect(show.notice).toContain("needed by the clip new");
  });

  it("says why a clip plays without its sound, once", () => {
    const playing = [{ name: "line", elapsed: 1, seconds: 7, share: 1, silent: "no stage plays sounds." }];
    tick(101, playing);
    expect(show.notice).toContain("no stage plays sounds.");
    show.say(null);
    tick(102, playing);
    expect(show.notice).toBeNull();
  });

  it("goes on with what was armed and chosen before a reload", async () => {
    const kept: Marks[] = [];
    const marks = { read: () => kept.at(-1) ?? {}, write: (now: Marks) => kept.push(now) };
    const begin = async (): Promise<ClipStore> => {
      const request = async () => ({ ok: true, status: 200, json: async () => stored.line }) as unknown as Response;
      const begun = new ClipStore(show, "page", request as typeof fetch, () => 0, marks);
      show.receive({ type: "clips", names: ["another", "line"] });
      await settle();
      return begun;
    };
    const before = await begin();
    before.choose("line");
    await settle();
    before.arm("mouth", "only");
    before.setCountIn(false);
    before.chooseLane(1);
    before.chooseCharacter("two");
    const after = await begin();
    expect([after.name, after.lane, [...after.armed], after.countsIn, after.character]).toEqual([
      "line",
      1,
      ["mouth"],
      false,
      "two",
    ]);
  });

  it("asks before it ends a pass that somebody else records", () => {
    show.receive({ type: "welcome", name: "Ben" } as unknown as FromServer);
    work(1, {
      character: "one",
      name: "line",
      lane: "mouth 2",
      parts: ["mouth"],
      by: "Anna",
      began: 100,
      start: 0.5,
      speed: 1,
    });
    for (const press of [() => clips.record(), () => clips.togglePlay(), () => clips.keep(), () => clips.discard()]) {
      show.say(null);
      press();
      expect([show.notice, kinds()]).toEqual(["Anna records mouth of Kaori in line: it goes on.", []]);
    }
    const [, discard] = show.offers;
    if (discard !== undefined && "act" in discard) discard.act();
    expect(last()).toMatchObject({ type: "keep_pass", keep: false });
  });

  it("says that a pass goes on after a panic", () => {
    work(1, {
      character: "one",
      name: "line",
      lane: "mouth 2",
      parts: ["mouth"],
      by: "",
      began: 100,
      start: 0.5,
      speed: 1,
    });
    panics += 1;
    tick(101);
    expect(show.notice).toContain("the pass goes on, and records the neutral face");
    show.say(null);
    tick(102);
    expect(show.notice).toBeNull();
  });

  it("begins no clip under a name that another has", () => {
    expect([clips.begin("LINE"), clips.name]).toEqual([false, "line"]);
    expect(show.notice).toBe("There is a clip line already: give another name.");
    expect([clips.begin("new"), clips.name]).toEqual([true, "new"]);
  });

  it("says which cues call a clip that is deleted, and shows another", async () => {
    const move = (goal: object) => ({ moves: { "one/clip": { goal } } });
    cues = [
      { number: "1", ...move({ line: 1, ":start": 2 }) },
      { number: "2", ...move({ other: 1 }) },
    ];
    show.receive({ ...(show.state as State), number: 1e6, cues: { lists: { main: {} } } } as unknown as State);
    clips.drop();
    await settle();
    expect(show.notice).toBe("line is deleted, and cue 1 calls it: nothing plays there now.");
    expect(clips.name).toBe("");
  });

  it("says once what hands hold above a clip that plays, and lets go of it", () => {
    const playing = [{ name: "line", elapsed: 1, seconds: 7, share: 1 }];
    tick(101, playing, { jawOpen: 1.5, browInnerUp: 0.4 }); // the clip has lanes of the mouth alone
    expect(show.notice).toBe("Hands hold jawOpen of Kaori, above what the clip plays there.");
    show.say(null);
    tick(102, playing, { jawOpen: 1.5 });
    expect(show.notice).toBeNull();
    clips.record();
    expect([show.notice, clips.counting]).toEqual([null, 3]); // the mouth is armed: its hand is what is recorded
    clips.discard();
    clips.arm("mouth", "beside");
    clips.record();
    expect(show.notice).toContain("Hands hold jawOpen");
    const [offer] = show.offers;
    if (offer !== undefined && "act" in offer) offer.act();
    expect(last()).toMatchObject({ type: "set_channel", character: "one", name: "jawOpen", value: 0 });
    show.undo();
    expect(last()).toMatchObject({ type: "set_channel", name: "jawOpen", value: 1.5 });
  });

  it("does nothing that its role may not do, and says why", () => {
    clips.setAccess({ role: "operate", name: "Anna", asked: true });
    clips.record();
    clips.shift(0, 1);
    expect([kinds(), show.notice]).toEqual([[], expect.stringContaining('needs "edit"')]);
    clips.togglePlay();
    expect(last()).toMatchObject({ type: "play_clip" });
  });
});
