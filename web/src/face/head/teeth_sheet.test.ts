import { describe, expect, it } from "vitest";
import { type CagePlace, COLUMN_ROWS, COLUMNS, type Column, cageColumns, cagePoint, splineShares } from "./teeth_cage";
import { type Shape, teethSheet } from "./teeth_sheet";
import { JAWS, RIBS } from "./tooth_profiles";

/** The rows of columns, from the right end on. */
const rowsOf = (columns: readonly Column[]): number[] => columns.flat();

/** An arch 60 mm wide and 50 mm deep, its edges 18 mm below (lower: above) the gum; positions: metres. */
function arch(upper: boolean): { positions: Float32Array; columns: Column[] } {
  const positions = new Float32Array(3 * COLUMN_ROWS * COLUMNS);
  const down = upper ? -1 : 1;
  const columns = Array.from({ length: COLUMNS }, (_, n): Column => {
    const angle = ((n - (COLUMNS - 1) / 2) / (COLUMNS - 1)) * Math.PI * 1.02;
    const column = [0, 1, 2, 3].map((part) => COLUMN_ROWS * n + part) as unknown as Column;
    const rows: readonly (readonly [number, number])[] = [
      [1, 0],
      [1, 0.009],
      [1, 0.018],
      [0.7, 0.009],
    ];
    rows.forEach(([wide, height], part) => {
      const place = [0.03 * wide * Math.sin(angle), down * height, 0.1 + 0.045 * wide * Math.cos(angle)];
      positions.set(place, 3 * (column[part] as number));
    });
    return column;
  });
  return { positions, columns };
}

/** Points turned, stretched and moved: an affine map that is no rotation. */
function moved(points: Float32Array): Float32Array {
  const out = new Float32Array(points.length);
  for (let at = 0; at < points.length; at += 3) {
    const [x, y, z] = points.subarray(at, at + 3) as unknown as [number, number, number];
    out.set([0.9 * x + 0.2 * z + 0.01, 1.1 * y - 0.3 * x, 0.8 * z + 0.1 * y - 0.02], at);
  }
  return out;
}

const sheets = [true, false].map((upper) => {
  const { positions, columns } = arch(upper);
  const sheet = teethSheet(columns, positions, upper);
  const points = (shape: Shape) =>
    Array.from({ length: shape.places.length / 3 }, (_, n) =>
      cagePoint(columns, positions, Array.from(shape.places.subarray(3 * n, 3 * n + 3)) as unknown as CagePlace),
    );
  return { upper, positions, columns, sheet, points, jaw: upper ? JAWS.upper : JAWS.lower };
});

/** Height, number and share of the other side of each vertex. */
const marks = ({ marks: values }: { marks: Float32Array }) =>
  Array.from(
    { length: values.length / 4 },
    (_, n) => Array.from(values.subarray(4 * n, 4 * n + 3)) as [number, number, number],
  );

describe("the columns of a row of teeth", () => {
  for (const upper of [true, false])
    it(`are found in whatever order its rows come, ${upper ? "upper" : "lower"}`, () => {
      const { positions, columns } = arch(upper);
      const shuffled = rowsOf(columns).sort((a, b) => ((a * 37) % 68) - ((b * 37) % 68));
      expect(cageColumns(shuffled, positions, upper, 0.034)).toEqual(columns);
    });

  it("are not looked for in another mesh", () => {
    const { positions, columns } = arch(true);
    expect(cageColumns(rowsOf(columns).slice(1), positions, true, 0.034)).toBeUndefined();
  });
});

describe("a place in the cage", () => {
  it("has shares of its columns that add up to 1", () => {
    for (const t of [0, 0.1, 0.5, 0.9, 1])
      expect(splineShares(t).reduce((sum, share) => sum + share)).toBeCloseTo(1, 12);
  });

  it("is the column's own rows at edge and gum, at every column", () => {
    const { positions, columns } = arch(true);
    columns.forEach(([gum, , edge], column) => {
      for (const [up, row] of [
        [0, edge],
        [1, gum],
      ] as const)
        cagePoint(columns, positions, [column, up, 0]).forEach((value, axis) => {
          expect(value).toBeCloseTo(positions[3 * row + axis] as number, 6);
        });
    });
  });

  it("goes along with whatever turns, stretches and moves all rows alike", () => {
    const { positions, columns } = arch(false);
    const after = moved(positions);
    for (const place of [
      [0.3, 0.2, 0.1],
      [7.8, -0.3, 1.2],
      [15.9, 1.4, 0.6],
    ] as const) {
      const expected = moved(Float32Array.from(cagePoint(columns, positions, place)));
      cagePoint(columns, after, place).forEach((value, axis) => {
        expect(value).toBeCloseTo(expected[axis] as number, 6);
      });
    }
  });
});

describe("the sheet of a jaw's teeth", () => {
  it("stays below three thousand vertices with both jaws and the cast's tongue", () => {
    const vertices = sheets.reduce((sum, { sheet }) => sum + sheet.marks.length / 4, 0);
    expect(vertices).toBeLessThan(3000 - 226);
  });

  for (const kind of ["person", "milk", "carnivore"] as const)
    it(`has teeth that follow each other along the arch without lying over one another, ${kind}`, () => {
      for (const { sheet } of sheets) {
        const columns = sheet[kind].places.filter((_, at) => at % (3 * RIBS) === 0);
        for (let n = 1; n < columns.length; n++) expect(columns[n]).toBeGreaterThan(columns[n - 1] as number);
      }
    });

  it("is the same on both sides", () => {
    for (const { sheet, points } of sheets)
      for (const kind of ["person", "milk", "carnivore"] as const) {
        const places = points(sheet[kind]);
        const columns = places.length / RIBS;
        places.forEach(([x, y, z], at) => {
          const other = places[(columns - 1 - Math.floor(at / RIBS)) * RIBS + (at % RIBS)] as readonly number[];
          expect(-x).toBeCloseTo(other[0] as number, 5);
          expect(y).toBeCloseTo(other[1] as number, 5);
          expect(z).toBeCloseTo(other[2] as number, 5);
        });
      }
  });

  it("ends at the cage's edge, give or take the row's own step, and keeps its gum within the cage", () => {
    for (const { sheet, jaw } of sheets) {
      const ups = sheet.person.places.filter((_, at) => at % 3 === 1);
      marks(sheet).forEach(([height, , across], n) => {
        const up = 18 * (ups[n] as number);
        if (height === 1) expect(Math.abs(up + jaw.person.over)).toBeLessThan(3);
        if (height === -1 && across === 0) expect(up).toBeLessThan(15.001);
      });
    }
  });

  it("has its outer crowns between the cage's outer side and the tooth's depth", () => {
    for (const { sheet, jaw } of sheets) {
      const deepest = Math.max(...jaw.person.teeth.map(({ depth }) => depth));
      const thick = 1000 * 0.3 * 0.03; // at the ends; more in front
      marks(sheet).forEach(([height], n) => {
        const inward = sheet.person.places[3 * n + 2] as number;
        if (height <= 0) return;
        expect(inward).toBeGreaterThanOrEqual(0);
        expect(inward * thick).toBeLessThan(deepest + jaw.person.inside + 0.5);
      });
    }
  });

  it("has crowns of the heights in its table, from the gum's middle to the edge", () => {
    for (const { sheet, jaw } of sheets) {
      const places = sheet.person.places;
      jaw.person.teeth.forEach((tooth, number) => {
        const middle = marks(sheet).flatMap(([height, at], n) =>
          at === jaw.person.teeth.length + number + 0.5 ? [[height, n] as const] : [],
        );
        const up = (wanted: number) =>
          18 * (places[3 * (middle.find(([height]) => Math.abs(height - wanted) < 1e-6)?.[1] as number) + 1] as number);
        const most = 0.66 * 18 + tooth.over + jaw.person.over; // what the cage lets a crown have
        expect((up(0.5) - up(1)) * 2).toBeCloseTo(Math.min(tooth.height, most), 3);
      });
    }
  });

  it("has fangs that stand out of a carnivore's row, and nobody's else", () => {
    for (const { sheet } of sheets) {
      const lowest = ({ places }: Shape) => 18 * Math.min(...places.filter((_, at) => at % 3 === 1));
      expect(lowest(sheet.carnivore)).toBeLessThan(lowest(sheet.person) - 3);
    }
  });

  it("faces out of the head in front, and towards the other row at its edges", () => {
    for (const { sheet, columns, positions, upper } of sheets) {
      const step = (place: CagePlace, axis: 0 | 1 | 2) => {
        const by = 1e-3;
        const ahead = place.map((value, n) => value + (n === axis ? by : 0)) as unknown as CagePlace;
        const [a, b] = [cagePoint(columns, positions, place), cagePoint(columns, positions, ahead)];
        return a.map((value, n) => ((b[n] as number) - value) / by);
      };
      const cross = (a: number[], b: number[]) =>
        [0, 1, 2].map(
          (n) =>
            (a[(n + 1) % 3] as number) * (b[(n + 2) % 3] as number) -
            (a[(n + 2) % 3] as number) * (b[(n + 1) % 3] as number),
        );
      marks(sheet).forEach(([height, number], n) => {
        if (number !== 7.5) return; // the middle of a front tooth
        const place = Array.from(sheet.person.places.subarray(3 * n, 3 * n + 3)) as unknown as CagePlace;
        const [along, up, inward] = [step(place, 0), step(place, 1), step(place, 2)];
        const [a, b, c] = Array.from(sheet.person.facings.subarray(3 * n, 3 * n + 3)) as [number, number, number];
        const normal = [0, 1, 2].map(
          (axis) =>
            a * (cross(up, inward)[axis] as number) +
            b * (cross(inward, along)[axis] as number) +
            c * (cross(along, up)[axis] as number),
        );
        if (height === 0.5 && n % RIBS < 9) expect(normal[2]).toBeGreaterThan(0);
        if (height === 1) expect((upper ? -1 : 1) * (normal[1] as number)).toBeGreaterThan(0);
      });
    }
  });
});
