// Points and directions of bodies in the world, from the moment that is shown.

import type { Vector3 } from "three";
import type { Moment } from "../player";
import { WORLD, type Link, type Recording } from "../recording";

type Triple = readonly [number, number, number];

/** A direction in a body's axes, turned into the world's; `out` is written and returned. */
export function turned(moment: Moment, body: number, direction: Triple, out: Vector3): Vector3 {
  if (body === WORLD) return out.set(...direction);
  const q = moment.orientations;
  const at = 4 * body;
  return rotate(q[at], q[at + 1], q[at + 2], q[at + 3], direction, out);
}

/** A point given in a body's frame, in the world [m]. */
export function placed(moment: Moment, body: number, point: Triple, out: Vector3): Vector3 {
  turned(moment, body, point, out);
  if (body === WORLD) return out;
  const p = moment.positions;
  out.x += p[3 * body];
  out.y += p[3 * body + 1];
  out.z += p[3 * body + 2];
  return out;
}

/** Where a joint or spring is tied to body A (end 0) or B (end 1), in the world [m]. */
export function anchor(moment: Moment, link: Link, end: 0 | 1, out: Vector3): Vector3 {
  return placed(moment, link.bodies[end], link.anchors[end], out);
}

/** v' = v + 2 q x (q x v + w v) for a unit quaternion (w, q). */
export function rotate(w: number, x: number, y: number, z: number, v: Triple, out: Vector3): Vector3 {
  const tx = 2 * (y * v[2] - z * v[1]);
  const ty = 2 * (z * v[0] - x * v[2]);
  const tz = 2 * (x * v[1] - y * v[0]);
  return out.set(
    v[0] + w * tx + y * tz - z * ty,
    v[1] + w * ty + z * tx - x * tz,
    v[2] + w * tz + x * ty - y * tx,
  );
}

const quaternion = [1, 0, 0, 0];
const origin = [0, 0, 0];

/** The centre of mass of a body in a recorded frame [m]. */
export function bodyCenter(recording: Recording, frame: number, body: number, out: Vector3): Vector3 {
  recording.orientation.read(frame, body, quaternion, 0);
  recording.position.read(frame, body, origin, 0);
  const [w, x, y, z] = quaternion;
  rotate(w, x, y, z, recording.bodies[body].center, out);
  out.x += origin[0];
  out.y += origin[1];
  out.z += origin[2];
  return out;
}
