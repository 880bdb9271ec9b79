// How large the scene is and where: what the camera looks at, and what a view unit is.

import type { Placed, Recording } from "./recording";
import { turned } from "./rotation";

/** A box [m]; empty when `low` is above `high`. */
export interface Box {
  readonly low: [number, number, number];
  readonly high: [number, number, number];
}

/** So many frames are looked at. */
const SAMPLES = 100;
/** Of all sampled places, along each axis, so many at either end are left out: one ball that rolls away must not make
 *  the rest small. */
const OUTLIERS = 0.04;
/** Bodies that never move are part of the view when they are not larger than so many times what moves. */
const LARGEST_SCENERY = 4;

/** Half the diagonal of a body about its origin [m], without half-spaces; 0 for a body without shape. */
export function bodyRadii(recording: Pick<Recording, "bodies" | "placed" | "meshes">): Float64Array {
  const reach = recording.meshes.map((mesh) => reachOf(mesh.vertices));
  const radii = new Float64Array(recording.bodies.length);
  for (const placed of recording.placed) {
    if (placed.kind === "halfspace") continue;
    radii[placed.body] = Math.max(radii[placed.body], Math.hypot(...placed.position) + solidRadius(placed, reach[placed.mesh]));
  }
  return radii;
}

/** The box in which the scene happens, whatever is far away; of the frames that there are now. */
export function sceneBox(recording: Recording, radii: Float64Array): Box {
  const moving = recording.bodies.filter((body) => !body.fixed).map((body) => body.index);
  const box = emptyBox();
  if (!recording.frames) return around(box);
  const place = new Float64Array(3);
  const step = Math.max(1, Math.floor(recording.frames / SAMPLES));
  for (let axis = 0; axis < 3 && moving.length; axis++) {
    const found: number[] = [];
    for (let frame = 0; frame < recording.frames; frame += step) {
      for (const body of moving) {
        const value = recording.position.at(frame, body, axis);
        if (Number.isFinite(value)) found.push(value);
      }
    }
    trim(found, axis, box);
  }
  for (const body of moving) {
    recording.position.read(0, body, place, 0);
    include(box, place, 0);
  }
  grow(box, median(moving.map((body) => radii[body])));
  includeScenery(recording, radii, box);
  includeAnchors(recording, box);
  return around(box);
}

export function diagonal(box: Box): number {
  return Math.hypot(box.high[0] - box.low[0], box.high[1] - box.low[1], box.high[2] - box.low[2]);
}

/** A typical radius of the bodies that move, of all when none does [m]; 0 when there is none. */
export function typicalRadius(recording: Recording, radii: Float64Array): number {
  const moving = recording.bodies.filter((body) => !body.fixed).map((body) => radii[body.index]);
  return median(moving.length ? moving : Array.from(radii));
}

function emptyBox(): Box {
  return { low: [Infinity, Infinity, Infinity], high: [-Infinity, -Infinity, -Infinity] };
}

function trim(found: number[], axis: number, box: Box): void {
  if (!found.length) return;
  const sorted = Float64Array.from(found).sort();
  const out = Math.floor(sorted.length * OUTLIERS);
  box.low[axis] = sorted[out];
  box.high[axis] = sorted[sorted.length - 1 - out];
}

function include(box: Box, place: Float64Array, margin: number): void {
  for (let axis = 0; axis < 3; axis++) {
    if (!Number.isFinite(place[axis])) continue;
    box.low[axis] = Math.min(box.low[axis], place[axis] - margin);
    box.high[axis] = Math.max(box.high[axis], place[axis] + margin);
  }
}

function grow(box: Box, margin: number): void {
  for (let axis = 0; axis < 3; axis++) {
    box.low[axis] -= margin;
    box.high[axis] += margin;
  }
}

function includeScenery(recording: Recording, radii: Float64Array, box: Box): void {
  const place = new Float64Array(3);
  const limit = box.low[0] <= box.high[0] ? LARGEST_SCENERY * diagonal(box) : Infinity;
  for (const body of recording.bodies) {
    if (!body.fixed || !(radii[body.index] > 0) || 2 * radii[body.index] > limit) continue;
    recording.position.read(0, body.index, place, 0);
    if (distanceTo(box, place) <= limit) includeCorners(recording, body.index, box);
  }
}

/** The corners of the boxes around a body's solids, as it stands at the start. */
function includeCorners(recording: Recording, body: number, box: Box): void {
  const q = new Float64Array(4), p = new Float64Array(3), corner = new Float64Array(3), own = new Float64Array(4);
  recording.position.read(0, body, p, 0);
  recording.orientation.read(0, body, q, 0);
  for (const placed of recording.placed) {
    if (placed.body !== body || placed.kind === "halfspace") continue;
    const reach = reachOf(recording.meshes[placed.mesh].vertices);
    own.set(placed.orientation);
    for (let k = 0; k < 8; k++) {
      const [x, y, z] = placed.scale.map((scale, axis) => scale * reach[axis] * (k & (1 << axis) ? 1 : -1));
      turned(own, 0, x, y, z, corner, 0);
      for (let axis = 0; axis < 3; axis++) corner[axis] += placed.position[axis];
      turned(q, 0, corner[0], corner[1], corner[2], corner, 0);
      for (let axis = 0; axis < 3; axis++) corner[axis] += p[axis];
      include(box, corner, 0);
    }
  }
}

function distanceTo(box: Box, place: Float64Array): number {
  if (box.low[0] > box.high[0]) return 0;
  let square = 0;
  for (let axis = 0; axis < 3; axis++) square += Math.max(0, box.low[axis] - place[axis], place[axis] - box.high[axis]) ** 2;
  return Math.sqrt(square);
}

/** Where joints and springs are tied to the world or to bodies at the start: a pendulum hangs from something. */
function includeAnchors(recording: Recording, box: Box): void {
  const place = new Float64Array(3), q = new Float64Array(4);
  for (const link of [...recording.joints, ...recording.springs]) {
    for (let end = 0; end < 2; end++) {
      const [x, y, z] = link.anchors[end];
      place.set([x, y, z]);
      if (link.bodies[end] >= 0) {
        recording.orientation.read(0, link.bodies[end], q, 0);
        turned(q, 0, x, y, z, place, 0);
        for (let axis = 0; axis < 3; axis++) place[axis] += recording.position.at(0, link.bodies[end], axis);
      }
      include(box, place, 0);
    }
  }
}

/** Never empty, never flat to a point. */
function around(box: Box): Box {
  if (!box.low.concat(box.high).every(Number.isFinite)) return { low: [-1, -1, -1], high: [1, 1, 1] };
  if (diagonal(box) === 0) grow(box, Math.max(1e-9, Math.abs(box.low[0]) * 1e-3));
  return box;
}

function median(some: number[]): number {
  const sorted = some.filter((value) => value > 0).sort((a, b) => a - b);
  return sorted.length ? sorted[sorted.length >> 1] : 0;
}

/** The farthest vertex from the origin along each axis, and at all. */
function reachOf(vertices: Float32Array): number[] {
  const reach = [0, 0, 0];
  for (let k = 0; k < vertices.length; k++) reach[k % 3] = Math.max(reach[k % 3], Math.abs(vertices[k]));
  return reach;
}

function solidRadius(placed: Placed, reach: readonly number[]): number {
  const sides = placed.scale.map((scale, axis) => scale * reach[axis]);
  return placed.kind === "sphere" ? sides[0] : Math.hypot(...sides);
}
