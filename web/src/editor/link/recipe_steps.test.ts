import { expect, it } from "vitest";
import { RecipeSteps } from "./recipe_steps";

/** A server that has a list of names, and answers when it is told to. */
class Server {
  names: readonly string[] = [];
  readonly asked: string[] = [];
  readonly answers: (() => void)[] = [];
  readonly steps = new RecipeSteps<readonly string[]>(() => this.names);

  put(name: string, refused = false): void {
    this.steps.add(
      (names) => [...names, name],
      (names, answered) =>
        new Promise<void>((done) => {
          this.asked.push(names.join());
          this.answers.push(() => {
            answered();
            if (!refused) this.names = names;
            done();
          });
        }),
    );
  }

  async answer(): Promise<void> {
    this.answers.shift()?.();
    for (let turn = 0; turn < 5; turn += 1) await Promise.resolve();
  }
}

it("keeps each of many quick steps, in order, and shows them at once", async () => {
  const server = new Server();
  for (const name of ["dog", "old", "cat"]) server.put(name);
  expect(server.asked).toEqual(["dog"]);
  expect(server.steps.shown(server.names)).toEqual(["dog", "old", "cat"]);
  for (const shown of [["dog"], ["dog", "old"], ["dog", "old", "cat"]]) {
    await server.answer();
    expect(server.names).toEqual(shown);
    expect(server.steps.shown(server.names)).toEqual(["dog", "old", "cat"]);
  }
  expect(server.asked).toEqual(["dog", "dog,old", "dog,old,cat"]);
  expect(server.steps.size).toBe(0);
});

it("goes on after a step that is refused, which goes from sight", async () => {
  const server = new Server();
  server.put("dog");
  server.put("nobody", true);
  server.put("cat");
  while (server.answers.length > 0) await server.answer();
  expect(server.names).toEqual(["dog", "cat"]);
  expect(server.steps.shown(server.names)).toEqual(["dog", "cat"]);
});

it("says when all have been answered, so that a save comes after them", async () => {
  const server = new Server();
  let empty = false;
  await server.steps.empty();
  server.put("dog");
  server.put("cat");
  void server.steps.empty().then(() => {
    empty = true;
  });
  await server.answer();
  expect(empty).toBe(false);
  await server.answer();
  expect(empty).toBe(true);
});

it("forgets the steps of an item that is left", async () => {
  const server = new Server();
  server.put("dog");
  server.put("cat");
  server.steps.forget();
  await server.answer();
  expect(server.asked).toEqual(["dog"]);
  expect(server.steps.shown(server.names)).toEqual(["dog"]);
});
