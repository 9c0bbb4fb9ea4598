/** The field on S of what is dragged: what vectors and muscles add to a draft, at every vertex of the skin. */

import type { Muscle, Net, Vector } from "../../session/control_net";

/** For each place of a net the vertices it moves and by how much: those of place p are `starts[p]` to `starts[p + 1]`. */
export interface Reach {
  starts: Uint32Array;
  vertices: Uint32Array;
  weights: Float32Array;
}

/** Which vertices each point of a net moves. */
export function reachOf(net: Net): Reach {
  const count = net.rows.length;
  const starts = new Uint32Array(count + 1);
  const counts = (slot: number): boolean =>
    (net.corners[slot] as number) < count && (net.weights[slot] as number) !== 0;
  for (let slot = 0; slot < net.corners.length; slot++)
    if (counts(slot))
      starts[(net.corners[slot] as number) + 1] = (starts[(net.corners[slot] as number) + 1] as number) + 1;
  for (let place = 0; place < count; place++)
    starts[place + 1] = (starts[place + 1] as number) + (starts[place] as number);
  const filled = starts.slice();
  const total = starts[count] as number;
  const reach: Reach = { starts, vertices: new Uint32Array(total), weights: new Float32Array(total) };
  for (let slot = 0; slot < net.corners.length; slot++) {
    if (!counts(slot)) continue;
    const place = net.corners[slot] as number;
    const at = filled[place] as number;
    filled[place] = at + 1;
    reach.vertices[at] = Math.floor(slot / 3);
    reach.weights[at] = net.weights[slot] as number;
  }
  return reach;
}

/** Vectors (n, 3) of a net's points and contractions of muscles: what a field is made of besides what lies below it. */
export interface Moves {
  vectors: Float64Array;
  pulls: ReadonlyMap<string, number>;
}

/** Adds to `field` (V, 4: dtheta, dh, R - 1, unused) what `now` adds to `then` (paper, eq. 2); returns whether anything. */
export function addField(
  field: Float32Array,
  reach: Reach,
  muscles: readonly Muscle[],
  now: Moves,
  then: Moves,
): boolean {
  let moved = false;
  for (let place = 0; place + 1 < reach.starts.length; place++) {
    const more = difference(now.vectors, then.vectors, place);
    if (more[0] === 0 && more[1] === 0 && more[2] === 0) continue;
    moved = true;
    for (let slot = reach.starts[place] as number; slot < (reach.starts[place + 1] as number); slot++)
      addTo(field, reach.vertices[slot] as number, more, reach.weights[slot] as number);
  }
  for (const muscle of muscles) {
    const more = (now.pulls.get(muscle.name) ?? 0) - (then.pulls.get(muscle.name) ?? 0);
    if (more === 0) continue;
    moved = true;
    for (let vertex = 0; 3 * vertex < muscle.field.length; vertex++)
      addTo(
        field,
        vertex,
        [muscle.field[3 * vertex], muscle.field[3 * vertex + 1], muscle.field[3 * vertex + 2]] as Vector,
        more,
      );
  }
  return moved;
}

function difference(now: Float64Array, then: Float64Array, place: number): Vector {
  const part = (axis: number): number =>
    (now[3 * place + axis] as number) - (then[3 * place + axis] ?? (axis === 2 ? 1 : 0));
  return [part(0), part(1), part(2)];
}

function addTo(field: Float32Array, vertex: number, vector: Readonly<Vector>, weight: number): void {
  const at = 4 * vertex;
  field[at] = (field[at] as number) + vector[0] * weight;
  field[at + 1] = (field[at + 1] as number) + vector[1] * weight;
  field[at + 2] = (field[at + 2] as number) + vector[2] * weight;
}
