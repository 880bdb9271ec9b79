// Where everything is between two frames.

import type { Moment } from "./player";
import type { Recording } from "./recording";
import { between, turned } from "./rotation";

/** A body moves smoothly between two frames when its way is so close to that of (v0 + v1) / 2, and when its velocity
 *  changes at most so many times as much as between the frames before or behind; one that was hit does not. */
const SMOOTH = 0.1;
const SUDDEN = 3;

/** A time that is off by this share of the way between two frames means the frame: 0.7 where it is 0.7000000000000001. */
const NEAR = 1e-9;

/** Fills in moments of a recording. */
export class MomentFinder {
  readonly moment: Moment;
  private readonly q = new Float64Array(8);
  private readonly p = new Float64Array(6);
  private readonly v = new Float64Array(6);
  private readonly offset = new Float64Array(3);

  constructor(private readonly recording: Recording) {
    const bodies = recording.bodies.length;
    this.moment = {
      time: 0,
      frame: 0,
      fraction: 0,
      positions: new Float64Array(3 * bodies).fill(NaN),
      orientations: new Float64Array(4 * bodies).fill(NaN),
      velocities: new Float64Array(3 * bodies).fill(NaN),
    };
  }

  /** The moment becomes that of a time within the recording; the numbers of a frame where it is exactly one. */
  show(time: number): void {
    const { recording, moment } = this;
    moment.time = time;
    if (!recording.frames) return;
    const before = frameBefore(recording.times, recording.frames, time);
    const next = Math.min(before + 1, recording.frames - 1);
    const span = recording.times[next] - recording.times[before];
    const fraction = span > 0 ? Math.min(1, Math.max(0, (time - recording.times[before]) / span)) : 0;
    const frame = fraction > 1 - NEAR ? next : before;
    moment.frame = frame;
    moment.fraction = fraction < NEAR || fraction > 1 - NEAR ? 0 : fraction;
    for (let body = 0; body < recording.bodies.length; body++) {
      if (moment.fraction === 0) this.copy(body, frame);
      else this.blend(body, frame, span);
    }
  }

  private copy(body: number, frame: number): void {
    const { recording, moment } = this;
    recording.position.read(frame, body, moment.positions, 3 * body);
    recording.orientation.read(frame, body, moment.orientations, 4 * body);
    recording.velocity.read(frame, body, moment.velocities, 3 * body);
  }

  /** The centre of mass moves on the cubic that has the recorded velocities at both ends (Hermite), or straight
   *  when something hit it on the way; the body turns about it. */
  private blend(body: number, frame: number, span: number): void {
    const { recording, moment, q, p, v, offset } = this;
    const f = moment.fraction;
    recording.orientation.read(frame, body, q, 0);
    recording.orientation.read(frame + 1, body, q, 4);
    between(q, 0, f, moment.orientations, 4 * body);
    for (let end = 0; end < 2; end++) {
      recording.position.read(frame + end, body, p, 3 * end);
      recording.velocity.read(frame + end, body, v, 3 * end);
    }
    const center = recording.bodies[body].center;
    const eccentric = center[0] !== 0 || center[1] !== 0 || center[2] !== 0;
    if (eccentric) {
      for (let end = 0; end < 2; end++) {
        turned(q, 4 * end, center[0], center[1], center[2], offset, 0);
        for (let k = 0; k < 3; k++) p[3 * end + k] += offset[k];
      }
    }
    const smooth = isSmooth(p, v, span) && this.changesAsBefore(body, frame);
    for (let k = 0; k < 3; k++) {
      moment.velocities[3 * body + k] = v[k] + f * (v[3 + k] - v[k]);
      moment.positions[3 * body + k] = smooth
        ? cubic(p[k], p[3 + k], v[k] * span, v[3 + k] * span, f)
        : p[k] + f * (p[3 + k] - p[k]);
    }
    if (eccentric) {
      turned(moment.orientations, 4 * body, center[0], center[1], center[2], offset, 0);
      for (let k = 0; k < 3; k++) moment.positions[3 * body + k] -= offset[k];
    }
  }

  /** Of the velocity, from this frame to the next, against the frames around them. */
  private changesAsBefore(body: number, frame: number): boolean {
    const here = this.change(body, frame);
    return here <= SUDDEN * Math.max(this.change(body, frame - 1), this.change(body, frame + 1));
  }

  /** How much the velocity changes from a frame to the next; 0 outside of the recording. */
  private change(body: number, frame: number): number {
    const { velocity, frames } = this.recording;
    if (frame < 0 || frame + 1 >= frames) return 0;
    let square = 0;
    for (let k = 0; k < 3; k++) square += (velocity.at(frame + 1, body, k) - velocity.at(frame, body, k)) ** 2;
    return Math.sqrt(square);
  }
}

/** The last frame that is not after a time; 0 before the first. */
export function frameBefore(times: Float64Array, frames: number, time: number): number {
  let low = 0, high = frames - 1;
  while (low < high) {
    const middle = (low + high + 1) >> 1;
    if (times[middle] <= time) low = middle;
    else high = middle - 1;
  }
  return low;
}

function isSmooth(p: Float64Array, v: Float64Array, span: number): boolean {
  let off = 0, way = 0;
  for (let k = 0; k < 3; k++) {
    const mean = ((v[k] + v[3 + k]) / 2) * span;
    off += (p[3 + k] - p[k] - mean) ** 2;
    way += mean * mean;
  }
  return off <= SMOOTH * SMOOTH * way;
}

function cubic(p0: number, p1: number, m0: number, m1: number, f: number): number {
  const g = 1 - f;
  return g * g * ((1 + 2 * f) * p0 + f * m0) + f * f * ((3 - 2 * f) * p1 - g * m1);
}
