// How long an arrow stands for how many newtons: round numbers, so that lengths can be read.

import type { Recording } from "../../recording";
import { roundAbove, roundBelow } from "../ticks";

export interface ForceScale {
  /** A round length of arrow [m] ... */
  readonly length: number;
  /** ... that stands for this round force [N]. */
  readonly force: number;
  /** No arrow is drawn longer [m]. */
  readonly longest: number;
}

const FRAMES_LOOKED_AT = 80;
const MOST_FORCES = 20000;

/**
 * An arrow of about `size` [m] for a middling force (the median, by samples): impacts, which press a thousand times
 * harder for one step, must not make resting contacts vanish.
 */
export function forceScale(recording: Recording, size: number): ForceScale {
  const length = roundBelow(size);
  return { length, force: roundAbove(commonForce(recording) || 1), longest: 4 * length };
}

function commonForce(recording: Recording): number {
  const forces: number[] = [];
  const stride = Math.max(1, Math.floor(recording.frames / FRAMES_LOOKED_AT));
  for (let frame = 0; frame < recording.frames && forces.length < MOST_FORCES; frame += stride) {
    const contacts = recording.contacts(frame);
    if (!contacts) return 0;
    for (let i = 0; i < contacts.count; i++) {
      const force = Math.hypot(contacts.force[3 * i], contacts.force[3 * i + 1], contacts.force[3 * i + 2]);
      if (force > 0) forces.push(force);
    }
  }
  forces.sort((a, b) => a - b);
  return forces[Math.floor(0.5 * forces.length)] ?? recording.strongestContact;
}
