// Colours that people with any colour vision tell apart, and numbers to read them by.

export type Rgb = readonly [number, number, number];

/** Viridis at eleven even steps (van der Walt and Smith, CC0), sRGB 0 to 1: lightness alone tells the order. */
const VIRIDIS: readonly Rgb[] = [
  [0.267, 0.005, 0.329], [0.283, 0.141, 0.458], [0.254, 0.265, 0.53], [0.207, 0.372, 0.553],
  [0.164, 0.471, 0.558], [0.128, 0.567, 0.551], [0.135, 0.659, 0.518], [0.267, 0.749, 0.441],
  [0.478, 0.821, 0.318], [0.741, 0.873, 0.15], [0.993, 0.906, 0.144],
];

/** Colour of a share between 0 and 1, written to `out`. */
export function viridis(share: number, out: [number, number, number]): [number, number, number] {
  const place = Math.min(1, Math.max(0, share || 0)) * (VIRIDIS.length - 1);
  const below = Math.min(VIRIDIS.length - 2, Math.floor(place));
  const from = VIRIDIS[below];
  const to = VIRIDIS[below + 1];
  const part = place - below;
  for (let i = 0; i < 3; i++) out[i] = from[i] + part * (to[i] - from[i]);
  return out;
}

/** The same for a legend: a CSS gradient from left to right. */
export function viridisGradient(): string {
  return `linear-gradient(to right, ${VIRIDIS.map((rgb) => css(rgb)).join(", ")})`;
}

export function css(rgb: Rgb): string {
  return `rgb(${rgb.map((part) => Math.round(255 * part)).join(" ")})`;
}

/** Okabe and Ito's colours, which stay apart for all common kinds of colour blindness; without black and yellow. */
const APART: readonly Rgb[] = [
  [0, 0.447, 0.698], [0.902, 0.624, 0], [0, 0.62, 0.451], [0.8, 0.475, 0.655], [0.337, 0.706, 0.914], [0.835, 0.369, 0],
];

/** A colour for the n-th of many: the six of Okabe and Ito, then the same lighter and darker. */
export function apart(n: number): Rgb {
  const base = APART[n % APART.length];
  const round = Math.floor(n / APART.length) % 3;
  if (round === 0) return base;
  const goal = round === 1 ? 1 : 0;
  return base.map((part) => part + 0.45 * (goal - part)) as [number, number, number];
}

/** Lines in a plot: colour and dashes together, for light and for dark paper (contrast at least 4.5 : 1). */
export interface Stroke {
  light: string;
  dark: string;
  dash: readonly number[];
}

const INKS: readonly Stroke[] = [
  { light: "#0b62a4", dark: "#5cb8f2", dash: [] },
  { light: "#b34700", dark: "#ff9d5c", dash: [7, 3] },
  { light: "#00704f", dark: "#3fd3a3", dash: [2, 3] },
  { light: "#a0316f", dark: "#f08cc0", dash: [9, 3, 2, 3] },
  { light: "#6b5300", dark: "#e6c44c", dash: [4, 2] },
  { light: "#5b45b0", dark: "#b3a4ff", dash: [12, 4] },
  { light: "#00677a", dark: "#5ad1e6", dash: [9, 3, 2, 3, 2, 3] },
  { light: "#8a2525", dark: "#ff8f8f", dash: [3, 5] },
];

/** Ink and dashes of the n-th line; after the eighth the same inks come with other dashes. */
export function stroke(n: number): Stroke {
  const dashes = INKS[(n + 3 * Math.floor(n / INKS.length)) % INKS.length].dash;
  return { ...INKS[n % INKS.length], dash: dashes };
}
