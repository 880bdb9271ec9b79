// Dots for bodies that are too small to be seen: planets on their orbits, grains in a hall. A dot has the same size on
// the screen however near one comes, so nothing is drawn larger than it is.

import { BufferAttribute, BufferGeometry, Color, DynamicDrawUsage, Points, PointsMaterial } from "three";
import type { Moment } from "./player";
import type { Body } from "./recording";
import type { Frame } from "./batch";

/** Bodies of a smaller radius, in radii of the scene, get a dot; this many pixels wide. */
const TOO_SMALL = 0.004;
const PIXELS = 6;

export class Markers {
  readonly points: Points<BufferGeometry, PointsMaterial>;
  readonly bodies: readonly Body[];

  constructor(bodies: readonly Body[], radii: Float64Array, private readonly frame: Frame, sceneRadius: number) {
    const limit = TOO_SMALL * sceneRadius * frame.unit;
    this.bodies = bodies.filter((body) => radii[body.index] > 0 && radii[body.index] < limit);
    const geometry = new BufferGeometry();
    const places = new BufferAttribute(new Float32Array(3 * this.bodies.length), 3);
    places.setUsage(DynamicDrawUsage);
    geometry.setAttribute("position", places);
    const colours = this.bodies.flatMap((body) => new Color(body.colour).toArray());
    geometry.setAttribute("color", new BufferAttribute(Float32Array.from(colours), 3));
    this.points = new Points(geometry, new PointsMaterial({ size: PIXELS, sizeAttenuation: false, vertexColors: true }));
    this.points.frustumCulled = false;
    this.points.visible = this.bodies.length > 0;
  }

  move(moment: Moment): void {
    const places = this.points.geometry.getAttribute("position") as BufferAttribute;
    const out = places.array as Float32Array;
    for (let k = 0; k < this.bodies.length; k++) {
      const at = 3 * this.bodies[k].index;
      for (let axis = 0; axis < 3; axis++) {
        out[3 * k + axis] = (moment.positions[at + axis] - this.frame.origin[axis]) / this.frame.unit;
      }
    }
    places.needsUpdate = true;
  }
}
