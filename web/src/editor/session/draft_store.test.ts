import { beforeEach, describe, expect, it, vi } from "vitest";
import type { DraftState, Greeted, ItemDocument, NetDocument, Recipe } from "../../link/editing_messages";
import type { EditorAnswer, Request } from "../link/requests";
import { flat, REST, split, type Vector } from "./control_net";
import { DraftStore } from "./draft_store";
import {
  create,
  matches,
  nextUndo,
  normalised,
  placeAt,
  redo,
  remove,
  describe as rename,
  save,
  undo,
} from "./item_commands";

const bytes = (array: Uint16Array | Float32Array): Uint8Array => new Uint8Array(array.buffer);

const netOf = (rows: number[]): NetDocument => ({
  net: rows,
  triangles: bytes(new Uint16Array([0, 1, 2])),
  corners: bytes(new Uint16Array([0, 1, 2])),
  weights: bytes(new Float32Array([1, 0, 0])),
  mirror: rows.map(() => -1),
});

const recipeOf = (vectors: Vector[], more: Partial<Recipe> = {}): Recipe => ({
  kind: "expression",
  net: vectors.map((_, place) => 10 * place),
  vectors,
  ground: null,
  layers: [],
  pulls: [],
  eyes: [0, 0, 0, 0],
  pupil: 0,
  complexion: [0, 0, 0, 0, 0, 0, 0],
  ...more,
});

const still: Vector[] = [[...REST], [...REST], [...REST]];
const moved: Vector[] = [[0.1, 0, 1], [...REST], [...REST]];

const draftOf = (vectors: Vector[], more: Partial<DraftState> = {}): DraftState => ({
  type: "draft",
  request: -1,
  item: 1,
  recipe: recipeOf(vectors),
  content: "#a",
  undo: 0,
  redo: 0,
  base: 1,
  dirty: false,
  what: "opened",
  net: null,
  miss: 0,
  others: [],
  ...more,
});

const item = (id: number, more: Partial<ItemDocument> = {}): ItemDocument => ({
  id,
  kind: "expression",
  name: `item-${id}`,
  label: `Item ${id}`,
  tags: [],
  place: id,
  head: 1,
  content: "#a",
  deleted: false,
  editors: [],
  ...more,
});

const greeting = (show: string, unsaved: number[] = []): Greeted => ({
  type: "greeted",
  version: 0,
  digest: "",
  show,
  muscles: [],
  regions: [],
  masks: bytes(new Float32Array(0)),
  followers: bytes(new Float32Array(0)),
  anchors: bytes(new Float32Array(0)),
  shares: bytes(new Float32Array(0)),
  items: [item(1), item(2)],
  unsaved,
  unwritable: {},
});

/** A server that answers when the test says so. */
class Script {
  readonly asked: { request: Request; done: (answer: EditorAnswer) => void; fail: (reason: Error) => void }[] = [];
  readonly ask = (request: Request): Promise<EditorAnswer> =>
    new Promise((done, fail) => this.asked.push({ request, done, fail }));

  async answer(place: number, answer: EditorAnswer): Promise<void> {
    this.asked[place]?.done(answer);
    await Promise.resolve();
    await Promise.resolve();
  }

  async refuse(place: number, reason: string): Promise<void> {
    this.asked[place]?.fail(new Error(reason));
    await Promise.resolve();
    await Promise.resolve();
  }
}

let script: Script;
let store: DraftStore;

beforeEach(() => {
  script = new Script();
  store = new DraftStore(script.ask);
  store.setItems([item(1)]);
  store.receive(draftOf(still, { net: netOf([0, 10, 20]) }));
});

const drag = (place: number, by: number): void => {
  store.begin([place]);
  store.live[3 * place] = (store.live[3 * place] as number) + by;
  store.liveChanged();
};

describe("a drag", () => {
  it("goes to the server with all vectors, and stays in sight until the answer", async () => {
    drag(0, 0.2);
    store.letGo([0], [[1, 2, 3]]);
    expect(script.asked[0]?.request).toEqual({
      type: "drag_points",
      item: 1,
      face: store.work,
      points: [0],
      targets: [[1, 2, 3]],
      vectors: [[0.2, 0, 1], [...REST], [...REST]],
    });
    expect(store.live[0]).toBe(0.2);
    await script.answer(0, draftOf(moved, { content: "#b" }));
    expect(split(store.live)).toEqual(moved);
    expect(store.shown).toBe("#b");
  });

  it("goes on under the hand when the answer to one before comes", async () => {
    drag(0, 0.2);
    store.letGo([0], [[1, 2, 3]]);
    drag(1, 0.5);
    await script.answer(0, draftOf(moved));
    expect(store.dragging).toBe(true);
    expect(split(store.live)).toEqual([[0.1, 0, 1], [0.5, 0, 1], [...REST]]);
    store.cancel();
    expect(split(store.live)).toEqual(moved);
  });

  it("does not jump back while a later one is not answered", async () => {
    for (const place of [0, 1]) {
      drag(place, 0.2);
      store.letGo([place], [[0, 0, 0]]);
    }
    const hand = split(store.live);
    await script.answer(0, draftOf(moved));
    expect(split(store.live)).toEqual(hand);
    await script.answer(1, draftOf(still));
    expect(split(store.live)).toEqual(still);
  });

  it("that is refused goes from sight, and the user reads why", async () => {
    drag(0, 0.2);
    store.letGo([0], [[1, 2, 3]]);
    await script.refuse(0, "The point 0 cannot lie there.");
    expect(split(store.live)).toEqual(still);
    expect(store.notices.map(({ text }) => text)).toEqual(["The point 0 cannot lie there."]);
    store.dismiss(store.notices[0]?.id as number);
    expect(store.notices).toEqual([]);
  });

  it("sends nothing when it is cancelled", () => {
    drag(2, 1);
    store.cancel();
    expect(split(store.live)).toEqual(still);
    expect(script.asked).toEqual([]);
  });
});

describe("the net", () => {
  it("keeps the selection at the same points when it is woven anew", () => {
    store.select([1, 2]);
    store.receive(draftOf([...still, [...REST]], { net: netOf([5, 10, 15, 20]) }));
    expect([...store.selection]).toEqual([1, 3]);
  });

  it("of another item takes selection and looks away", () => {
    store.select([1]);
    store.setLook("#old");
    store.receive(draftOf(still, { item: 2, net: netOf([0, 10, 20]) }));
    expect(store.selection.size).toBe(0);
    expect(store.look).toBeNull();
  });
});

describe("an old revision that is looked at", () => {
  it("is shown until an edit is made", () => {
    store.setLook("#old");
    expect(store.shown).toBe("#old");
    store.setVectors(moved, "nudge");
    expect(store.shown).toBe("#a");
  });
});

describe("muscles", () => {
  it("pull on this page at once, and on the server when let go", async () => {
    store.pull("frown", 0.5);
    expect(script.asked).toEqual([]);
    store.sendPulls();
    expect(script.asked[0]?.request).toMatchObject({
      type: "set_pulls",
      pulls: [{ muscle: "frown", contraction: 0.5 }],
    });
    await script.answer(
      0,
      draftOf(still, { recipe: recipeOf(still, { pulls: [{ muscle: "frown", contraction: 0.4 }] }) }),
    );
    expect(store.livePulls.get("frown")).toBe(0.4);
  });
});

describe("undo and redo", () => {
  it("know the names of their steps", async () => {
    store.receive(draftOf(moved, { undo: 2, what: "drag" }));
    undo(store);
    await script.answer(0, draftOf(still, { undo: 1, redo: 1, what: "layers" }));
    await Promise.resolve();
    expect(store.undone).toEqual(["drag"]);
    redo(store);
    await script.answer(1, draftOf(moved, { undo: 2, what: "drag" }));
    await Promise.resolve();
    expect(store.undone).toEqual([]);
  });

  it("are not asked for where there is nothing to undo", () => {
    undo(store);
    redo(store);
    expect(script.asked).toEqual([]);
  });
});

describe("save", () => {
  const saved = { type: "saved", request: 1, item: 1, revision: 2, head: 2, aside: false, sentence: "" } as const;

  it("makes the draft clean and says where to call it", async () => {
    store.receive(draftOf(moved, { dirty: true }));
    const done = save(store, "");
    await script.answer(0, saved);
    await done;
    expect(store.draft).toMatchObject({ dirty: false, base: 2 });
    expect(store.notices[0]?.text).toContain("On the console");
  });

  it("says of an expression that moves nothing that it does so", async () => {
    const saying = async (recipe: Partial<Recipe>, vectors: Vector[] = still): Promise<string> => {
      store.receive(draftOf(vectors, { dirty: true, recipe: recipeOf(vectors, recipe) }));
      const done = save(store, "");
      const at = script.asked.findLastIndex(({ request }) => request.type === "save");
      await script.answer(at, saved);
      await done;
      return store.notices[0]?.text ?? "";
    };
    expect(await saying({})).toContain("It moves nothing yet");
    expect(await saying({ pulls: [{ muscle: "zygomaticus", contraction: 0 }] })).toContain("It moves nothing yet");
    expect(await saying({}, moved)).not.toContain("moves nothing");
    expect(await saying({ eyes: [0.1, 0, 0, 0] })).not.toContain("moves nothing");
    expect(await saying({ pupil: 0.5 })).not.toContain("moves nothing");
  });

  it("over another's offers both ways out", async () => {
    store.receive(draftOf(moved, { dirty: true }));
    const done = save(store, "");
    await script.answer(0, { ...saved, aside: true, head: 3, sentence: "Anna saved meanwhile." });
    await done;
    expect(store.notices[0]).toMatchObject({ kind: "conflict", text: "Anna saved meanwhile." });
    expect(store.notices[0]?.actions.map(({ label }) => label)).toEqual(["Look at theirs", "Save mine over it"]);
  });
});

describe("items", () => {
  it("are made from neutral, from a mix, from what is on air", () => {
    void create(store, "expression", "Grin", { mix: {}, onAir: false });
    void create(store, "face", "Ann", { mix: { old: 1, dog: 3 }, onAir: false });
    void create(store, "expression", "Now", { mix: {}, onAir: true });
    expect(script.asked.map(({ request }) => request)).toEqual([
      { type: "create_expression", label: "Grin", start: {}, on_air: false },
      { type: "create_face", label: "Ann", base: { old: 0.25, dog: 0.75 }, on_air: false },
      { type: "create_expression", label: "Now", start: {}, on_air: true },
    ]);
  });

  it("come back by one press after they were deleted", async () => {
    const done = remove(store, item(1));
    await script.answer(0, { type: "done", request: 1 });
    await done;
    expect(store.draft).toBeNull();
    store.notices[0]?.actions[0]?.act();
    expect(script.asked[1]?.request).toEqual({ type: "restore", item: 1 });
  });

  it("come back by Undo while nothing else was done, open where they were", async () => {
    const removed = async (at: number): Promise<void> => {
      const done = remove(store, item(1));
      await script.answer(at, { type: "done", request: 1 });
      await done;
    };
    await removed(0);
    undo(store);
    expect(script.asked[1]?.request).toEqual({ type: "restore", item: 1 });
    await script.answer(1, { type: "done", request: 2 });
    expect(script.asked[2]?.request).toEqual({ type: "open_item", item: 1 });
    await script.answer(2, draftOf(moved, { undo: 2, what: "drag" }));
    expect(store.deleted).toBeNull();

    await removed(3);
    undo(store);
    void store.ask({ type: "open_item", item: 2 }); // meanwhile
    await script.answer(4, { type: "done", request: 3 });
    expect(script.asked.slice(4).map(({ request }) => request.type)).toEqual(["restore", "open_item"]);
    await script.answer(5, draftOf(moved, { item: 2, undo: 2, what: "drag" }));
    await removed(6);
    store.setOptions({ mirror: true }); // no deed
    store.edit({ type: "set_eyes", eyes: [0, 0, 0, 0], pupil: 0 });
    undo(store);
    expect(script.asked.slice(7).map(({ request }) => request)).toMatchObject([
      { type: "set_eyes", item: 2 },
      { type: "undo", item: 2 },
    ]);
  });

  it("have their names, tags and places back by Undo, the newest first, before a step that was done earlier", async () => {
    const said = (at: number) => script.asked[at]?.request;
    store.receive(draftOf(moved, { undo: 1, what: "drag" }));
    void rename(store, item(1), { label: "Ann" });
    void rename(store, item(1), { tags: ["old"] });
    await script.answer(0, { type: "done", request: 0 });
    await script.answer(1, { type: "done", request: 1 });
    expect(nextUndo(store)).toBe("tags of Ann");
    undo(store);
    expect(said(2)).toEqual({ type: "describe", item: 1, label: "Ann", tags: [], place: 1 });
    await script.answer(2, { type: "done", request: 2 });
    expect(nextUndo(store)).toBe("name Ann");
    undo(store);
    expect(said(3)).toEqual({ type: "describe", item: 1, label: "Item 1", tags: [], place: 1 });
    await script.answer(3, { type: "done", request: 3 });
    await vi.waitFor(() => expect(store.notices.map(({ text }) => text)).toContain("Undone: name Ann."));
    store.notices.find(({ text }) => text === "Undone: name Ann.")?.actions[0]?.act();
    expect(said(4)).toMatchObject({ type: "describe", label: "Ann" });
    await script.answer(4, { type: "done", request: 4 });
    undo(store);
    await script.answer(5, { type: "done", request: 5 });
    expect(nextUndo(store)).toBe("drag");
    undo(store);
    expect(said(6)).toEqual({ type: "undo", item: 1 });

    void rename(store, item(1), { label: "Bo" });
    store.edit({ type: "set_eyes", eyes: [0, 0, 0, 0], pupil: 0 }); // what is done later is taken back first
    await script.answer(7, { type: "done", request: 7 });
    expect(nextUndo(store)).toBe("drag");
  });

  it("may be called as another of their kind, which is said", async () => {
    store.setItems([item(1), item(2, { label: "Grin" }), item(3, { label: "Gone", deleted: true })]);
    const named = async (at: number, label: string): Promise<string[]> => {
      const done = rename(store, item(1), { label });
      await script.answer(at, { type: "done", request: at });
      await done;
      return store.notices.map(({ text }) => text);
    };
    expect(await named(0, "Ann")).toEqual([]);
    expect(await named(1, "Gone")).toEqual([]);
    expect(await named(2, "GRIN")).toEqual([
      'Another expression is called "GRIN" too: on the console both read the same.',
    ]);
  });

  it("are not taken from under the hands by an answer that comes late", async () => {
    void store.ask({ type: "open_item", item: 2 });
    void store.ask({ type: "create_expression", label: "Grin", start: {}, on_air: false });
    await script.answer(1, draftOf(still, { item: 3 }));
    expect(store.draft?.item).toBe(3);
    expect(script.asked[2]?.request).toEqual({ type: "close_item", item: 1 }); // others read who has it open
    await script.answer(0, draftOf(moved, { item: 2 }));
    expect(store.draft?.item).toBe(3);
    void store.ask({ type: "open_item", item: 2 });
    store.edit({ type: "set_eyes", eyes: [0, 0, 0, 0], pupil: 0 });
    await script.answer(3, draftOf(moved, { item: 2 }));
    await script.answer(4, draftOf(still, { item: 3 }));
    expect(store.draft?.item).toBe(2);
  });

  it("are marked while a draft of them is not saved", () => {
    store.receive(greeting("a5", [2]));
    expect([...store.unsaved]).toEqual([2]);
    store.receive(draftOf(moved, { dirty: true }));
    expect([...store.unsaved]).toEqual([2, 1]);
    store.receive(draftOf(still, { dirty: false }));
    expect([...store.unsaved]).toEqual([2]);
  });

  it("of another show are not taken for those that were open", () => {
    store.receive(greeting("a5"));
    store.receive(draftOf(still, { net: netOf([0, 10, 20]) }));
    store.receive(greeting("a5"));
    expect(store.draft).not.toBeNull();
    store.receive(greeting("b7"));
    expect(store.draft).toBeNull();
    expect(store.notices[0]?.text).toContain("Another show");
  });

  it("keep a new name under what is typed next, and take it back where it is refused", async () => {
    store.setItems([item(1)]);
    void rename(store, item(1), { label: "Grumpy" });
    void rename(store, item(1), { tags: ["act two"] }); // as a panel knows it that has not been drawn again
    expect(script.asked[1]?.request).toMatchObject({ label: "Grumpy", tags: ["act two"] });
    store.setItems([item(1)]);
    const refused = rename(store, item(1), { label: "Taken" });
    expect(store.items[0]?.label).toBe("Taken");
    await script.refuse(2, "Taken is taken.");
    await refused;
    expect(store.items[0]?.label).toBe("Item 1");
  });

  it("are put between their new neighbours", () => {
    const others = [item(1), item(2), item(4)];
    for (let at = 0; at <= others.length; at += 1) {
      const places = others.map(({ place }) => place).toSpliced(at, 0, placeAt(others, at));
      expect(places).toEqual(places.toSorted((a, b) => a - b));
      expect(new Set(places).size).toBe(places.length);
    }
  });

  it("are found by all words of a search, in names and tags", () => {
    expect(matches("crook smi", "Crooked smile")).toBe(true);
    expect(matches("act2", "Crooked smile", ["act2"])).toBe(true);
    expect(matches("smile frown", "Crooked smile")).toBe(false);
    expect(matches("", "anything")).toBe(true);
  });
});

it("weights of a mix sum to one in the same proportions", () => {
  expect(normalised({ a: 3, b: 1 })).toEqual({ a: 0.75, b: 0.25 });
  expect(normalised({ a: 0, b: 0 })).toEqual({ a: 0.5, b: 0.5 });
});

it("vectors survive being laid flat", () => {
  expect(split(flat(moved))).toEqual(moved);
});
