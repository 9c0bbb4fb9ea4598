import { beforeEach, describe, expect, it, vi } from "vitest";
import type { FromClient, PadList } from "../../link/messages";
import { ConsoleStore } from "../store/console_store";
import { DRAG_PACE, PadCommands, padsOf } from "./pad_commands";

const pad = (name: string) => ({
  name,
  part: "mouth" as const,
  dimensions: 1,
  looks: [
    { label: "Rest", mix: { neutral: 1 }, place: [-1] },
    { label: "Pout", mix: { pout: 1 }, place: [1] },
  ],
  missing: [],
});
const PADS: PadList = { type: "pad_list", pads: ["faces", "moods", "mouth", "own"].map(pad) };

let sent: FromClient[];
let store: ConsoleStore;
let commands: PadCommands;
const asked = () => {
  store.flush();
  return sent.splice(0);
};

beforeEach(() => {
  sent = [];
  store = new ConsoleStore(
    (message) => sent.push(message),
    () => 0,
    "me",
  );
  store.setOnline(true);
  store.receive(PADS);
  commands = new PadCommands(store);
});

describe("the pads of a show", () => {
  it("stand in the order of the show, those that were chosen first", () => {
    expect(padsOf(store).map(({ name }) => name)).toEqual(["mouth", "moods", "faces", "own"]);
    store.arrange({ pads: ["own", "gone"] });
    expect(padsOf(store).map(({ name }) => name)).toEqual(["own", "faces", "moods", "mouth"]);
  });

  it("keep their choice under another name", () => {
    expect(commands.rename(pad("mouth"), "lips")).toBe("lips");
    expect(store.arrangement.pads).toEqual(["lips", "moods"]);
  });

  it("keep their choice and their name where the show refuses another one", () => {
    const refused = vi.fn();
    commands.rename(pad("mouth"), "lips", refused);
    const id = (asked()[0] as { id: string }).id;
    store.receive({ type: "refused", reason: "lips is taken", id, held: [] });
    expect(refused).toHaveBeenCalledOnce();
    expect(store.arrangement.pads).toEqual(["mouth", "moods"]);
    expect(store.notice).toBe("lips is taken");
  });
});

describe("a change of a pad", () => {
  it("is taken back, and done again, by its key", () => {
    commands.delete(pad("own"));
    const [dropped] = asked();
    expect(dropped).toMatchObject({ type: "drop_pad", name: "own" });
    const key = (dropped as { key: string }).key;
    store.undo();
    store.redo();
    expect(asked()).toMatchObject([
      { type: "restore_pad", key },
      { type: "restore_pad", key },
    ]);
  });

  it("that the show rejects cannot be taken back, and is said", () => {
    commands.copy(pad("own"));
    const [copied] = asked();
    store.receive({ type: "refused", reason: "too many", id: (copied as { id: string }).id, held: [] } as never);
    expect(store.notice).toBe("too many");
    store.undo();
    expect(asked()).toEqual([]);
  });
});

describe("a look that is dragged", () => {
  const at = (place: number) =>
    pad("own").looks.map((look, index) => (index === 1 ? { ...look, place: [place] } : look));

  it("is sent at a pace, the last place always, and taken back as one", () => {
    const drag = commands.drag(pad("own"), "Moved Pout");
    for (let step = 0; step < 20; step += 1) drag.put(at(1 - step / 100), 10 * step);
    drag.end(200);
    const sets = asked() as (FromClient & { looks: { place: number[] }[]; key: string })[];
    expect(sets).toHaveLength(Math.ceil(190 / DRAG_PACE) + 1);
    expect(sets.at(-1)?.looks[1]?.place).toEqual([0.81]);
    expect(new Set(sets.map(({ key }) => key)).size).toBe(1);
    store.undo();
    expect(asked()).toMatchObject([{ type: "restore_pad", key: sets[0]?.key }]);
    expect(store.history.next("undo")).toBeNull();
  });

  it("that was only touched is no change", () => {
    expect(commands.drag(pad("own"), "Moved Pout").end(0)).toBe(false);
    expect(asked()).toEqual([]);
  });
});
