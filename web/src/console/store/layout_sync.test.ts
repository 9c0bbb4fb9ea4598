import { afterEach, beforeEach, describe, expect, it, vi } from "vitest";
import type { FromClient } from "../../link/messages";
import { FIRST, parsed, written } from "./console_layout";
import { Desk } from "./console_store";
import { LayoutKeeper, layoutName } from "./layout_sync";

const sent: FromClient[] = [];
const keeperOf = (desk: Desk): LayoutKeeper =>
  new LayoutKeeper(
    desk,
    "left",
    (message) => {
      sent.push(message);
      return true;
    },
    10,
  );

function deskOf(): Desk {
  const desk = new Desk(
    () => undefined,
    () => 0,
    "me",
  );
  desk.setOnline(true);
  return desk;
}

describe("the keeper of a layout", () => {
  beforeEach(() => {
    vi.useFakeTimers();
    sent.length = 0;
  });
  afterEach(() => {
    vi.useRealTimers();
  });

  it("lays the desk out as it was kept, without keeping that again", async () => {
    const desk = deskOf();
    const kept = { ...FIRST, kind: "arkit", tab: "mouth", linked: false } as const;
    await keeperOf(desk).open(async () => written(kept));
    expect(desk.arrangement).toEqual(kept);
    vi.runAllTimers();
    expect(sent).toEqual([]);
  });

  it("keeps the last of several changes, once", async () => {
    const desk = deskOf();
    await keeperOf(desk).open(async () => null);
    desk.setTiming("face", { seconds: 4 });
    desk.setTiming("face", { seconds: 8 });
    desk.arrange({ kind: "makehuman" });
    vi.runAllTimers();
    expect(sent).toMatchObject([{ type: "set_layout", name: "left" }]);
    const [message] = sent;
    if (message?.type !== "set_layout") throw new Error("no layout was kept");
    expect(parsed(message.document)).toEqual(desk.arrangement);
  });

  it("waits for the link", async () => {
    const desk = deskOf();
    await keeperOf(desk).open(async () => null);
    desk.setOnline(false);
    desk.arrange({ linked: false });
    vi.runAllTimers();
    expect(sent).toEqual([]);
    desk.setOnline(true);
    vi.runAllTimers();
    expect(sent).toHaveLength(1);
  });

  it("ignores what is no layout, with a notice, and a server that does not answer", async () => {
    const desk = deskOf();
    await keeperOf(desk).open(async () => "{}");
    expect(desk.notice).toMatch(/another version/);
    expect(desk.arrangement).toEqual(FIRST);
    const other = deskOf();
    await keeperOf(other).open(() => Promise.reject(new Error("away")));
    expect([other.notice, other.arrangement]).toEqual([null, FIRST]);
  });

  it("goes by the name in the address", () => {
    expect(layoutName("")).toBe("console");
    expect(layoutName("?layout=left%20hand")).toBe("left hand");
    expect(layoutName("?layout=")).toBe("console");
  });
});
