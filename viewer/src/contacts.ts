// Contact points of a page, frame by frame.

import type { Codes } from "./coding";
import type { ContactsHead } from "./head";
import type { Contacts } from "./recording";
import type { Sections } from "./sections";

/** All contact points, sorted by frame, in the form they were packed in. */
export class PackedContacts {
  private readonly current: Contacts;
  readonly strongest: number;

  /** Points of frame k are those from offset[k] to offset[k + 1], `order` says where they stand in the columns. */
  private constructor(
    private readonly offset: Int32Array,
    private readonly order: Int32Array,
    private readonly inFile: Codes,
    private readonly bodyA: Codes,
    private readonly bodyB: Codes,
    private readonly sliding: Codes,
    private readonly position: Codes,
    private readonly scale: Float64Array,
    private readonly force: Float32Array,
  ) {
    this.current = emptyContacts(mostInAFrame(offset));
    this.strongest = Math.sqrt(largestSquare(force));
  }

  static async from(head: ContactsHead, frames: number, planes: number, sections: Sections): Promise<PackedContacts> {
    const frame = await sections.codes(head.frame);
    const [offset, order] = byFrame(frame, frames);
    return new PackedContacts(
      offset,
      order,
      await sections.codes(head.in_file),
      await sections.codes(head.body_a),
      await sections.codes(head.body_b),
      await sections.codes(head.sliding),
      await sections.codes(head.position),
      await sections.doubles(head.scale),
      asFloats(await sections.codes(head.force), planes),
    );
  }

  /** The points of a frame; the same object every time. */
  at(frame: number): Contacts {
    const out = this.current;
    const start = this.offset[frame];
    out.count = this.offset[frame + 1] - start;
    out.omitted = this.inFile[frame] - out.count;
    for (let k = 0; k < out.count; k++) {
      const row = this.order[start + k];
      out.bodyA[k] = this.bodyA[row];
      out.bodyB[k] = this.bodyB[row];
      out.sliding[k] = this.sliding[row];
      for (let axis = 0; axis < 3; axis++) {
        out.position[3 * k + axis] = this.scale[axis] + this.position[3 * row + axis] * this.scale[3 + axis];
        out.force[3 * k + axis] = this.force[3 * row + axis];
      }
    }
    return out;
  }
}

/** Room for so many points. */
export function emptyContacts(most: number): Contacts {
  return {
    count: 0,
    omitted: 0,
    bodyA: new Int32Array(most),
    bodyB: new Int32Array(most),
    position: new Float64Array(3 * most),
    force: new Float64Array(3 * most),
    sliding: new Uint8Array(most),
  };
}

/** Sorts by counting: how many points come before each frame, and which they are. */
function byFrame(frame: Codes, frames: number): [Int32Array, Int32Array] {
  const offset = new Int32Array(frames + 1);
  for (const number of frame) offset[number + 1]++;
  for (let k = 0; k < frames; k++) offset[k + 1] += offset[k];
  const next = offset.slice();
  const order = new Int32Array(frame.length);
  for (let row = 0; row < frame.length; row++) order[next[frame[row]]++] = row;
  return [offset, order];
}

/** The upper bytes of float32 with zeros for the rest. */
function asFloats(codes: Codes, planes: number): Float32Array {
  const bits = new Uint32Array(codes.length);
  for (let k = 0; k < codes.length; k++) bits[k] = codes[k] << (32 - 8 * planes);
  return new Float32Array(bits.buffer);
}

function mostInAFrame(offset: Int32Array): number {
  let most = 0;
  for (let k = 1; k < offset.length; k++) most = Math.max(most, offset[k] - offset[k - 1]);
  return most;
}

function largestSquare(force: Float32Array): number {
  let largest = 0;
  for (let k = 0; k < force.length; k += 3) {
    largest = Math.max(largest, force[k] ** 2 + force[k + 1] ** 2 + force[k + 2] ** 2);
  }
  return largest;
}
