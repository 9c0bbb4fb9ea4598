import { expect, it } from "vitest";
import { type ThumbnailSubject, Thumbnails } from "./thumbnails";

/** A canvas as far as a portrait needs one. */
function canvas(isConnected = true) {
  const drawn: unknown[] = [];
  const context = { clearRect: () => {}, drawImage: (picture: unknown) => drawn.push(picture) };
  const element = { isConnected, dataset: {}, width: 10, height: 12, getContext: () => context };
  return { drawn, element: element as unknown as HTMLCanvasElement };
}

const sitting = (expression: string): ThumbnailSubject => ({ face: "generic", expression });
const nextTurn = () => new Promise((done) => setTimeout(done));
const portraits = () => new Thumbnails(() => Promise.resolve());
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
