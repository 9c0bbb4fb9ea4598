import { expect, it } from "vitest";
import { type ThumbnailSubject, Thumbnails } from "./thumbnails";

/** A canvas as far as a portrait needs one. */
function canvas(isConnected = true) {
  const drawn: unknown[] = [];
  const context = { clearRect: () => {}, drawImage: (picture: unknown) => drawn.push(picture) };
  const element = {
    isConnected,
    dataset: {},
    style: { opacity: "" },
    width: 10,
    height: 12,
    getContext: () => context,
  };
  return { drawn, element: element as unknown as HTMLCanvasElement };
}

const sitting = (expression: string): ThumbnailSubject => ({ face: "generic", expression });
const nextTurn = () => new Promise((done) => setTimeout(done));
const portraits = () =>
  new Thumbnails(
    () => Promise.resolve(),
    () => Promise.resolve(),
  );
const drawer = (asked: string[]) => (wish: ThumbnailSubject) => {
  asked.push(wish.expression);
  return Promise.resolve(wish as unknown as CanvasImageSource);
};

it("draws in the order of asking, once it knows how to draw, and each picture once", async () => {
  const [asked, first, second, all] = [[] as string[], canvas(), canvas(), portraits()];
  all.ask(first.element, sitting("smile"));
  all.ask(second.element, sitting("sad"));
  await nextTurn();
  expect(asked).toEqual([]);
  all.open(drawer(asked));
  await nextTurn();
  all.ask(first.element, sitting("smile"));
  await nextTurn();
  expect(asked).toEqual(["smile", "sad"]);
  expect(first.drawn).toEqual([sitting("smile")]);
});

it("draws only the newest wish for a canvas, and none for one that left the page", async () => {
  const [asked, one, gone, all] = [[] as string[], canvas(), canvas(false), portraits()];
  all.ask(one.element, sitting("smile"));
  all.ask(one.element, sitting("sad"));
  all.ask(gone.element, sitting("cry"));
  all.open(drawer(asked));
  await nextTurn();
  expect(asked).toEqual(["sad"]);
});

it("hangs a picture that it has drawn before at once, without drawing it again", async () => {
  const [asked, first, second, all] = [[] as string[], canvas(), canvas(), portraits()];
  all.open(drawer(asked));
  all.ask(first.element, sitting("smile"));
  await nextTurn();
  all.ask(second.element, sitting("smile"));
  expect(second.drawn).toEqual([sitting("smile")]);
  expect(asked).toEqual(["smile"]);
});

it("goes on after a picture that cannot be drawn", async () => {
  const [one, two, all] = [canvas(), canvas(), portraits()];
  const warn = console.warn;
  console.warn = () => {};
  all.ask(one.element, sitting("broken"));
  all.ask(two.element, sitting("smile"));
  all.open((wish) =>
    wish.expression === "broken"
      ? Promise.reject(new Error("no"))
      : Promise.resolve(wish as unknown as CanvasImageSource),
  );
  await nextTurn();
  console.warn = warn;
  expect(one.drawn).toEqual([]);
  expect(two.drawn).toHaveLength(1);
});

it("never hangs a picture that was asked for before the last one, however late it comes", async () => {
  const [one, other, all] = [canvas(), canvas(), portraits()];
  const late = new Map<string, () => void>();
  all.open(
    (wish) =>
      new Promise((done) => {
        const give = () => done(wish as unknown as CanvasImageSource);
        if (wish.expression === "slow") late.set("slow", give);
        else give();
      }),
  );
  all.ask(other.element, sitting("smile"));
  await nextTurn();
  all.ask(one.element, sitting("slow")); // is being drawn
  await nextTurn();
  all.ask(one.element, sitting("smile")); // is known, and hangs at once
  late.get("slow")?.();
  await nextTurn();
  expect(one.drawn).toEqual([sitting("smile")]);
});

it("fades the picture of what a canvas no longer stands for until the new one comes", async () => {
  const [one, all] = [canvas(), portraits()];
  const gates: (() => void)[] = [];
  all.open((wish) => new Promise((done) => gates.push(() => done(wish as unknown as CanvasImageSource))));
  all.ask(one.element, sitting("smile"));
  await nextTurn();
  gates[0]?.();
  await nextTurn();
  expect(one.element.style.opacity).toBe("");
  all.ask(one.element, sitting("sad"));
  expect(one.element.style.opacity).toBe("0.25");
  await nextTurn();
  gates[1]?.();
  await nextTurn();
  expect([one.element.style.opacity, one.drawn.at(-1)]).toEqual(["", sitting("sad")]);
});

it("shows the face that is called at once, at rest and bright, until its expression is drawn", async () => {
  const [one, all] = [canvas(), portraits()];
  const gates: (() => void)[] = [];
  const old = { face: "old", expression: "neutral" };
  all.give([
    [sitting("smile"), "generic smiles" as unknown as CanvasImageSource],
    [old, "old at rest" as unknown as CanvasImageSource],
  ]);
  all.open((wish) => new Promise((done) => gates.push(() => done(wish as unknown as CanvasImageSource))));
  all.ask(one.element, sitting("smile"));
  all.ask(one.element, { face: "old", expression: "smile" });
  expect([one.drawn, one.element.style.opacity]).toEqual([["generic smiles", "old at rest"], ""]);
  all.ask(one.element, { face: "old", expression: "smile" });
  await nextTurn();
  gates[0]?.();
  await nextTurn();
  expect([one.drawn.at(-1), one.element.style.opacity]).toEqual([{ face: "old", expression: "smile" }, ""]);
});

it("tries again where a picture could not be drawn for a moment", async () => {
  const [one, all] = [canvas(), portraits()];
  let lost = 2;
  all.open((wish) => {
    lost -= 1;
    return lost >= 0 ? Promise.reject(new Error("lost")) : Promise.resolve(wish as unknown as CanvasImageSource);
  });
  all.ask(one.element, sitting("smile"));
  for (let turn = 0; turn < 5; turn += 1) await nextTurn();
  expect(one.drawn).toEqual([sitting("smile")]);
});

it("hangs a picture that it was given without drawing it, also where it was asked for before", async () => {
  const [asked, first, second, all] = [[] as string[], canvas(), canvas(), portraits()];
  const picture = "a picture" as unknown as CanvasImageSource;
  all.ask(first.element, sitting("smile"));
  all.give([
    [sitting("smile"), picture],
    [sitting("sad"), picture],
  ]);
  all.ask(second.element, sitting("sad"));
  expect([first.drawn, second.drawn]).toEqual([[picture], [picture]]);
  all.open(drawer(asked));
  await nextTurn();
  expect(asked).toEqual([]);
});
