/** Large triangles of the skin, divided so that they can be drawn curved. */

/** The edge, metres on the generic face, above which a triangle shows as one: in a picture of all detail, and else. */
export const LONGEST_EDGE = { detail: 0.014, plain: 0.018 } as const;

/** Vertices on large triangles: each between three vertices of the mesh. */
export interface CurvedTriangles {
  /** Triangles that stay flat, as vertices of the mesh. */
  readonly flat: Uint32Array;
  /** Triangles of the divided part, as its own vertices. */
  readonly curved: Uint32Array;
  /** Per own vertex: three vertices of the mesh. */
  readonly corners: Uint32Array;
  /** Per own vertex: its share of each of the three, sum 1. */
  readonly shares: Float32Array;
}

/** A point on a triangle by its shares of the three corners. */
type Point = readonly [number, number, number];

const CORNERS: readonly Point[] = [
  [1, 0, 0],
  [0, 1, 0],
  [0, 0, 1],
];

/** How long an edge may be, metres, by where its middle lies: it grows no faster than the way, so that all divisions end. */
export type Longest = (middle: readonly number[]) => number;

/**
 * Divides every triangle with an edge over `longest` by bisecting its longest edge until none is (M.-C. Rivara, 1984):
 * the longest by what it may be. Whether an edge is divided is a matter of the edge alone, so both of its sides have the
 * same points and no crack opens. `triangles`: vertices of the mesh; `place`: a vertex's position, metres.
 */
export function divideLong(
  triangles: Uint32Array,
  place: (vertex: number) => readonly number[],
  longest: Longest,
): CurvedTriangles {
  const own = new OwnVertices();
  const [flat, curved]: [number[], number[]] = [[], []];
  for (let at = 0; at < triangles.length; at += 3) {
    const corners = Array.from(triangles.subarray(at, at + 3));
    const places = corners.map(place);
    const parts = divide(CORNERS, places, longest);
    if (parts.length === 1) flat.push(...corners);
    else for (const part of parts) curved.push(...part.map((point) => own.number(corners, point)));
  }
  return {
    flat: Uint32Array.from(flat),
    curved: Uint32Array.from(curved),
    corners: Uint32Array.from(own.corners),
    shares: Float32Array.from(own.shares),
  };
}

/** The parts of a triangle, each three points in the triangle's own winding. */
function divide(
  part: readonly Point[],
  places: readonly (readonly number[])[],
  longest: Longest,
): (readonly Point[])[] {
  const lengths = part.map((point, at) => {
    const other = part[(at + 1) % 3] as Point;
    return distance(point, other, places) / longest(between(point, other, places));
  });
  const length = Math.max(...lengths);
  if (length <= 1) return [part];
  const first = lengths.indexOf(length);
  const [a, b, c] = [part[first], part[(first + 1) % 3], part[(first + 2) % 3]] as [Point, Point, Point];
  const middle: Point = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2, (a[2] + b[2]) / 2];
  return [...divide([a, middle, c], places, longest), ...divide([middle, b, c], places, longest)];
}

function distance(point: Point, other: Point, places: readonly (readonly number[])[]): number {
  const along = [0, 1, 2].map((axis) =>
    places.reduce(
      (sum, place, at) => sum + ((point[at] as number) - (other[at] as number)) * (place[axis] as number),
      0,
    ),
  );
  return Math.hypot(...along);
}

/** Where the middle of two points lies. */
function between(point: Point, other: Point, places: readonly (readonly number[])[]): number[] {
  return [0, 1, 2].map((axis) =>
    places.reduce(
      (sum, place, at) => sum + 0.5 * ((point[at] as number) + (other[at] as number)) * (place[axis] as number),
      0,
    ),
  );
}

/** Numbers the points of the divided part: a point that two triangles share is one vertex. */
class OwnVertices {
  readonly corners: number[] = [];
  readonly shares: number[] = [];
  private readonly vertexByKey = new Map<string, number>();

  number(corners: readonly number[], point: Point): number {
    const order = [0, 1, 2].sort((a, b) => (corners[a] as number) - (corners[b] as number));
    const key = order.flatMap((at) => (point[at] === 0 ? [] : [corners[at], point[at]])).join();
    const existing = this.vertexByKey.get(key);
    if (existing !== undefined) return existing;
    this.corners.push(...order.map((at) => corners[at] as number));
    this.shares.push(...order.map((at) => point[at] as number));
    this.vertexByKey.set(key, this.vertexByKey.size);
    return this.vertexByKey.size - 1;
  }
}
