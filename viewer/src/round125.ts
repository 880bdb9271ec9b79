// Numbers that people like.

/** The number 1, 2 or 5 times a power of ten that is near a positive number. */
export function round125(near: number): number {
  const exponent = Math.floor(Math.log10(near));
  const lead = near / 10 ** exponent;
  // As text, since powers of ten that are computed are not always the nearest numbers to them.
  return Number(lead < 7.5 ? `${lead < 1.5 ? 1 : lead < 3.5 ? 2 : 5}e${exponent}` : `1e${exponent + 1}`);
}
