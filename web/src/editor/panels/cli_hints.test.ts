import { expect, it } from "vitest";
import { cliHintsOf } from "./cli_hints";

it("an expression goes out as a document and on the face under work", () => {
  const commands = cliHintsOf({ kind: "expression", name: "crooked_smile" }, "dog").map(({ command }) => command);
  expect(commands[0]).toBe("omote file export SHOW.omote crooked_smile -o crooked_smile.json");
  expect(commands[1]).toContain("omote export dog -o dog.glb --expressions crooked_smile");
});

it("a face goes out by its own name", () => {
  expect(cliHintsOf({ kind: "face", name: "my_aunt" }, "dog")[0]?.command).toBe(
    "omote export my_aunt -o my_aunt.glb --show SHOW.omote",
  );
});
