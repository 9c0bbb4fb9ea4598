import { decode, encode } from "@msgpack/msgpack";
import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import { REVOKED_CODE } from "./constants";
import { ReconnectingSocket, type SocketOwner } from "./reconnecting_socket";

/** A WebSocket that the test opens, feeds and closes. */
class FakeSocket {
  static readonly OPEN = 1;
  static readonly made: FakeSocket[] = [];
  readyState = 0;
  readonly sent: unknown[] = [];
  onopen: (() => void) | null = null;
  onmessage: ((event: { data: Uint8Array }) => void) | null = null;
  onclose: ((event: { code: number }) => void) | null = null;

  constructor(readonly address: string) {
    FakeSocket.made.push(this);
  }

  send(data: Uint8Array): void {
    this.sent.push(decode(data));
  }

  close(): void {
    this.readyState = 3;
  }

  open(): void {
    this.readyState = FakeSocket.OPEN;
    this.onopen?.();
  }
}

/** The page is busy for so many seconds: the clock goes on, no timer fires. */
const draw = (seconds: number): void => {
  busy += 1000 * seconds;
};
let busy = 0; // milliseconds

const LONGEST_PAUSE = 751; // milliseconds, of `Backoff`
const last = (): FakeSocket => FakeSocket.made.at(-1) as FakeSocket;

describe("a reconnecting socket", () => {
  let events: string[];
  let expects: boolean;
  let socket: ReconnectingSocket<string, string>;

  beforeEach(() => {
    vi.useFakeTimers({ toFake: ["setTimeout", "setInterval", "clearTimeout", "clearInterval", "performance"] });
    const clock = performance.now.bind(performance);
    vi.spyOn(performance, "now").mockImplementation(() => clock() + busy);
    vi.stubGlobal("WebSocket", FakeSocket);
    vi.stubGlobal("location", { protocol: "https:", host: "show.example" });
    vi.stubGlobal("fetch", () => Promise.reject(new Error("the show is not there")));
    FakeSocket.made.length = 0;
    [events, expects] = [[], true];
    const owner: SocketOwner<string> = {
      silence: 2,
      interval: 100,
      opened: () => events.push("opened"),
      received: (message) => events.push(message),
      lost: (wasUp) => events.push(wasUp ? "lost" : "failed"),
      revoked: () => events.push("revoked"),
      expects: () => expects,
    };
    socket = new ReconnectingSocket("/link", owner);
  });

  afterEach(() => {
    socket.close();
    vi.restoreAllMocks();
    vi.useRealTimers();
    vi.unstubAllGlobals();
  });

  it("asks the host of the page, and greets once the connection is open", () => {
    expect(last().address).toBe("wss://show.example/link");
    expect(socket.send("early")).toBe(false);
    last().open();
    expect(events).toEqual(["opened"]);
    expect(socket.send("hello")).toBe(true);
    expect(last().sent).toEqual(["hello"]);
  });

  it("is up from the answer to its greeting until the connection is lost", () => {
    last().open();
    expect(socket.up).toBe(false);
    socket.accept();
    expect(socket.up).toBe(true);
    last().onclose?.({ code: 1006 });
    expect(socket.up).toBe(false);
    expect(events).toEqual(["opened", "lost"]);
  });

  it("opens another connection for every one that is lost, for ever", () => {
    for (let times = 1; times <= 20; times++) {
      last().onclose?.({ code: 1006 });
      vi.advanceTimersByTime(LONGEST_PAUSE);
      expect(FakeSocket.made.length).toBe(times + 1);
    }
    expect(events).toEqual(Array(20).fill("failed"));
  });

  it("tells once that the token of its page is not valid any more", () => {
    last().open();
    last().onclose?.({ code: 1006 });
    vi.advanceTimersByTime(LONGEST_PAUSE);
    expect(events).not.toContain("revoked");
    last().onclose?.({ code: REVOKED_CODE });
    expect(events.filter((event) => event === "revoked")).toEqual(["revoked"]);
  });

  it("finds out that its token has ended while the page was away, and that the show alone was away", async () => {
    const settle = async (): Promise<void> => {
      for (let turns = 0; turns < 10; turns++) await Promise.resolve();
    };
    for (const [status, expected] of [
      [200, []],
      [503, []],
      [401, ["revoked"]],
    ] as const) {
      vi.stubGlobal("fetch", () => Promise.resolve({ status }));
      last().onclose?.({ code: 1006 });
      await settle();
      expect(events.filter((event) => event === "revoked")).toEqual(expected);
      vi.advanceTimersByTime(LONGEST_PAUSE);
    }
  });

  it("gives up a connection that is silent while a message is due, and hears nothing more of it", () => {
    const first = last();
    first.open();
    vi.advanceTimersByTime(1900);
    first.onmessage?.({ data: encode("alive") });
    vi.advanceTimersByTime(1900);
    expect(FakeSocket.made.length).toBe(1);
    vi.advanceTimersByTime(300 + LONGEST_PAUSE);
    expect(FakeSocket.made.length).toBe(2);
    expect([first.readyState, first.onmessage]).toEqual([3, null]);
  });

  it("leaves a page that draws for seconds the turns in which it is greeted and hears", () => {
    const first = last();
    for (let frame = 0; frame < 12; frame++) {
      draw(2.5);
      vi.advanceTimersByTime(100); // the look comes before what the socket has to say
      if (frame === 6) first.open();
      if (frame > 6 && frame % 3 === 0) first.onmessage?.({ data: encode(`state ${frame}`) });
    }
    expect(FakeSocket.made.length).toBe(1);
    expect(events).toEqual(["opened", "state 9"]);
  });

  it("gives up a dead connection on a page that draws for seconds too, after so many looks", () => {
    last().open();
    for (let frame = 0; frame < 25; frame++) {
      draw(2.5);
      vi.advanceTimersByTime(100);
    }
    expect(events).toEqual(["opened", "failed"]);
  });

  it("counts silence only from where a message is due", () => {
    expects = false;
    vi.advanceTimersByTime(60_000);
    expects = true;
    socket.awaitMessage();
    vi.advanceTimersByTime(1900);
    expect(FakeSocket.made.length).toBe(1);
    vi.advanceTimersByTime(300 + LONGEST_PAUSE);
    expect(FakeSocket.made.length).toBe(2);
  });

  it("bears silence while nothing is due", () => {
    expects = false;
    vi.advanceTimersByTime(60_000);
    expect(FakeSocket.made.length).toBe(1);
  });

  it("ignores what cannot be read", () => {
    last().open();
    last().onmessage?.({ data: Uint8Array.of(0xc1) });
    last().onmessage?.({ data: encode("whole") });
    expect(events).toEqual(["opened", "whole"]);
  });

  it("opens nothing more once it is closed", () => {
    socket.close();
    vi.advanceTimersByTime(60_000);
    expect(FakeSocket.made.length).toBe(1);
    expect(events).toEqual(["failed"]);
  });
});
