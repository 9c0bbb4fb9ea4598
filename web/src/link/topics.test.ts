import { expect, it } from "vitest";
import { TopicStore } from "./topics";

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
