// Numbers that people like.

/** The number 1, 2 or 5 times a power of ten that is near a positive number. */
export function round125(near: number): number {
  const power = 10 ** Math.floor(Math.log10(near));
  const lead = near / power;
  return power * (lead < 1.5 ? 1 : lead < 3.5 ? 2 : lead < 7.5 ? 5 : 10);
}
