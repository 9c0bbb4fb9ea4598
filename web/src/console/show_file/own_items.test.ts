import { beforeEach, describe, expect, it } from "vitest";
import type { FromClient } from "../../link/messages";
import type { Axis } from "../store/axis";
import { ConsoleStore } from "../store/console_store";
import { type Naming, type OwnItem, OwnItems } from "./own_items";

type Asked = Extract<FromClient, { id: string }>;

let now: number;
let sent: Asked[];
let store: ConsoleStore;
let items: OwnItems;

beforeEach(() => {
  now = 1000;
  sent = [];
  store = new ConsoleStore(
    (message) => sent.push(message as Asked),
    () => now,
    "me",
  );
  items = new OwnItems(store, () => now);
  store.setOnline(true);
});

const SMILE: OwnItem = { kind: "expression", name: "smile_2", label: "Smile 2" };

const last = (): Asked => sent.at(-1) as Asked;
/** What was sent, without ids. */
const asked = (): object[] => sent.map(({ id, ...rest }) => rest);
const kept = (of: Asked, name: string, label: string): void => store.receive({ type: "kept", id: of.id, name, label });
const changed = (label: string, before: string): void =>
  store.receive({ type: "item_changed", id: last().id, label, before });

/** Keeps a face as the show answers. */
function keep(kind: Axis, name: string): Naming {
  now += 5000;
  items.keep(kind);
  const naming = items.naming as Naming;
  kept(last(), name, name);
  return naming;
}

describe("keeping what is on air", () => {
  it("asks once where it is pressed twice, each axis by itself and each time under an id of its own", () => {
    items.keep("face");
    now += 200;
    items.keep("face");
    items.keep("expression");
    now += 5000;
    items.keep("face");
    expect(sent.map(({ type }) => type)).toEqual(["keep_face", "keep_expression", "keep_face"]);
    expect(new Set(sent.map(({ id }) => id)).size).toBe(3);
  });

  it("says under which name it was kept, and where to edit it; answers may come in any order", () => {
    items.keep("face");
    items.keep("expression");
    const [face, other] = sent as [Asked, Asked];
    kept(other, "on_air_3", "On air 3");
    expect(store.notice).toBe("Kept as On air 3 under Own.");
    expect(store.offers[1]).toEqual({ label: "Edit it", address: "/editor?kind=expression&name=on_air_3" });
    kept(face, "on_air_4", "On air 4");
    expect(store.offers[1]).toHaveProperty("address", "/editor?kind=face&name=on_air_4");
    store.say("No.");
    expect(store.offers).toEqual([]);
  });

  it("asks nothing while the link is lost, and for no name", () => {
    store.setOnline(false);
    items.keep("face");
    expect([sent, items.naming]).toEqual([[], null]);
    expect(store.notice).toMatch(/Not sent/);
  });

  it("lets nothing be taken back while the show is at it, for that would be what was done before", () => {
    keep("face", "a");
    now += 5000;
    items.keep("face");
    store.undo();
    expect(store.notice).toBe("Not yet: the face on air is being kept.");
    expect(store.history.next("undo")?.what).toBe("keep a");
    kept(last(), "b", "b");
    store.undo();
    expect(last()).toMatchObject({ type: "delete_item", name: "b", unedited: true });
  });
});

describe("the name of what is kept", () => {
  it("is asked for only on demand where there are no keys", () => {
    const touched = new OwnItems(
      store,
      () => now,
      () => false,
    );
    touched.keep("face");
    kept(last(), "on_air_1", "On air 1");
    expect(touched.naming).toBeNull();
    const ask = store.offers.find(({ label }) => label === "Name it");
    if (ask !== undefined && "act" in ask) ask.act();
    expect(touched.naming?.item).toEqual({ kind: "face", name: "on_air_1", label: "On air 1" });
  });

  it.each(["before", "after"])("that is typed %s it came is given to that item", (when) => {
    items.keep("face");
    const [naming, keeping] = [items.naming as Naming, last()];
    if (when === "after") kept(keeping, "on_air_1", "On air 1");
    items.endNaming(naming, " Catdog ");
    if (when === "before") {
      expect(sent).toHaveLength(1);
      now += 5000;
      items.keep("expression");
      kept(keeping, "on_air_1", "On air 1");
    }
    const renames = sent.filter(({ type }) => type === "rename_item");
    expect(renames).toMatchObject([{ kind: "face", name: "on_air_1", label: "Catdog" }]);
  });

  it("stays as it is where nothing, or the same, is typed", () => {
    const naming = keep("face", "a");
    items.endNaming(naming, "  ");
    items.beginNaming(SMILE);
    items.endNaming(items.naming as Naming, "Smile 2");
    expect(sent.map(({ type }) => type)).toEqual(["keep_face"]);
    expect(items.naming).toBeNull();
  });

  it("is asked for no more where the show cannot keep it, or the link is lost meanwhile", () => {
    items.keep("face");
    store.receive({ type: "refused", reason: "there is no show file.", id: last().id, held: [] });
    expect([items.naming, store.notice]).toEqual([null, "there is no show file."]);
    now += 5000;
    items.keep("face");
    store.setOnline(false);
    expect(items.naming).toBeNull();
  });
});

describe("a name that the show refuses", () => {
  const refuse = (of: Asked, reason: string): void => store.receive({ type: "refused", reason, id: of.id, held: [] });
  const reason = "the name has the character 'right-to-left override' in it.";

  it("is typed beside nothing whose Undo would be taken for its own", () => {
    store.offerUndo("Kept as On air 1 under Own.", { what: "keep", undo: [], redo: [] });
    items.beginNaming(SMILE);
    expect([store.notice, store.offers]).toEqual([null, []]);
  });

  it.each([false, true])("stands in the field again, with the reason; left: %s", (left) => {
    items.beginNaming(SMILE);
    items.endNaming(items.naming as Naming, "Sm\u202eile", left);
    refuse(last(), reason);
    const refused = { label: "Sm\u202eile", reason, left };
    expect(items.naming).toEqual({ kind: "expression", item: SMILE, fresh: false, refused });
    expect(store.logEntries.at(-1)?.text).toBe(`Not renamed (Smile 2): ${reason}`);
    items.endNaming(items.naming as Naming, "Grin");
    expect(last()).toMatchObject({ type: "rename_item", name: "smile_2", label: "Grin" });
  });

  it("is asked for again also where it was typed before what was kept came", () => {
    items.keep("face");
    const keeping = last();
    items.endNaming(items.naming as Naming, "Ana");
    kept(keeping, "on_air_1", "On air 1");
    refuse(last(), "there is a face 'Ana' already: give another name.");
    expect(items.naming?.item?.name).toBe("on_air_1");
    expect(items.naming?.refused?.label).toBe("Ana");
  });

  it("is only said where another one is typed by now", () => {
    items.beginNaming(SMILE);
    items.endNaming(items.naming as Naming, "Ana");
    const asking = last();
    items.beginNaming({ ...SMILE, name: "grin", label: "Grin" });
    refuse(asking, reason);
    expect(items.naming?.item?.name).toBe("grin");
    expect(store.notice).toBe(`Not renamed (Smile 2): ${reason}`);
  });
});

it("takes everything back step by step, and does it again", () => {
  const naming = keep("face", "a");
  items.endNaming(naming, "Ana");
  changed("Ana", "a");
  expect(store.notice).toBe("a is called Ana now.");
  items.delete(SMILE);
  changed("Smile 2", "Smile 2");
  expect(store.notice).toMatch(/^Deleted Smile 2: no console has it any more/);
  items.copy({ kind: "face", name: "a", label: "Ana" });
  kept(last(), "ana_2", "Ana 2");
  expect(store.notice).toBe("Both are there: Ana and Ana 2.");
  sent.length = 0;
  const back = [
    { type: "delete_item", kind: "face", name: "ana_2", unedited: false },
    { type: "restore_item", kind: "expression", name: "smile_2" },
    { type: "rename_item", kind: "face", name: "a", label: "a" },
    { type: "delete_item", kind: "face", name: "a", unedited: true },
  ];
  const forth = [
    { type: "restore_item", kind: "face", name: "a" },
    { type: "rename_item", kind: "face", name: "a", label: "Ana" },
    { type: "delete_item", kind: "expression", name: "smile_2", unedited: false },
    { type: "restore_item", kind: "face", name: "ana_2" },
  ];
  for (let turn = 0; turn < 2; turn++) {
    sent.length = 0;
    for (const _ of back) store.undo();
    expect(asked()).toEqual(back);
    store.undo();
    expect(store.notice).toMatch(/Nothing to undo/);
    for (const _ of forth) store.redo();
    expect(asked()).toEqual([...back, ...forth]);
  }
});

it("says why something is not taken back, and can leave it for what was done before", () => {
  keep("face", "a");
  keep("face", "b");
  store.undo();
  store.receive({ type: "refused", reason: "'b' is on air or coming: call another first.", id: last().id, held: [] });
  expect(store.notice).toBe("Not undone (keep b): 'b' is on air or coming: call another first.");
  store.undo();
  expect(last()).toMatchObject({ name: "b" });
  store.receive({ type: "refused", reason: "'b' is on air or coming: call another first.", id: last().id, held: [] });
  const leave = store.offers.find(({ label }) => label === "Leave it");
  if (leave !== undefined && "act" in leave) leave.act();
  store.undo();
  expect(last()).toMatchObject({ name: "a" });
});

it("takes several back that came in together", () => {
  store.offerUndo("", items.stepOf("take in", [SMILE, { ...SMILE, name: "grin" }]));
  store.undo();
  store.redo();
  expect(sent.map((message) => [message.type, "name" in message && message.name])).toEqual([
    ["delete_item", "smile_2"],
    ["delete_item", "grin"],
    ["restore_item", "smile_2"],
    ["restore_item", "grin"],
  ]);
});
