import { beforeEach, describe, expect, it } from "vitest";
import type { FromClient } from "../../link/messages";
import { type Arrangement, FIRST, parsed, written } from "../store/arrangement";
import { ConsoleStore } from "../store/console_store";
import { DEFAULT_LAYOUT, LayoutStorage, layoutName } from "./layout_storage";

const LEFT: Arrangement = { ...FIRST, kind: "arkit", tab: "mouth", linked: false };

let saved: Map<string, string>;
let sent: FromClient[];

beforeEach(() => {
  saved = new Map();
  sent = [];
});

/** A console in a browser that keeps `own`, on a show whose layouts are `saved`. */
function consoleOf(own: Map<string, string>, name = DEFAULT_LAYOUT) {
  const store = new ConsoleStore(
    (message) => {
      sent.push(message);
      change(message);
      store.receive({ type: "layouts", names: [...saved.keys()] });
    },
    () => 0,
    "me",
  );
  const layouts = new LayoutStorage(
    store,
    name,
    async (one) => saved.get(one) ?? null,
    () => ({ getItem: (key) => own.get(key) ?? null, setItem: (key, value) => void own.set(key, value) }),
  );
  store.setOnline(true);
  store.receive({ type: "layouts", names: [...saved.keys()] });
  return { store, layouts };
}

/** What the show does with a message about layouts. */
function change(message: FromClient): void {
  if (message.type === "set_layout") saved.set(message.name, message.document);
  if (message.type === "rename_layout") saved.set(message.to, saved.get(message.name) as string);
  if (message.type === "rename_layout" || message.type === "drop_layout") saved.delete(message.name);
}

describe("a fresh console", () => {
  it("opens with the default, whatever another has set up", async () => {
    const [first, second] = [consoleOf(new Map()), consoleOf(new Map())];
    await first.layouts.open();
    first.store.arrange({ kind: "own", ownFaces: true });
    first.store.setTiming("face", { byHand: true });
    await second.layouts.open();
    expect(second.store.arrangement).toEqual(FIRST);
    expect(sent).toEqual([]);
  });

  it("opens with the show's own default where the crew has saved one", async () => {
    saved.set(DEFAULT_LAYOUT, written(LEFT));
    const { store, layouts } = consoleOf(new Map());
    await layouts.open();
    expect(store.arrangement).toEqual(LEFT);
  });

  it("opens with the layout that its address names", async () => {
    saved.set("left", written(LEFT));
    const { store, layouts } = consoleOf(new Map(), "left");
    await layouts.open();
    expect(store.arrangement).toEqual(LEFT);
  });
});

describe("a browser", () => {
  it("keeps what its operator has set up, for each name of an address", async () => {
    const own = new Map<string, string>();
    const before = consoleOf(own);
    await before.layouts.open();
    before.store.setTiming("expression", { seconds: 4 });
    before.store.arrange({ view: "pads" });
    const [after, other] = [consoleOf(own), consoleOf(own, "left")];
    await after.layouts.open();
    expect(after.store.arrangement).toEqual(before.store.arrangement);
    await other.layouts.open();
    expect(other.store.arrangement).toEqual(FIRST);
  });

  it("may keep nothing: the console opens all the same", async () => {
    const { store } = consoleOf(new Map());
    const forbid = (): never => {
      throw new Error("forbidden");
    };
    const layouts = new LayoutStorage(store, DEFAULT_LAYOUT, async () => null, forbid);
    await layouts.open();
    store.arrange({ linked: false });
    expect(store.arrangement.linked).toBe(false);
  });
});

describe("a layout", () => {
  it("is saved under a name and chosen from the list at another console", async () => {
    const [first, second] = [consoleOf(new Map()), consoleOf(new Map())];
    await first.layouts.open();
    await second.layouts.open();
    first.store.arrange(LEFT);
    expect(await first.layouts.save("left hand")).toBe(true);
    expect(parsed(saved.get("left hand") ?? "")).toEqual(LEFT);
    second.store.receive({ type: "layouts", names: [...saved.keys()] });
    expect(second.layouts.names).toEqual([DEFAULT_LAYOUT, "left hand"]);
    await second.layouts.choose("left hand");
    expect([second.store.arrangement, second.layouts.chosen]).toEqual([LEFT, "left hand"]);
    await second.layouts.choose(DEFAULT_LAYOUT);
    expect(second.store.arrangement).toEqual(FIRST);
  });

  it("that was chosen last is laid out, whichever answer comes first", async () => {
    const { store } = consoleOf(new Map());
    const answers = new Map<string, (document: string | null) => void>();
    const slow = (name: string) => new Promise<string | null>((answer) => answers.set(name, answer));
    const layouts = new LayoutStorage(store, DEFAULT_LAYOUT, slow);
    const [first, second] = [layouts.choose("left"), layouts.choose(DEFAULT_LAYOUT)];
    answers.get(DEFAULT_LAYOUT)?.(null);
    expect(await second).toBe("chosen");
    answers.get("left")?.(written(LEFT));
    expect(await first).toBe("overtaken");
    expect([store.arrangement, layouts.chosen]).toEqual([FIRST, DEFAULT_LAYOUT]);
  });

  it("that cannot be read is told and ignored, and so is a server that does not answer", async () => {
    saved.set(DEFAULT_LAYOUT, "{}");
    const { store, layouts } = consoleOf(new Map());
    await layouts.open();
    expect(store.notice).toMatch(/another version/);
    expect(store.arrangement).toEqual(FIRST);
    const away = () => Promise.reject(new Error("away"));
    const other = new LayoutStorage(store, DEFAULT_LAYOUT, away, () => ({
      getItem: () => null,
      setItem: () => undefined,
    }));
    await other.open();
    store.setOnline(false);
    expect([await other.save("nowhere"), other.rename("a", "b"), await other.drop("a")]).toEqual([false, false, false]);
    expect(store.history.next("undo")).toBeNull();
  });

  it("is renamed, deleted and brought back as it was", async () => {
    saved.set("left", written(LEFT));
    const { store, layouts } = consoleOf(new Map());
    await layouts.choose("left");
    expect(layouts.rename("left", "right")).toBe(true);
    expect([layouts.chosen, layouts.names, layouts.has("left")]).toEqual(["right", [DEFAULT_LAYOUT, "right"], false]);
    expect(await layouts.drop("right")).toBe(true);
    expect([layouts.names, store.arrangement]).toEqual([[DEFAULT_LAYOUT], LEFT]);
    store.arrange({ linked: true });
    expect(await layouts.save("Left")).toBe(true);
    const end = new Map(saved);
    for (let turn = 0; turn < 2; turn++) {
      store.undo();
      expect(saved).toEqual(new Map());
      store.undo();
      expect(saved).toEqual(new Map([["right", written(LEFT)]]));
      store.undo();
      expect(saved).toEqual(new Map([["left", written(LEFT)]]));
      for (let step = 0; step < 3; step++) store.redo();
      expect(saved).toEqual(end);
    }
    expect(await layouts.drop("nobody")).toBe(false);
  });

  it("that is replaced is brought back as it was, and what the show rejects cannot be taken back", async () => {
    saved.set("left", written(LEFT));
    const { store, layouts } = consoleOf(new Map());
    await layouts.save("left");
    expect(saved.get("left")).toBe(written(FIRST));
    store.undo();
    expect(saved.get("left")).toBe(written(LEFT));
    layouts.rename("left", "right");
    const asked = sent.at(-1) as Extract<FromClient, { id: string }>;
    store.receive({ type: "refused", reason: "there is no layout 'left' any more.", id: asked.id, held: [] });
    expect([store.history.next("undo"), store.notice]).toEqual([null, "there is no layout 'left' any more."]);
  });

  it("that another console deleted meanwhile changes nothing", async () => {
    const { store, layouts } = consoleOf(new Map());
    store.arrange(LEFT);
    expect([await layouts.choose("gone"), layouts.chosen, store.arrangement]).toEqual([
      "missing",
      DEFAULT_LAYOUT,
      LEFT,
    ]);
  });

  it("goes by the name in the address", () => {
    expect(layoutName("")).toBe(DEFAULT_LAYOUT);
    expect(layoutName("?layout=left%20hand")).toBe("left hand");
    expect(layoutName("?layout=")).toBe(DEFAULT_LAYOUT);
  });
});
