import { expect, it } from "vitest";
import type { FromClient } from "../../link/messages";
import { Outbox } from "./outbox";

const jaw = (value: number): FromClient => ({ type: "set_channel", character: "one", name: "jawOpen", value });
const box = () => {
  const sent: FromClient[] = [];
  return { sent, outbox: new Outbox((message) => sent.push(message)) };
};

it("sends one message for each parameter in a frame, the newest", () => {
  const { sent, outbox } = box();
  for (const value of [0.1, 0.2, 0.3]) outbox.put("jaw", jaw(value));
  outbox.put("bar", { type: "fade_face", character: "one", value: 0.5 });
  expect(sent).toEqual([]);
  outbox.flush();
  expect(sent).toEqual([jaw(0.3), { type: "fade_face", character: "one", value: 0.5 }]);
  outbox.flush();
  expect(sent).toHaveLength(2);
});

it("never lets an event overtake the values set before it", () => {
  const { sent, outbox } = box();
  outbox.put("bar", { type: "fade_face", character: "one", value: 1 });
  outbox.push({ type: "release_face", character: "one" });
  expect(sent.map(({ type }) => type)).toEqual(["fade_face", "release_face"]);
});

it("forgets what waits", () => {
  const { sent, outbox } = box();
  outbox.put("jaw", jaw(1));
  outbox.clear();
  outbox.flush();
  expect(sent).toEqual([]);
});
