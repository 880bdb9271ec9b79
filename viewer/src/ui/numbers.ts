// What is known of one body at the moment that is shown, interpolated between frames like the picture.

import type { Moment } from "../player";
import type { Body, Recording, Track } from "../recording";
import { turned } from "../rotation";

export interface BodyNumbers {
  position: [number, number, number];
  /** (w, x, y, z) */
  orientation: [number, number, number, number];
  velocity: [number, number, number];
  angularVelocity: [number, number, number];
  speed: number;
  /** [J]; NaN where it has no bound mass. */
  kineticEnergy: number;
}

const inBody = [0, 0, 0];

export function emptyNumbers(): BodyNumbers {
  return {
    position: [0, 0, 0], orientation: [1, 0, 0, 0], velocity: [0, 0, 0], angularVelocity: [0, 0, 0],
    speed: 0, kineticEnergy: 0,
  };
}

/** Fills `out`. */
export function readBody(recording: Recording, moment: Moment, body: Body, out: BodyNumbers): void {
  const { index } = body;
  for (let i = 0; i < 3; i++) out.position[i] = moment.positions[3 * index + i];
  for (let i = 0; i < 4; i++) out.orientation[i] = moment.orientations[4 * index + i];
  for (let i = 0; i < 3; i++) out.velocity[i] = moment.velocities[3 * index + i];
  for (let i = 0; i < 3; i++) out.angularVelocity[i] = interpolated(recording.angularVelocity, moment, index, i);
  out.speed = Math.hypot(...out.velocity);
  out.kineticEnergy = kineticEnergy(body, out);
}

/** A number of a track between two frames. */
export function interpolated(track: Track, moment: Moment, row: number, component: number): number {
  const now = track.at(moment.frame, row, component);
  if (!moment.fraction) return now;
  return now + moment.fraction * (track.at(moment.frame + 1, row, component) - now);
}

/** m v^2 / 2 + w I w / 2 with the inertia I in body axes: w is turned into them by the inverse of the orientation. */
export function kineticEnergy(body: Body, numbers: BodyNumbers): number {
  if (body.fixed) return 0;
  const [w, x, y, z] = numbers.orientation;
  turned([w, -x, -y, -z], 0, ...numbers.angularVelocity, inBody, 0);
  let twice = body.mass * numbers.speed ** 2;
  for (let i = 0; i < 3; i++) {
    for (let k = 0; k < 3; k++) twice += inBody[i] * body.inertia[3 * i + k] * inBody[k];
  }
  return twice / 2;
}

/** A unit quaternion in words: "30.0° about (0, 0, 1)". */
export function turnInWords(q: readonly number[]): string {
  const sign = q[0] < 0 ? -1 : 1;
  const size = Math.hypot(q[1], q[2], q[3]);
  const angle = (2 * Math.atan2(size, sign * q[0]) * 180) / Math.PI;
  if (angle < 0.005) return "as declared: not turned";
  const axis = [1, 2, 3].map((i) => ((sign * q[i]) / size).toFixed(3).replace("-", "\u2212").replace("\u22120.000", "0.000"));
  return `${angle.toFixed(2)}° about (${axis.join(", ")})`;
}
