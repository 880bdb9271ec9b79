// Round numbers along an axis: 1, 2 or 5 times a power of ten.

export interface Ticks {
  values: number[];
  /** Power of ten taken out of the labels; 0 for none. */
  exponent: number;
  labels: string[];
}

/** Rounding of what was subtracted moves a quotient by less than this. */
const NOISE = 1e-6;

/** The largest of 1, 2, 5 times a power of ten that is not above `size` (> 0). */
export function roundBelow(size: number): number {
  const power = 10 ** Math.floor(Math.log10(size));
  const lead = size / power;
  return (lead >= 5 - NOISE ? 5 : lead >= 2 - NOISE ? 2 : 1) * power;
}

/** The smallest of 1, 2, 5 times a power of ten that is not below `size` (> 0). */
export function roundAbove(size: number): number {
  const power = 10 ** Math.floor(Math.log10(size));
  const lead = size / power;
  return (lead <= 1 + NOISE ? 1 : lead <= 2 + NOISE ? 2 : lead <= 5 + NOISE ? 5 : 10) * power;
}

/** Ticks from `low` to `high`, about `wanted` of them, with labels that carry just the digits they need. */
export function ticks(low: number, high: number, wanted: number): Ticks {
  if (!(high > low) || !Number.isFinite(high - low)) return { values: [low], exponent: 0, labels: [short(low)] };
  const step = roundAbove((high - low) / Math.max(1, wanted));
  const values: number[] = [];
  for (let i = Math.ceil(low / step - NOISE); i * step <= high + NOISE * step; i++) values.push(i * step + 0);
  const exponent = powerOf(Math.max(Math.abs(low), Math.abs(high)));
  const decimals = Math.max(0, Math.min(12, -Math.floor(Math.log10(step) + 1e-9) + exponent));
  const labels = values.map((value) => fixed(value / 10 ** exponent, decimals));
  return { values, exponent, labels };
}

/** Thousands and thousandths go into the axis title, so that labels stay short. */
function powerOf(largest: number): number {
  if (largest === 0) return 0;
  const exponent = Math.floor(Math.log10(largest));
  return exponent >= 4 || exponent < -2 ? 3 * Math.floor(exponent / 3) : 0;
}

function fixed(value: number, decimals: number): string {
  const text = Math.abs(value).toFixed(decimals);
  return value < 0 && Number(text) !== 0 ? `\u2212${text}` : text;
}

function short(value: number): string {
  return Number.isFinite(value) ? fixed(Number(value.toPrecision(4)), 0) : "";
}

/** An interval that holds `low` and `high` with a little air, and is never empty. */
export function withAir(low: number, high: number): [number, number] {
  if (!(low <= high)) return [0, 1];
  const span = high - low;
  const smallest = 1e-9 * Math.max(Math.abs(low), Math.abs(high));
  if (span <= smallest) {
    const air = Math.abs(low) > 0 ? 0.1 * Math.abs(low) : 1;
    return [low - air, high + air];
  }
  return [low - 0.06 * span, high + 0.06 * span];
}
