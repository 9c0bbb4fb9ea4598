/** The curves of a run, unpacked: ten samples a second of what showed of each character. */

import { decode } from "@msgpack/msgpack";
import type { RunDocument } from "../../link/messages";

const MISSING = -32768;

/** A column of numbers, or of names; null where the character was not there. */
export type Column<Value> = (Value | null)[];

export interface CharacterCurves {
  values: Record<string, Column<number>>;
  face: Column<string>;
  expression: Column<string>;
}

/** `times`: seconds from the beginning of the run. */
export interface Curves {
  times: number[];
  characters: Record<string, CharacterCurves>;
}

/** Milliseconds, steps and names of a minute, as `RunDocument` says. */
type Piece = [first: number, times: Uint8Array, names: string[], tables: Record<string, Uint8Array>];

async function inflate(data: Uint8Array): Promise<Uint8Array> {
  const stream = new Blob([data.slice()]).stream().pipeThrough(new DecompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

const viewOf = ({ buffer, byteOffset, byteLength }: Uint8Array): DataView =>
  new DataView(buffer, byteOffset, byteLength);

/** Seconds of the samples of a piece, of the clock of the show. */
function timesOf([first, packed]: Piece): number[] {
  const view = viewOf(packed);
  let passed = 0;
  return Array.from({ length: packed.byteLength / 4 }, (_, row) => {
    passed += view.getUint32(4 * row, true);
    return first + passed / 1000;
  });
}

/** One column of a table, in steps. */
function columnOf(table: Uint8Array, column: number, rows: number): Int16Array {
  const view = viewOf(table);
  const steps = new Int16Array(rows);
  let sum = 0;
  for (let row = 0; row < rows; row++) {
    sum = ((sum + view.getInt16(2 * (column * rows + row), true)) << 16) >> 16;
    steps[row] = sum;
  }
  return steps;
}

/** Unpacks the curves of a run; an Error where they cannot be read. */
export async function unpackRun(run: RunDocument): Promise<Curves> {
  const curves: Curves = { times: [], characters: {} };
  const quantities = Object.entries(run.quantities);
  for (const packed of run.pieces) {
    const piece = decode(await inflate(packed)) as Piece;
    const times = timesOf(piece);
    const inside = times.map((time) => time >= run.first && time <= run.first + run.seconds);
    const before = curves.times.length;
    curves.times.push(...times.filter((_, row) => inside[row]).map((time) => time - run.first));
    for (const [name, table] of Object.entries(piece[3])) {
      curves.characters[name] ??= absent(quantities, before);
      addTable(curves.characters[name], table, piece[2], quantities, inside);
    }
    for (const character of Object.values(curves.characters)) fillUp(character, curves.times.length);
  }
  return curves;
}

/** A character that has not been there so far. */
function absent(quantities: [string, number][], rows: number): CharacterCurves {
  const values = Object.fromEntries(quantities.map(([name]) => [name, [] as Column<number>]));
  const character: CharacterCurves = { values, face: [], expression: [] };
  fillUp(character, rows);
  return character;
}

function fillUp({ values, face, expression }: CharacterCurves, rows: number): void {
  for (const column of [...Object.values(values), face, expression]) while (column.length < rows) column.push(null);
}

function addTable(
  character: CharacterCurves,
  table: Uint8Array,
  names: string[],
  quantities: [string, number][],
  inside: boolean[],
): void {
  const read = (place: number) => columnOf(table, place, inside.length).filter((_, row) => inside[row]);
  quantities.forEach(([name, steps], place) => {
    const column = character.values[name];
    for (const step of read(place)) column?.push(step === MISSING ? null : step / steps);
  });
  for (const step of read(quantities.length)) character.face.push(names[step] ?? null);
  for (const step of read(quantities.length + 1)) character.expression.push(names[step] ?? null);
}
