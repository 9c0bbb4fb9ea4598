import { describe, expect, it } from "vitest";
import type { Layer, PreviewLayers, Recipe } from "../../link/editing_messages";
import type { EditorAnswer, Request } from "../link/requests";
import { LayerPreview } from "./layer_preview";

const layer = (label: string, weight = 1, muted = false): Layer => ({
  source: label.toLowerCase(),
  label,
  weight,
  region: null,
  mirrored: false,
  muted,
});

/** A draft with layers and a server that answers when told. */
function draft(layers: Layer[]) {
  const asked: PreviewLayers[] = [];
  const answers: ((answer: EditorAnswer | null) => void)[] = [];
  let changes = 0;
  const recipe = { layers, vectors: [[1, 2, 3]], pulls: [], eyes: [1, 0, 0, 0], pupil: 1, ground: "#g" };
  const store = {
    draft: { item: 7 },
    recipe: recipe as unknown as Recipe,
    ask: (request: Request) => {
      asked.push(request as PreviewLayers);
      return new Promise<EditorAnswer | null>((resolve) => answers.push(resolve));
    },
    tell: () => {
      changes += 1;
    },
  };
  const preview = new LayerPreview(store);
  const answer = async (content: string, item = 7): Promise<void> => {
    answers.shift()?.({ type: "previewed", request: 0, item, content });
    await new Promise((done) => setTimeout(done));
  };
  return { preview, store, asked, answer, changes: () => changes };
}

describe("layers that are tried", () => {
  it("are asked for one at a time: of what came meanwhile only the last", async () => {
    const { preview, asked, answer, changes } = draft([layer("Smile")]);
    for (const weight of [0.1, 0.2, 0.3]) preview.show([layer("Smile", weight)]);
    expect(asked.map(({ layers }) => layers[0]?.weight)).toEqual([0.1]);
    await answer("#1");
    expect(preview.content).toBe("#1");
    expect(changes()).toBe(1);
    expect(asked.map(({ layers }) => layers[0]?.weight)).toEqual([0.1, 0.3]);
    expect(asked.every(({ alone, item }) => !alone && item === 7)).toBe(true);
  });

  it("give way to the draft once it has changed, even if an answer comes late", async () => {
    const { preview, store, answer } = draft([layer("Smile")]);
    preview.show([layer("Smile", 0.4)]);
    store.recipe = { ...store.recipe, layers: [layer("Smile", 0.4)] };
    preview.renew();
    await answer("#late");
    expect(preview.content).toBeNull();
  });

  it("of an item that was left are not shown", async () => {
    const { preview, answer } = draft([layer("Smile")]);
    preview.show([layer("Smile", 0.4)]);
    await answer("#other", 8);
    expect(preview.content).toBeNull();
  });
});

describe("solo", () => {
  it("asks for its layers alone, muted ones too, and goes on when the draft changes", async () => {
    const { preview, store, asked, answer } = draft([layer("Smile"), layer("Frown", 0.5, true)]);
    preview.toggleSolo(1);
    expect(asked[0]).toMatchObject({ alone: true, layers: [layer("Frown", 0.5)] });
    await answer("#alone");
    expect(preview.content).toBe("#alone");
    store.recipe = { ...store.recipe, layers: [layer("Smile"), layer("Frown", 0.9, true)] };
    preview.renew();
    expect(asked[1]).toMatchObject({ alone: true, layers: [layer("Frown", 0.9)] });
    expect(preview.content).toBe("#alone"); // until the new one is here
  });

  it("shows nothing of the recipe but its layers, and all of it without solo", () => {
    const { preview, store } = draft([layer("Smile"), layer("Frown")]);
    expect(preview.shown(store.recipe)).toBe(store.recipe);
    preview.toggleSolo(0);
    const shown = preview.shown(store.recipe);
    expect(shown.layers).toEqual([layer("Smile")]);
    expect([shown.vectors, shown.eyes, shown.pupil, shown.ground]).toEqual([[], [0, 0, 0, 0], 0, null]);
  });

  it("ends with its last layer, and when it is told to", async () => {
    const { preview, store, answer } = draft([layer("Smile")]);
    preview.toggleSolo(0);
    await answer("#alone");
    preview.toggleSolo(0);
    expect([preview.content, preview.solo.size]).toEqual([null, 0]);
    preview.toggleSolo(0);
    store.recipe = { ...store.recipe, layers: [] };
    preview.renew();
    expect(preview.solo.size).toBe(0); // the layer is gone
    expect(preview.end()).toBe(false);
  });
});
