import { beforeEach, describe, expect, it } from "vitest";
import type { DraftState, FromEditor } from "../../link/editing_messages";
import { PendingRequests } from "./pending_requests";
import type { Request } from "./requests";

let sent: FromEditor[];
let outstanding: PendingRequests;

const numbers = () => sent.map((message) => ("request" in message ? message.request : null));
const draft = (request: number, item = 7) => ({ type: "draft", request, item }) as DraftState;
const eyes: Extract<Request, { type: "set_eyes" }> = { type: "set_eyes", item: 7, eyes: [0, 0, 0, 0], pupil: 0 };

beforeEach(() => {
  sent = [];
  outstanding = new PendingRequests((message) => sent.push(message));
  outstanding.up("a5");
});

it("gives each answer to its request, whatever their order", async () => {
  const first = outstanding.ask(eyes);
  const second = outstanding.ask({ type: "ask_history", item: 7 });
  const [one, two] = numbers() as [number, number];
  expect(outstanding.answer({ type: "history", request: two, item: 7, revisions: [] })).toBe(true);
  expect(outstanding.answer(draft(one))).toBe(true);
  expect(await first).toMatchObject({ type: "draft" });
  expect(await second).toMatchObject({ type: "history" });
  expect(outstanding.size).toBe(0);
});

it("rejects what is refused with the server's sentence", async () => {
  const asked = outstanding.ask(eyes);
  outstanding.answer({ type: "refused", request: numbers()[0] as number, reason: "No." });
  await expect(asked).rejects.toThrow("No.");
});

it("leaves to others what answers nothing of ours", () => {
  expect(outstanding.answer(draft(99))).toBe(false);
  expect(outstanding.answer({ type: "items", digest: "", items: [] })).toBe(false);
});

describe("a lost link", () => {
  it("sends what was not answered again, once, in order, under the same numbers", async () => {
    const asked = [
      outstanding.ask(eyes),
      outstanding.ask({ ...eyes, pupil: 1 }),
      outstanding.ask({ ...eyes, pupil: 2 }),
    ];
    const before = [...sent];
    outstanding.answer(draft(numbers()[1] as number));
    outstanding.down();
    sent.length = 0;
    outstanding.up("a5");
    expect(sent).toEqual([{ type: "open_item", request: 0, item: 7 }, before[0], before[2]]);
    for (const number of numbers().slice(1)) outstanding.answer(draft(number as number));
    await Promise.all(asked);
  });

  it("keeps edits until it is back", () => {
    outstanding.down();
    void outstanding.ask(eyes);
    expect(sent).toEqual([]);
    outstanding.up("a5");
    expect(sent).toMatchObject([eyes]);
  });

  it("does nothing twice that must happen once: it says so", async () => {
    const saved = outstanding.ask({ type: "save", item: 7, note: "" });
    outstanding.down();
    await expect(saved).rejects.toThrow("lost before the answer");
    await expect(outstanding.ask({ type: "undo", item: 7 })).rejects.toThrow("not sent");
    sent.length = 0;
    outstanding.up("a5");
    expect(sent).toEqual([]);
  });

  it("sends nothing to another show, whose items have the same numbers", async () => {
    outstanding.answer(draft(0));
    const asked = outstanding.ask(eyes);
    outstanding.down();
    const waiting = outstanding.ask({ ...eyes, pupil: 1 });
    sent.length = 0;
    outstanding.up("b7");
    expect(sent).toEqual([]);
    for (const one of [asked, waiting]) await expect(one).rejects.toThrow("another show is served here now");
    expect(outstanding.size).toBe(0);
    outstanding.down();
    outstanding.up("b7");
    expect(sent).toEqual([]);
  });

  it("opens no item again that was left", async () => {
    outstanding.answer(draft(0));
    const left = outstanding.ask({ type: "close_item", item: 7 });
    outstanding.answer({ type: "done", request: numbers()[0] as number });
    await left;
    outstanding.down();
    sent.length = 0;
    outstanding.up("a5");
    expect(sent).toEqual([]);
  });
});
