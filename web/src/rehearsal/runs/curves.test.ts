import { encode } from "@msgpack/msgpack";
import { expect, it } from "vitest";
import { unpackRun } from "./curves";

const bytes = (values: Int16Array | Uint32Array): Uint8Array => new Uint8Array(values.buffer);
const MISSING = -32768;

/** A piece with one quantity; `columns`: value, face and expression at each time, as the recorder keeps them. */
async function piece(
  first: number,
  milliseconds: number[],
  names: string[],
  tables: Record<string, number[][]>,
): Promise<Uint8Array> {
  const steps = ([...column]: number[]) => column.map((value, row) => value - (row === 0 ? 0 : (column[row - 1] ?? 0)));
  const packed = Object.entries(tables).map(([name, columns]) => [
    name,
    bytes(Int16Array.from(columns.flatMap(steps))),
  ]);
  const whole = encode([first, bytes(Uint32Array.from(milliseconds)), names, Object.fromEntries(packed)]);
  const stream = new Blob([new Uint8Array(whole)]).stream().pipeThrough(new CompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

it("unpacks minutes one after the other, cut to what was asked for", async () => {
  const run = {
    start: 1,
    first: 100.1,
    seconds: 0.25,
    quantities: { mouth: 1000 },
    cues: [],
    pieces: [
      await piece(100, [0, 100, 100], ["dog", "joy"], {
        one: [
          [0, 500, -500],
          [0, 0, 0],
          [1, 1, 1],
        ],
      }),
      await piece(100.3, [0, 100], ["joy", "old"], {
        one: [
          [1000, 0],
          [1, 1],
          [0, 0],
        ],
        two: [
          [MISSING, 7],
          [MISSING, 1],
          [MISSING, 1],
        ],
      }),
    ],
  };
  const { times, characters } = await unpackRun(run);
  expect(times.map((time) => Math.round(time * 1000))).toEqual([0, 100, 200]);
  expect(characters.one).toEqual({
    values: { mouth: [0.5, -0.5, 1] },
    face: ["dog", "dog", "old"],
    expression: ["joy", "joy", "joy"],
  });
  expect(characters.two).toEqual({
    values: { mouth: [null, null, null] },
    face: [null, null, null],
    expression: [null, null, null],
  });
});

it("has nothing of a run that was recorded without", async () => {
  const none = { start: 1, first: 0, seconds: 9, quantities: {}, cues: [], pieces: [] };
  expect(await unpackRun(none)).toEqual({ times: [], characters: {} });
});
