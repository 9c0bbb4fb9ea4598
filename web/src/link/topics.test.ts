import { expect, it } from "vitest";
import { hear, MessageStore, TopicStore } from "./topics";

it("tells of a topic those who listen to it, until they leave", () => {
  const store = new TopicStore<"cast" | "link">();
  const heard: string[] = [];
  const leave = store.listen("cast", () => heard.push("first"));
  store.listen("cast", () => heard.push("second"));
  store.listen("link", () => heard.push("link"));
  store.tell("cast");
  expect(heard).toEqual(["first", "second"]);
  leave();
  store.tell("cast");
  expect(heard).toEqual(["first", "second", "second"]);
});

type Message = { type: "hands"; held: string } | { type: "leases"; on: boolean };

it("tells of messages by their tag, and keeps the newest of each", () => {
  const store = new MessageStore<Message, "link">();
  const heard: string[] = [];
  const leave = store.hear("hands", ({ held }) => heard.push(held));
  store.receive({ type: "hands", held: "a" });
  store.receive({ type: "leases", on: true });
  leave();
  store.receive({ type: "hands", held: "b" });
  expect([heard, store.newest("hands")?.held, store.newest("leases")?.on]).toEqual([["a"], "b", true]);
});

it("calls what hears a message, and nothing where nobody does", () => {
  const heard: boolean[] = [];
  const hearing = { leases: ({ on }: { on: boolean }) => heard.push(on) };
  hear<Message>(hearing, { type: "hands", held: "a" });
  hear<Message>(hearing, { type: "leases", on: true });
  expect(heard).toEqual([true]);
});
