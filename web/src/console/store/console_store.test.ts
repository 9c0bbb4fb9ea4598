import { beforeEach, describe, expect, it } from "vitest";
import type { CharacterState, FromClient, Manifest, State } from "../../link/messages";
import { ConsoleStore } from "./console_store";
import { ECHO } from "./held_values";
import { HEARD_MS, MEANT_MS } from "./unheard_panic";

const CALM: CharacterState = {
  faces: { generic: 1 },
  expressions: { neutral: 1 },
  channels: {},
  head: [0, 0, 0],
  gaze: [0, 0],
  eyes: [0, 0, 0, 0],
  added: {},
  face_call: null,
  expression_call: null,
  face_fader: 0,
  expression_fader: 0,
  panics: 0,
  home_face: "generic",
  home_seconds: 2,
  home_next: false,
  label: "One",
  place: { x: 0, depth: 0, size: 1, turn: 0 },
  presence: 1,
  leaves: false,
  regions: {},
  region_calls: {},
  layers: {},
  held: null,
  motion: null,
  speech: null,
  spoken: "",
  clips: [],
  macros: {},
  pads: {},
  springs: {},
  complexion: [],
  folds: 1,
  skin: {},
  figure: null,
  idle: [0, 0, 0] as [number, number, number],
};
const REST: State = {
  type: "state",
  epoch: 1,
  number: 1,
  time: 0,
  revision: 1,
  characters: { one: CALM },
  light: { theatre: 1 },
  light_call: null,
  framing: { "*": 1 },
  framing_call: null,
  gaze_points: {},
  black: 0,
  black_goal: 0,
  memories: [],
  note: "",
  began: 0,
  cues: null,
  bus: "air",
  looked_at: null,
};
/** A state in which the first character has something else on air. */
const withOne = (change: Partial<CharacterState>): State => ({ ...REST, characters: { one: { ...CALM, ...change } } });
const expression = (name: string) => ({ name, label: name, kind: "arkit", region: "", eyes: [0, 0, 0, 0] });
const MANIFEST = {
  faces: [{ name: "generic", label: "Generic" }],
  expressions: ["mouthSmileLeft", "mouthSmileRight", "jawOpen"].map(expression),
} as unknown as Manifest;

let now: number;
let sent: FromClient[];
let store: ConsoleStore;

beforeEach(() => {
  now = 1000;
  sent = [];
  store = new ConsoleStore(
    (message) => sent.push(message),
    () => now,
    "me",
  );
  store.setManifest(MANIFEST);
  store.receive(REST);
  store.setOnline(true);
});

describe("calls", () => {
  it("carry the chosen time and easing, and each its own id", () => {
    store.setTiming("face", { seconds: 4, easing: "late" });
    store.call("face", "old");
    store.call("face", "old");
    expect(sent).toMatchObject([
      { type: "call_face", character: "one", name: "old", seconds: 4, easing: "late" },
      { type: "call_face", character: "one", name: "old" },
    ]);
    expect(new Set(sent.map((message) => "id" in message && message.id)).size).toBe(2);
  });

  it("keep the time of a face and of an expression apart", () => {
    store.setTiming("face", { byHand: true });
    store.call("expression", "smile");
    expect(sent).toMatchObject([{ type: "call_expression", character: "one", seconds: 0.5 }]);
  });
});

describe("the point of a pad", () => {
  const moved = () => sent.filter((message) => message.type === "move_pad");

  it("is moved along the dimensions that a hand is on, in one message, and shows what the show says once it is off", () => {
    store.receive(withOne({ pads: { moods: { place: [0.5, -0.25], plays: true } } }));
    const [x, y] = [store.pad("moods", "x"), store.pad("moods", "y")];
    expect([x.value(now), y.value(now), x.control]).toEqual([0.5, -0.25, "move_pad:moods"]);
    x.grip(0.75);
    store.flush();
    y.nudge(0.1);
    store.flush();
    expect(moved()).toEqual([
      { type: "move_pad", character: "one", name: "moods", x: 0.75 },
      { type: "move_pad", character: "one", name: "moods", x: 0.75, y: 0.1 },
    ]);
    x.leave();
    now += ECHO + 1;
    expect([x.value(now), y.value(now), store.pad("mouth", "x").value(now)]).toEqual([0.5, -0.25, 0]);
  });
});

describe("a T-bar that was left in the middle", () => {
  const call = {
    target: "old",
    progress: 0.4,
    remaining: null,
    by_hand: true,
    fader: 0.4,
    pickup: 0.4,
    start: { generic: 1 },
  };
  const types = (): [string, unknown][] =>
    sent.map((message) => [message.type, "value" in message ? message.value : null]);

  it("goes to its nearest end at a new call: before it where nothing runs, after it where it would move the old one", () => {
    for (const [stands, end] of [
      [0.4, 0],
      [0.7, 1],
    ] as const) {
      sent.length = 0;
      now += 10_000;
      store.receive(withOne({ face_fader: stands }));
      now += 10_000;
      store.call("face", "old");
      store.flush();
      expect(types()).toEqual([
        ["fade_face", end],
        ["call_face", null],
      ]);
    }
    sent.length = 0;
    store.receive(withOne({ face_fader: 0.4, face_call: call }));
    now += 10_000;
    store.setTiming("face", { byHand: true });
    store.call("face", "kaori");
    store.flush();
    expect(types()).toEqual([
      ["call_face", null],
      ["fade_face", 0],
    ]);
  });

  it("stays where a hand may be on it, here or elsewhere, and where a timed call would be picked up", () => {
    store.receive(withOne({ face_fader: 0.4 }));
    store.receive({ type: "hands", hands: { "one/fade_face": "Ana" } });
    store.call("face", "old");
    store.receive({ type: "hands", hands: {} });
    store.bar("face").grip(0.5);
    store.call("face", "old");
    store.bar("face").leave();
    now += 10_000;
    store.receive(withOne({ face_fader: 0.5, face_call: call }));
    now += 10_000;
    store.call("face", "kaori");
    store.flush();
    expect(types().filter(([type, value]) => type === "fade_face" && value !== 0.5)).toEqual([]);
  });

  it("goes to its end although the echo of the own hand comes late", () => {
    store.bar("face").grip(0.4);
    store.bar("face").leave();
    now += 10_000;
    store.receive(withOne({ face_fader: 0.4 })); // a busy machine had it all that time
    sent.length = 0;
    store.call("face", "old");
    store.flush();
    expect(types()).toContainEqual(["fade_face", 0]);
  });

  it("is left to a panic that is on its way", () => {
    store.receive(withOne({ face_fader: 0.7 }));
    now += 10_000;
    store.panic();
    store.call("face", "old");
    expect(types().map(([type]) => type)).toEqual(["panic", "call_face"]);
  });

  it("has nothing to release in a call by hand, and says so", () => {
    store.receive(withOne({ face_call: call }));
    expect(store.releasable("face")).toBe(false);
    store.release("face");
    expect([sent, store.notice]).toEqual([[], expect.stringContaining("Nothing to release")]);
  });
});

describe("calls by hand", () => {
  it("wait for the T-bar, and the seconds of before are there again afterwards", () => {
    store.setTiming("face", { seconds: 4 });
    store.setTiming("face", { byHand: true });
    store.call("face", "old");
    store.setTiming("face", { byHand: false });
    store.call("face", "old");
    expect(sent).toMatchObject([{ seconds: null }, { seconds: 4 }]);
    store.setTiming("face", { byHand: true });
    store.setTiming("face", { seconds: 1 });
    expect(store.callSeconds("face")).toBe(1);
  });
});

describe("poses", () => {
  const calling = {
    target: "bow",
    start: { stand: 1 },
    progress: 0.2,
    remaining: null,
    by_hand: true,
    fader: 0.2,
    pickup: 0.2,
  };
  const bowing = {
    ...{ poses: { bow: 0.2, stand: 0.8 }, regions: {}, bodies: { own: 1 } },
    ...{ pose_call: calling, region_calls: {}, body_call: null, fader: 0.2 },
  };

  it("are called in the time of expressions, by hand too, and a region alone in its seconds", () => {
    store.setTiming("expression", { seconds: 2, easing: "late" });
    store.call("pose", "bow");
    store.setTiming("expression", { byHand: true });
    store.call("pose", "bow");
    store.call("pose", "wave", "arm_left");
    expect(sent).toMatchObject([
      { type: "call_pose", character: "one", name: "bow", seconds: 2, easing: "late", region: null },
      { type: "call_pose", name: "bow", seconds: null, region: null },
      { type: "call_pose", name: "wave", seconds: 2, region: "arm_left" },
    ]);
  });

  it("have a T-bar of their own", () => {
    store.receive(withOne({ figure: bowing }));
    expect([store.callOf("pose"), store.bar("pose").value(now)]).toEqual([calling, 0.2]);
    store.bar("pose").nudge(0.5);
    store.flush();
    expect(sent).toEqual([{ type: "fade_pose", character: "one", value: 0.5 }]);
  });
});

describe("lights", () => {
  it("come in the time of a face, and never by hand", () => {
    store.setTiming("face", { seconds: 4, easing: "late" });
    store.callLight("flat");
    store.setTiming("face", { byHand: true });
    store.callLight("portrait");
    expect(sent).toMatchObject([
      { type: "call_light", name: "flat", seconds: 4, easing: "late" },
      { type: "call_light", name: "portrait", seconds: 4 },
    ]);
    expect(new Set(sent.map((message) => "id" in message && message.id)).size).toBe(2);
  });
});

describe("black", () => {
  it("comes in the time of a face or at once, and goes again from wherever it is on its way", () => {
    store.setTiming("face", { seconds: 4, easing: "late" });
    store.callBlack();
    store.receive({ ...REST, number: 2, black: 0.3, black_goal: 1 });
    store.callBlack(0);
    store.receive({ ...REST, number: 3, black: 0.5, black_goal: 0.5 });
    store.callBlack(0);
    expect(sent).toMatchObject([
      { type: "call_black", black: 1, seconds: 4, easing: "late" },
      { type: "call_black", black: 0, seconds: 0 },
      { type: "call_black", black: 1, seconds: 0 }, // a fader stands half-way
    ]);
  });

  it("is told once where it begins to come, and once where it begins to go", () => {
    let told = 0;
    store.listen("black", () => {
      told += 1;
    });
    const goals = [0, 1, 1, 1, 0, 0].map((black_goal, at) => {
      store.receive({ ...REST, number: at + 2, black: 0.1 * at, black_goal });
      return told;
    });
    expect(goals).toEqual([0, 1, 1, 1, 2, 2]);
  });
});

/** Takes what the notice offers. */
function act(label: string): void {
  const offer = store.offers.find((candidate) => candidate.label === label);
  if (offer !== undefined && "act" in offer) offer.act();
}

describe("clearing", () => {
  const CHANNELS = { mouthSmileLeft: 0.4, mouthSmileRight: 0.7, jawOpen: 0 };
  const clear = (): void => {
    store.receive(withOne({ channels: CHANNELS }));
    store.clearChannels(Object.keys(CHANNELS));
    store.flush();
  };
  const values = () => sent.map((message) => message.type === "set_channel" && [message.name, message.value]);

  it("is taken back as it was, each side its own", () => {
    clear();
    expect(values()).toEqual([
      ["mouthSmileLeft", 0],
      ["mouthSmileRight", 0],
    ]);
    expect(store.notice).toBe("Cleared 2 faders.");
    sent.length = 0;
    act("Undo");
    store.flush();
    expect(values()).toEqual([
      ["mouthSmileLeft", 0.4],
      ["mouthSmileRight", 0.7],
    ]);
    expect(store.notice).toBe("Undone: clear 2 faders.");
    sent.length = 0;
    act("Redo");
    store.flush();
    expect(values()).toEqual([
      ["mouthSmileLeft", 0],
      ["mouthSmileRight", 0],
    ]);
  });

  it("says nothing where nothing is played", () => {
    store.clearChannels(["jawOpen"]);
    expect([store.notice, store.offers]).toEqual([null, []]);
  });

  it("is not taken back over a panic", () => {
    clear();
    store.receive(withOne({ panics: 1 }));
    sent.length = 0;
    store.undo();
    store.flush();
    expect(sent).toEqual([]);
    expect(store.notice).toMatch(/panic was pressed/);
  });
});

describe("a hand at another console", () => {
  const heard = (jawOpen: number) => store.receive(withOne({ channels: { jawOpen } }));

  it("is named on what it moves, and on nothing else", () => {
    store.receive({
      type: "hands",
      hands: { "one/set_channel:jawOpen": "Ana", "one/set_gaze": "Ben", "one/fade_face": "Cy" },
    });
    const knobs = [
      store.channel("jawOpen"),
      store.gaze("yaw"),
      store.bar("face"),
      store.head("roll"),
      store.bar("expression"),
    ];
    expect(knobs.map((knob) => store.otherOn(knob))).toEqual(["Ana", "Ben", "Cy", null, null]);
    store.setOnline(false);
    expect(store.otherOn(store.gaze("pitch"))).toBeNull();
  });

  it("has a fader that this one holds still, and this one goes on from there", () => {
    const jaw = store.channel("jawOpen");
    jaw.grip(0.8);
    store.receive({ type: "hands", hands: { "one/set_channel:jawOpen": "Ana" } });
    now += ECHO;
    heard(0.2);
    expect([jaw.value(now), jaw.gripped()]).toEqual([0.8, true]); // it has just moved it
    now += 1;
    heard(0.3);
    expect([jaw.value(now), jaw.gripped()]).toEqual([0.3, false]);
    expect(jaw.touched()).toBe(true); // so the mark of the other hand stays yellow
    jaw.leave();
    expect([jaw.value(now), jaw.touched()]).toEqual([0.3, false]);
    jaw.grip(0.35);
    expect([jaw.value(now), jaw.gripped()]).toEqual([0.35, true]);
  });
});

describe("knobs", () => {
  it("show the hand at once, the server after the echo", () => {
    const jaw = store.channel("jawOpen");
    jaw.grip(0.6);
    expect(jaw.value(now)).toBe(0.6);
    jaw.leave();
    expect(jaw.value(now + ECHO - 1)).toBe(0.6);
    store.receive(withOne({ channels: { jawOpen: 0.2 } }));
    expect(jaw.value(now + ECHO)).toBe(0.2);
  });

  it("send one message for each parameter in a frame", () => {
    for (const value of [0.1, 0.2, 0.3]) store.channel("jawOpen").grip(value);
    store.head("yaw").grip(0.2);
    store.head("pitch").grip(-0.1);
    expect(sent).toEqual([]);
    store.flush();
    expect(sent).toEqual([
      { type: "set_channel", character: "one", name: "jawOpen", value: 0.3 },
      { type: "set_head", character: "one", yaw: 0.2, pitch: -0.1, roll: 0 },
    ]);
  });

  it("leave the parts of a direction that another console moves", () => {
    store.receive(withOne({ head: [0, 0, 0.4], gaze: [0.1, 0] }));
    store.head("yaw").grip(0.2);
    store.gaze("pitch").nudge(0.3);
    store.flush();
    expect(sent).toEqual([
      { type: "set_head", character: "one", yaw: 0.2, pitch: 0, roll: 0.4 },
      { type: "set_gaze", character: "one", yaw: 0.1, pitch: 0.3 },
    ]);
  });

  it("move left and right together only while they are linked", () => {
    store.channel("mouthSmileLeft").grip(0.5);
    store.flush();
    expect(sent.map((message) => "name" in message && message.name)).toEqual(["mouthSmileLeft", "mouthSmileRight"]);
    expect(store.channel("mouthSmileRight").value(now)).toBe(0.5);
    sent.length = 0;
    store.arrange({ linked: false });
    store.channel("mouthSmileLeft").grip(0.7);
    store.flush();
    expect(sent).toHaveLength(1);
  });

  it("show the T-bar where any hand left it", () => {
    store.receive(withOne({ face_fader: 0.8 }));
    expect(store.bar("face").value(now)).toBe(0.8);
    store.bar("face").grip(0.9);
    store.release("face");
    expect(sent.map(({ type }) => type)).toEqual(["fade_face", "release_face"]);
  });

  it("clear only what is on air, and no mirror by accident", () => {
    store.receive(withOne({ channels: { mouthSmileLeft: 0.4 } }));
    store.clearChannels(["mouthSmileLeft", "mouthSmileRight", "jawOpen"]);
    store.flush();
    expect(sent).toEqual([{ type: "set_channel", character: "one", name: "mouthSmileLeft", value: 0 }]);
  });
});

describe("panic", () => {
  it("goes out at once, alone, and takes every hand off", () => {
    store.channel("jawOpen").grip(0.9);
    const era = store.era;
    store.panic();
    expect(sent).toMatchObject([{ type: "panic", character: "one" }]);
    expect(store.era).toBeGreaterThan(era);
    expect(store.channel("jawOpen").value(now)).toBe(0);
    store.flush();
    expect(sent).toHaveLength(1);
  });
});

describe("a panic that the show has not heard", () => {
  const heard = withOne({ panics: 1 });

  it("is late after a while, until a state shows it", () => {
    store.panic();
    expect(store.panicIsLate).toBe(false);
    now += HEARD_MS;
    store.receive(REST);
    expect(store.panicIsLate).toBe(true);
    store.receive(heard);
    expect(store.panicIsLate).toBe(false);
  });

  it("is sent again under its id by a link that comes back soon, and not later", () => {
    store.panic();
    store.setOnline(false);
    store.setOnline(true);
    expect(sent[1]).toEqual(sent[0]);
    store.setOnline(false);
    now += MEANT_MS + 1;
    store.setOnline(true);
    expect(sent).toHaveLength(2);
    expect(store.notice).toMatch(/not heard/);
  });

  it("is told of a link that is back, not of the first", () => {
    expect(store.notice).toBeNull();
    store.setOnline(false);
    store.setOnline(true);
    expect([store.notice, store.tone]).toEqual(["The link to the show is back.", "done"]);
  });

  it("is not sent again once it was heard", () => {
    store.panic();
    store.receive(heard);
    store.setOnline(false);
    store.setOnline(true);
    expect(sent).toHaveLength(1);
  });

  it("is kept where there is no link, and that is said", () => {
    store.setOnline(false);
    store.panic();
    expect([sent, store.notice]).toEqual([[], expect.stringMatching(/not heard/)]);
    store.setOnline(true);
    expect(sent).toMatchObject([{ type: "panic", character: "one" }]);
  });

  it("is late no more where it was refused, which says why", () => {
    store.panic();
    const { id } = sent[0] as { id: string };
    store.receive({ type: "refused", reason: "who may only look plays nothing", id, held: [] });
    now += HEARD_MS;
    expect([store.panicIsLate, store.notice]).toEqual([false, "who may only look plays nothing"]);
  });
});

describe("panic at another console", () => {
  it("takes the hands off here, and so does none of before the page was opened", () => {
    const era = store.era;
    store.channel("jawOpen").grip(0.9);
    store.receive(withOne({ panics: 1 }));
    expect([store.channel("jawOpen").value(now), store.era]).toEqual([0, era + 1]);
    store.flush();
    expect(sent).toEqual([]);
    const fresh = new ConsoleStore(
      () => undefined,
      () => now,
      "fresh",
    );
    fresh.receive(withOne({ panics: 7 }));
    expect(fresh.era).toBe(0);
  });

  it("is heard where the page says what the next press does", () => {
    let heard = 0;
    store.listen("panic", () => {
      heard += 1;
    });
    store.receive(withOne({ home_next: true }));
    store.receive(withOne({ home_next: true }));
    store.receive(withOne({ home_next: true, home_face: "old" }));
    expect(heard).toBe(2);
  });

  it("has its home face chosen here", () => {
    store.setHome("old", 3);
    expect(sent).toEqual([{ type: "set_home", character: "one", face: "old", seconds: 3 }]);
  });
});

describe("a lost link", () => {
  it("sends nothing, pretends nothing, queues nothing, and says so", () => {
    store.channel("jawOpen").grip(0.9);
    store.setOnline(false);
    store.call("face", "old");
    store.channel("jawOpen").grip(0.4);
    store.bar("face").nudge(0.4);
    store.release("face");
    store.clearChannels(["jawOpen"]);
    store.flush();
    expect(sent).toEqual([]);
    expect(store.channel("jawOpen").value(now)).toBe(0);
    expect(store.notice).toContain("Not sent");
    store.setOnline(true);
    store.flush();
    expect(sent).toEqual([]);
  });

  it("leaves a drag under way to go on once the link is back", () => {
    const era = store.era;
    store.setOnline(false);
    store.setOnline(true);
    expect(store.era).toBe(era);
    store.channel("jawOpen").grip(0.4);
    store.flush();
    expect(sent).toHaveLength(1);
  });
});

describe("listeners", () => {
  it("hear a new call once, not every state", () => {
    let heard = 0;
    const leave = store.listen("call", () => {
      heard += 1;
    });
    const call = { target: "old", progress: 0, remaining: 1, by_hand: false, fader: 0, pickup: 0, start: {} };
    store.receive(withOne({ face_call: call }));
    store.receive(withOne({ face_call: { ...call, progress: 0.1 } }));
    expect(heard).toBe(1);
    leave();
    store.receive(withOne({}));
    expect(heard).toBe(1);
  });
});

it("reads names by their labels, and unknown ones as they are", () => {
  expect(store.label("face", "generic")).toBe("Generic");
  expect(store.label("face", "stranger")).toBe("stranger");
});

describe("several characters", () => {
  const three = (change: Record<string, Partial<CharacterState>> = {}): State => ({
    ...REST,
    characters: Object.fromEntries(["one", "two", "three"].map((name) => [name, { ...CALM, ...change[name] }])),
  });

  it("are played together, all of them by one message", () => {
    store.receive(three());
    store.play(["two", "three"]);
    store.call("face", "old");
    expect(sent).toMatchObject([
      { type: "call_face", character: "two", name: "old" },
      { type: "call_face", character: "three", name: "old" },
    ]);
    expect(new Set(sent.map((message) => "id" in message && message.id)).size).toBe(2);
    sent = [];
    store.play(["three", "one", "two"]);
    store.bar("face").grip(0.5);
    store.flush();
    store.panic();
    expect(sent).toMatchObject([
      { type: "fade_face", character: "*", value: 0.5 },
      { type: "panic", character: "*" },
    ]);
  });

  it("have their own values, and what a hand holds stays with those that it was for", () => {
    store.receive(three({ two: { channels: { jawOpen: 0.25 } } }));
    store.channel("jawOpen").grip(0.75);
    store.play(["two"]);
    expect(sent).toEqual([{ type: "set_channel", character: "one", name: "jawOpen", value: 0.75 }]);
    expect(store.channel("jawOpen").value(now)).toBe(0.25);
    expect(store.channel("jawOpen").gripped()).toBe(false);
  });

  it("panic of one takes the hands off where it is played, and of all everywhere", () => {
    store.receive(three());
    store.play(["two"]);
    const { era } = store;
    store.receive(three({ one: { panics: 1 } }));
    expect(store.era).toBe(era);
    store.receive(three({ one: { panics: 1 }, two: { panics: 1 } }));
    expect(store.era).toBe(era + 1);
    store.panic(true);
    expect(sent).toMatchObject([{ type: "panic", character: "*" }]);
  });

  it("cleared faders come back to each of them, whoever is played then", () => {
    store.receive(three({ one: { channels: { jawOpen: 0.5 } }, three: { channels: { jawOpen: 0.25 } } }));
    store.play(["one", "three"]);
    store.clearChannels(["jawOpen"]);
    store.play(["two"]);
    sent = [];
    store.undo();
    store.flush();
    expect(sent).toEqual([
      { type: "set_channel", character: "one", name: "jawOpen", value: 0.5 },
      { type: "set_channel", character: "three", name: "jawOpen", value: 0.25 },
    ]);
    store.receive(three({ three: { panics: 1 } }));
    store.redo();
    expect(store.history.next("undo")).not.toBeNull();
  });

  it("hears of hands on any that is played", () => {
    store.receive(three());
    store.receive({ type: "hands", hands: { "two/fade_face": "Ana" } });
    expect(store.otherOn(store.bar("face"))).toBeNull();
    store.play(["one", "two"]);
    expect(store.otherOn(store.bar("face"))).toBe("Ana");
  });
});
