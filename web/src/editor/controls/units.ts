/** Numbers as people read and type them. */

const DEGREE = Math.PI / 180;

/** One kind of number: what one of the field's units is in the shown unit, and how many decimals are worth showing. */
export interface Unit {
  readonly name: string;
  readonly per: number;
  readonly decimals: number;
}

export const DEGREES: Unit = { name: "°", per: 1 / DEGREE, decimals: 2 };
export const MILLIMETRES: Unit = { name: "mm", per: 1000, decimals: 2 };
export const PERCENT: Unit = { name: "%", per: 100, decimals: 0 };
export const GAIN: Unit = { name: "×", per: 1, decimals: 2 };
export const RATIO: Unit = { name: "×", per: 1, decimals: 3 };

/** A number with its unit's decimals; never minus nothing. */
export function shown(value: number, unit: Unit): string {
  const text = (value * unit.per).toFixed(unit.decimals);
  return Number(text) === 0 ? (0).toFixed(unit.decimals) : text;
}

/** The inverse of `shown`: what was typed (a comma is a point), or null where it is no number. */
export function typed(text: string, unit: Unit): number | null {
  const value = Number(text.trim().replace(",", ".").replace(unit.name, ""));
  return text.trim() === "" || !Number.isFinite(value) ? null : value / unit.per;
}
