import { beforeEach, describe, expect, it } from "vitest";
import type { CharacterState, FromClient, Leases, SeatState, State } from "../../link/messages";
import { ConsoleStore } from "../store/console_store";
import { ConsoleLeases } from "./console_leases";

const seat = (number: number, name: string, manager = false): SeatState => ({
  number,
  name,
  colour: "#70ccee",
  manager,
  here: true,
});
const [ANA, ME] = [seat(1, "Ana", true), seat(2, "Me")];
const character = {
  faces: { generic: 1 },
  channels: { jawOpen: 0.25 },
  head: [0, 0, 0],
  face_call: null,
  expression_call: null,
  face_fader: 0,
  expression_fader: 0,
  panics: 0,
  home_face: "generic",
  label: "One",
  presence: 1,
} as unknown as CharacterState;

let sent: FromClient[];
let store: ConsoleStore;
let leases: ConsoleLeases;
let now: number;

/** The show tells who holds what. */
const tell = (held: Leases["held"], on = true, wishes: Leases["wishes"] = []): void =>
  store.receive({ type: "leases", on, held, seats: [ANA, ME], you: 2, wishes });
/** What was sent, without the ids. */
const said = () => sent.splice(0).map((message) => ({ ...message, id: undefined }));
/** What the operator reads, and can do about it. */
const notice = () => [store.notice, store.offers.map(({ label }) => label)];
const press = (label: string): void => {
  const offer = store.offers.find((candidate) => candidate.label === label);
  if (offer !== undefined && "act" in offer) offer.act();
};

beforeEach(() => {
  [sent, now] = [[], 0];
  store = new ConsoleStore(
    (message) => sent.push(message),
    () => now,
    "me",
  );
  leases = new ConsoleLeases(store, () => now);
  store.setOnline(true);
  store.receive({ type: "state", characters: { one: character } } as unknown as State);
});

describe("leases at a console", () => {
  it("bar nothing while they are off", () => {
    tell({}, false);
    store.channel("jawOpen").grip(0.5);
    store.flush();
    expect(said()).toMatchObject([{ type: "set_channel", value: 0.5 }]);
    expect([leases.seat, store.notice]).toEqual([ME, null]);
  });

  it("bar a hand from what another holds, show what is on air, say who it is once, and offer to take over", () => {
    store.channel("jawOpen").grip(0.5);
    tell({ "one/channels": ANA });
    const before = store.logEntries.length;
    for (const value of [0.6, 0.7]) store.channel("jawOpen").grip(value);
    store.channel("jawOpen").nudge(0.8);
    expect(store.channel("jawOpen").value(now)).toBe(0.25);
    store.flush();
    expect(said()).toMatchObject([
      { type: "set_channel", value: 0.5 }, // of before
      { type: "lease", part: "channels" }, // so that Ana hears of it, once
    ]);
    expect(notice()).toEqual(["Ana holds the channels of One.", ["Take over"]]);
    expect(store.logEntries.length).toBe(before + 1);
    press("Take over");
    expect(said()).toMatchObject([{ type: "lease", character: "one", part: "channels", take_over: true }]);
    expect(notice()).toEqual(["Taken over: the channels of One. Ana is told.", ["Release"]]);
  });

  it("let a hand move what is free or its own", () => {
    tell({ "one/channels": ANA, "one/head": ME });
    store.head("yaw").grip(0.1);
    store.bar("face").grip(0.5);
    store.flush();
    expect(said().map(({ type }) => type)).toEqual(["set_head", "fade_face"]);
    expect([leases.own("head"), leases.mine]).toEqual([["one/head"], ["one/head"]]);
  });

  it("repeat the call that was rejected, once it is taken over", () => {
    tell({ "one/face": ANA });
    store.call("face", "old");
    const [call] = sent as { id: string }[];
    said();
    store.receive({ type: "refused", reason: "Ana holds it.", id: call?.id ?? "", held: ["one/face"] });
    press("Take over");
    const [lease, again] = [...sent] as [FromClient, FromClient & { id: string }];
    expect(said()).toMatchObject([
      { type: "lease", part: "face", take_over: true },
      { type: "call_face", character: "one", name: "old" },
    ]);
    expect(again.id).not.toBe(call?.id);
    expect(lease.type).toBe("lease");
    leases.takeOver(["one/face"]);
    expect(said()).toHaveLength(1);
  });

  it("say why the show rejected a call, with the same offer by key", () => {
    tell({ "one/face": ANA });
    leases.takeOverWanted();
    expect(notice()[0]).toMatch(/^Nothing to take over/);
    store.receive({
      type: "refused",
      reason: "Ana holds the face of one: take it over.",
      id: "me-1",
      held: ["one/face"],
    });
    expect(notice()).toEqual(["Ana holds the face of One.", ["Take over"]]);
    leases.takeOverWanted();
    expect(said()).toMatchObject([{ type: "lease", part: "face", take_over: true }]);
    store.receive({ type: "refused", reason: "no such face.", id: "me-2", held: [] });
    expect(notice()).toEqual(["no such face.", []]);
  });

  it("tell a holder who wants its part and who has taken it, and what can be done", () => {
    tell({ "one/face": ME });
    store.receive({ type: "lease_claim", parts: ["one/face"], by: ANA, taken: false, kept: false });
    expect(notice()).toEqual(["Ana wants the face of One, which you hold.", ["Release", "Keep it"]]);
    press("Release");
    expect(said()).toMatchObject([{ type: "release_lease", character: "one", part: "face" }]);
    press("Hold again");
    expect(said()).toMatchObject([{ type: "lease", part: "face", take_over: false }]);
    store.receive({ type: "lease_claim", parts: ["one/face"], by: ANA, taken: true, kept: false });
    expect(notice()).toEqual(["Ana has taken over the face of One.", ["Take back"]]);
    press("Take back");
    expect(said()).toMatchObject([{ type: "lease", part: "face", take_over: true }]);
  });

  it("tell of claims that come together once, with all their parts, and take back all", () => {
    const parts = ["one/face", "one/expression", "one/head"] as const;
    const claim = (part: string, by = ANA, how = { taken: true, kept: false }): void =>
      store.receive({ type: "lease_claim", parts: [part], by, ...how });
    tell({ "one/face": ME, "one/expression": ME, "one/head": ME });
    for (const part of parts) claim(part);
    expect(notice()).toEqual([
      "Ana has taken over the face of One, the expression of One and the head of One.",
      ["Take back"],
    ]);
    press("Take back");
    expect(said().map((message) => message.type === "lease" && [message.part, message.take_over])).toEqual([
      ["face", true],
      ["expression", true],
      ["head", true],
    ]);
    for (const part of parts.slice(0, 2)) claim(part, ANA, { taken: false, kept: true });
    expect(notice()).toEqual(["Ana keeps the face of One and the expression of One.", ["Take over"]]);
    now = 60_000;
    claim("one/head");
    expect(notice()[0]).toBe("Ana has taken over the head of One.");
    claim("one/face", seat(3, "Ben"));
    expect(notice()[0]).toBe("Ben has taken over the face of One.");
  });

  it("ask the holder until it answers: it releases or keeps what is wanted, and a region goes with its expression", () => {
    const held = { "one/face": ME, "one/expression": ME };
    tell(held, true, [{ part: "one/face", by: 1, seconds: 42 }]);
    expect(leases.question?.text).toBe("Ana has wanted the face of One for 42 s.");
    expect(leases.question?.offers.map(({ label }) => label)).toEqual(["Release", "Keep it"]);
    leases.question?.dismiss();
    expect(said()).toMatchObject([{ type: "lease", part: "face", take_over: false }]);
    tell(held, true, [{ part: "one/mouth", by: 1, seconds: 1 }]);
    const release = leases.question?.offers[0];
    if (release !== undefined && "act" in release) release.act();
    expect(said()).toMatchObject([{ type: "release_lease", part: "expression" }]);
    tell({}, true, []);
    expect(leases.question).toBeNull();
  });

  it("remind of what this seat wants until it is taken, left, or kept by its holder", () => {
    tell({ "one/face": ANA }, true, [{ part: "one/face", by: 2, seconds: 130 }]);
    expect(leases.question?.text).toBe("Ana holds the face of One; you have wanted it for 2 min.");
    expect(leases.question?.offers.map(({ label }) => label)).toEqual(["Take over", "Leave it"]);
    leases.question?.dismiss();
    expect(said()).toMatchObject([{ type: "release_lease", part: "face" }]);
    store.receive({ type: "lease_claim", parts: ["one/face"], by: ANA, taken: false, kept: true });
    expect(notice()).toEqual(["Ana keeps the face of One.", ["Take over"]]);
  });

  it("are the stage manager's to take, to switch and to pass on", () => {
    tell({});
    expect([leases.isManager, leases.manager]).toEqual([false, ANA]);
    leases.takeAll();
    leases.switch(false);
    leases.appoint(1);
    leases.releaseAll();
    expect(said()).toMatchObject([
      { type: "lease", character: "*", part: "*", take_over: true },
      { type: "set_leases", on: false },
      { type: "appoint_manager", seat: 1 },
      { type: "release_lease", character: "*", part: "*" },
    ]);
  });

  it("are forgotten with the link, and pages hear when they change", () => {
    let heard = 0;
    store.listen("leases", () => {
      heard += 1;
    });
    tell({ "one/face": ANA });
    tell({ "one/face": ANA });
    store.setOnline(false);
    expect([heard, leases.report.on]).toEqual([3, false]);
  });
});
