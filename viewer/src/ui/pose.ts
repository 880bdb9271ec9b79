// Points and directions of bodies in the world, from the moment that is shown.

import type { Vector3 } from "three";
import type { Moment } from "../player";
import { WORLD, type Link, type Recording } from "../recording";
import * as rotation from "../rotation";

type Triple = readonly [number, number, number];

const result = new Float64Array(3);

/** A direction in a body's axes, turned into the world's; `out` is written and returned. */
export function turned(moment: Moment, body: number, [x, y, z]: Triple, out: Vector3): Vector3 {
  if (body === WORLD) return out.set(x, y, z);
  rotation.turned(moment.orientations, 4 * body, x, y, z, result, 0);
  return out.fromArray(result);
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

const quaternion = [1, 0, 0, 0];
const origin = [0, 0, 0];

/** The centre of mass of a body in a recorded frame [m]. */
export function bodyCenter(recording: Recording, frame: number, body: number, out: Vector3): Vector3 {
  recording.orientation.read(frame, body, quaternion, 0);
  recording.position.read(frame, body, origin, 0);
  const [x, y, z] = recording.bodies[body].center;
  rotation.turned(quaternion, 0, x, y, z, result, 0);
  return out.set(result[0] + origin[0], result[1] + origin[1], result[2] + origin[2]);
}
