import { decode, encode } from "@msgpack/msgpack";
import { afterEach, beforeEach, expect, it, vi } from "vitest";
import { CameraLink } from "./camera_link";

class FakeSocket {
  static readonly OPEN = 1;
  static made: FakeSocket[] = [];
  readyState = 0;
  bufferedAmount = 0;
  sent: (Uint8Array | ArrayBuffer)[] = [];
  onopen: (() => void) | null = null;
  onmessage: ((event: { data: Uint8Array }) => void) | null = null;
  onclose: ((event: { code: number }) => void) | null = null;

  constructor(readonly address: string) {
    FakeSocket.made.push(this);
  }

  send(data: Uint8Array | ArrayBuffer): void {
    this.sent.push(data);
  }

  close(): void {
    this.readyState = 3;
  }

  open(): void {
    this.readyState = FakeSocket.OPEN;
    this.onopen?.();
  }

  say(message: object): void {
    this.onmessage?.({ data: encode(message) });
  }
}

const last = (): FakeSocket => FakeSocket.made.at(-1) as FakeSocket;
const frame = new ArrayBuffer(8);
let events: string[];
let link: CameraLink;

beforeEach(() => {
  vi.useFakeTimers();
  vi.stubGlobal("WebSocket", FakeSocket);
  vi.stubGlobal("location", { protocol: "http:", host: "localhost" });
  vi.stubGlobal("fetch", () => Promise.reject(new Error("away")));
  FakeSocket.made = [];
  events = [];
  link = new CameraLink({
    status: ({ performer }) => events.push(`status ${performer}`),
    refused: (reason) => events.push(`refused ${reason}`),
    displaced: () => events.push("displaced"),
    connected: (up) => events.push(up ? "up" : "down"),
    revoked: () => events.push("revoked"),
  });
});

afterEach(() => {
  link.close();
  vi.useRealTimers();
  vi.unstubAllGlobals();
});

it("says who performs, also when it comes back, by the name that it has then", () => {
  link.perform("Ada");
  last().open();
  expect(decode(last().sent[0] as Uint8Array)).toEqual({ type: "perform", version: 3, name: "Ada" });
  last().say({ type: "camera_status", performer: "Ada" });
  link.rename("Bo");
  last().onclose?.({ code: 1006 });
  vi.advanceTimersByTime(2000);
  last().open();
  expect(decode(last().sent[0] as Uint8Array)).toMatchObject({ name: "Bo" });
  expect(events).toEqual(["up", "status Ada", "down"]);
});

it("sends frames only to a show that has answered, and none into a full connection", () => {
  link.perform("Ada");
  last().open();
  link.sendFrame(frame);
  expect(last().sent.length).toBe(1);
  last().say({ type: "camera_status", performer: "Ada" });
  link.sendFrame(frame);
  last().bufferedAmount = 1e6;
  link.sendFrame(frame);
  expect(last().sent.slice(1)).toEqual([frame]);
});

it("tells what the show says no to, and ends where another page has taken over", () => {
  link.perform("Ada");
  last().open();
  last().say({ type: "camera_refused", reason: "no" });
  last().say({ type: "displaced" });
  vi.advanceTimersByTime(5000);
  expect(events).toEqual(["refused no", "down", "displaced"]);
  expect(FakeSocket.made.length).toBe(1);
  link.perform("Ada");
  expect(FakeSocket.made.length).toBe(2);
  expect(link.send({ type: "cancel_guide" })).toBe(false);
});
