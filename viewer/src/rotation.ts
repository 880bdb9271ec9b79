// Unit quaternions (w, x, y, z) in long lists of numbers.

import type { Numbers } from "./recording";

/** Turns the vector `x, y, z` by the quaternion at `q[at]`, into `out[to]`. v' = v + 2 w (u x v) + 2 u x (u x v). */
export function turned(q: Numbers, at: number, x: number, y: number, z: number, out: Numbers, to: number): void {
  const w = q[at], a = q[at + 1], b = q[at + 2], c = q[at + 3];
  const tx = 2 * (b * z - c * y), ty = 2 * (c * x - a * z), tz = 2 * (a * y - b * x);
  out[to] = x + w * tx + b * tz - c * ty;
  out[to + 1] = y + w * ty + c * tx - a * tz;
  out[to + 2] = z + w * tz + a * ty - b * tx;
}

/** The quaternion product p q into `out[to]`: first q, then p. */
export function product(p: Numbers, at: number, q: Numbers, from: number, out: Numbers, to: number): void {
  const pw = p[at], px = p[at + 1], py = p[at + 2], pz = p[at + 3];
  const qw = q[from], qx = q[from + 1], qy = q[from + 2], qz = q[from + 3];
  out[to] = pw * qw - px * qx - py * qy - pz * qz;
  out[to + 1] = pw * qx + px * qw + py * qz - pz * qy;
  out[to + 2] = pw * qy - px * qz + py * qw + pz * qx;
  out[to + 3] = pw * qz + px * qy - py * qx + pz * qw;
}

/** Above this cosine the chord and the arc between two unit quaternions differ by less than 1e-5. */
const NEARLY_THE_SAME = 0.9995;

/** On the shorter arc from the quaternion at `q[at]` to the one behind it at `q[at + 4]`, into `out[to]`.
 *  Shoemake, Animating rotation with quaternion curves, SIGGRAPH 1985. */
export function between(q: Numbers, at: number, fraction: number, out: Numbers, to: number): void {
  let cosine = 0;
  for (let k = 0; k < 4; k++) cosine += q[at + k] * q[at + 4 + k];
  const sign = cosine < 0 ? -1 : 1;
  let first = 1 - fraction, second = sign * fraction;
  if (sign * cosine < NEARLY_THE_SAME) {
    const angle = Math.acos(sign * cosine), sine = Math.sin(angle);
    first = Math.sin((1 - fraction) * angle) / sine;
    second = (sign * Math.sin(fraction * angle)) / sine;
  }
  let square = 0;
  for (let k = 0; k < 4; k++) {
    out[to + k] = first * q[at + k] + second * q[at + 4 + k];
    square += out[to + k] ** 2;
  }
  const length = Math.sqrt(square) || 1;
  for (let k = 0; k < 4; k++) out[to + k] /= length;
}
