// Numbers as people read them: as many digits as their error allows, a true minus sign, units in print.

const MOST_DIGITS = 10;
const MINUS = "\u2212";
const SUPERSCRIPTS: Record<string, string> = {
  "-": "⁻", "0": "⁰", "1": "¹", "2": "²", "3": "³", "4": "⁴", "5": "⁵", "6": "⁶", "7": "⁷", "8": "⁸", "9": "⁹",
};

/** How many decimals of a number with this absolute error mean something; 0 error: no bound from it. */
export function decimalsFor(error: number): number {
  if (!(error > 0)) return MOST_DIGITS;
  return Math.max(0, Math.min(MOST_DIGITS, Math.floor(-Math.log10(error * 1.000001))));
}

/**
 * A number with at most `digits` significant digits and no more decimals than its error allows.
 * Very large and very small ones are written with a power of ten, what is below its error as 0.
 */
export function number(value: number, digits = 4, error = 0): string {
  if (Number.isNaN(value)) return "none";
  if (!Number.isFinite(value)) return value > 0 ? "infinite" : `${MINUS}infinite`;
  const size = Math.abs(value);
  const decimals = decimalsFor(error);
  if (size < error / 2 || value === 0) return (0).toFixed(Math.min(decimals, digits - 1));
  const exponent = Math.floor(Math.log10(size));
  if (exponent >= Math.max(6, digits) || (exponent < -3 && decimals + exponent > 0 && digits + exponent < 3)) {
    return withPower(value, Math.max(1, Math.min(digits, decimals + exponent + 1)));
  }
  return signed(value, Math.min(decimals, Math.max(0, digits - 1 - exponent)));
}

/** A number that is known exactly, with at most seven digits and no zeros at its end. */
export function exact(value: number): string {
  return number(value, 7).replace(/(\.\d*?)0+(?=\D|$)/, "$1").replace(/\.(?=\D|$)/, "");
}

/** With a fixed number of decimals; never "−0.00". */
export function signed(value: number, decimals: number): string {
  const text = Math.abs(value).toFixed(decimals);
  return value < 0 && Number(text) !== 0 ? MINUS + text : text;
}

function withPower(value: number, digits: number): string {
  const [mantissa, exponent] = Math.abs(value).toExponential(Math.min(20, digits - 1)).split("e") as [string, string];
  return `${value < 0 ? MINUS : ""}${mantissa}\u2009×\u200910${superscript(Number(exponent))}`;
}

/** An integer as superscript characters. */
export function superscript(exponent: number): string {
  return [...String(exponent)].map((letter) => SUPERSCRIPTS[letter] ?? letter).join("");
}

/** A UDUNITS spelling in print: "kg m2 s-1" as "kg m²/s"; "1" and "" as nothing. */
export function unitInPrint(unit: string): string {
  if (unit === "1") return "";
  const over: string[] = [];
  const under: string[] = [];
  for (const part of unit.split(" ").filter(Boolean)) {
    const match = /^(\D+?)(-?\d+)?$/.exec(part);
    if (!match) return unit;
    const power = match[2] === undefined ? 1 : Number(match[2]);
    const size = Math.abs(power);
    (power < 0 ? under : over).push(match[1] + (size === 1 ? "" : superscript(size)));
  }
  const top = over.join("\u202f") || "1";
  if (!under.length) return over.join("\u202f");
  return `${top}/${under.length > 1 ? `(${under.join("\u202f")})` : under[0]}`;
}

/** The number, a narrow space, the unit. */
export function quantity(value: number, unit: string, digits = 4, error = 0): string {
  const text = number(value, digits, error);
  const printed = unitInPrint(unit);
  return printed && Number.isFinite(value) ? `${text}\u202f${printed}` : text;
}

/** A count with its noun: "1 body", "3 bodies". */
export function count(n: number, one: string, many = `${one}s`): string {
  return `${n.toLocaleString("en").replaceAll(",", "\u202f")} ${n === 1 ? one : many}`;
}

/** A speed of playing: "1×", "0.05×". */
export function times(factor: number): string {
  return `${Number(factor.toPrecision(2))}×`;
}

/** Decimals that tell two neighbouring frames apart, for a time readout that does not change its width. */
export function timeDecimals(step: number): number {
  if (!(step > 0)) return 3;
  for (let decimals = 0; decimals < 6; decimals++) {
    const scaled = step * 10 ** decimals;
    if (Math.abs(scaled - Math.round(scaled)) < 1e-6 * scaled && scaled > 0.5) return Math.max(1, decimals);
  }
  return Math.min(6, Math.max(1, Math.ceil(-Math.log10(step)) + 1));
}
