import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import type { FromClient } from "../../link/messages";
import { FIRST, parsed, written } from "./console_layout";
import { ConsoleStore } from "./console_store";
import { LayoutSync, layoutName } from "./layout_sync";

const sent: FromClient[] = [];
const syncOf = (store: ConsoleStore): LayoutSync =>
  new LayoutSync(
    store,
    "left",
    (message) => {
      sent.push(message);
      return true;
    },
    10,
  );

function deskOf(): ConsoleStore {
  const store = new ConsoleStore(
    () => undefined,
    () => 0,
    "me",
  );
  store.setOnline(true);
  return store;
}

describe("the sync of a layout", () => {
  beforeEach(() => {
    vi.useFakeTimers();
    sent.length = 0;
  });
  afterEach(() => {
    vi.useRealTimers();
  });

  it("lays the console out as it was kept, without keeping that again", async () => {
    const store = deskOf();
    const kept = { ...FIRST, kind: "arkit", tab: "mouth", linked: false } as const;
    await syncOf(store).open(async () => written(kept));
    expect(store.layout).toEqual(kept);
    vi.runAllTimers();
    expect(sent).toEqual([]);
  });

  it("keeps the last of several changes, once", async () => {
    const store = deskOf();
    await syncOf(store).open(async () => null);
    store.setTiming("face", { seconds: 4 });
    store.setTiming("face", { seconds: 8 });
    store.arrange({ kind: "makehuman" });
    vi.runAllTimers();
    expect(sent).toMatchObject([{ type: "set_layout", name: "left" }]);
    const [message] = sent;
    if (message?.type !== "set_layout") throw new Error("no layout was kept");
    expect(parsed(message.document)).toEqual(store.layout);
  });

  it("waits for the link", async () => {
    const store = deskOf();
    await syncOf(store).open(async () => null);
    store.setOnline(false);
    store.arrange({ linked: false });
    vi.runAllTimers();
    expect(sent).toEqual([]);
    store.setOnline(true);
    vi.runAllTimers();
    expect(sent).toHaveLength(1);
  });

  it("ignores what is no layout, with a notice, and a server that does not answer", async () => {
    const store = deskOf();
    await syncOf(store).open(async () => "{}");
    expect(store.notice).toMatch(/another version/);
    expect(store.layout).toEqual(FIRST);
    const other = deskOf();
    await syncOf(other).open(() => Promise.reject(new Error("away")));
    expect([other.notice, other.layout]).toEqual([null, FIRST]);
  });

  it("goes by the name in the address", () => {
    expect(layoutName("")).toBe("console");
    expect(layoutName("?layout=left%20hand")).toBe("left hand");
    expect(layoutName("?layout=")).toBe("console");
  });
});
