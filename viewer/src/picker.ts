// Which body is seen at a point of the window.

import { InstancedMesh, Raycaster, Vector2, Vector3, type Intersection, type Object3D, type PerspectiveCamera } from "three";
import type { Ground } from "./ground";
import type { Markers } from "./markers";
import type { Placed } from "./recording";
import type { Batch } from "./batch";

/** A dot is hit when the pointer is so near [pixels of the page]. */
const NEAR_A_DOT = 8;

export class Picker {
  private readonly ray = new Raycaster();
  private readonly at = new Vector2();
  private readonly place = new Vector3();

  constructor(
    private readonly canvas: HTMLCanvasElement,
    private readonly camera: PerspectiveCamera,
    private readonly placed: readonly Placed[],
    private readonly batches: readonly Batch[],
    private readonly ground: Ground,
    private readonly markers: Markers,
  ) {}

  /** x, y: clientX and clientY. Bodies first, then their dots, then the floor. */
  pick(x: number, y: number): number | null {
    const box = this.canvas.getBoundingClientRect();
    this.at.set((2 * (x - box.left)) / box.width - 1, 1 - (2 * (y - box.top)) / box.height);
    this.ray.setFromCamera(this.at, this.camera);
    let nearest = Infinity, found: number | null = null;
    for (const batch of this.batches) {
      const hit = this.nearest([batch.instances]);
      if (hit && hit.distance < nearest) [nearest, found] = [hit.distance, this.placed[batch.numbers[hit.instanceId ?? 0]].body];
    }
    const ground = this.nearest(this.ground.surfaces);
    if (found !== null && !(ground && ground.distance < nearest)) return found;
    return this.dotAt(x - box.left, y - box.top, box) ?? (ground ? (ground.object.userData["body"] as number) : null);
  }

  private nearest(objects: Object3D[]): Intersection | undefined {
    for (const object of objects) if (object instanceof InstancedMesh) object.computeBoundingSphere();
    return this.ray.intersectObjects(objects, false)[0];
  }

  private dotAt(x: number, y: number, box: DOMRect): number | null {
    const places = this.markers.points.geometry.getAttribute("position");
    let best = NEAR_A_DOT, found: number | null = null;
    this.markers.bodies.forEach((body, k) => {
      this.place.fromBufferAttribute(places, k).project(this.camera);
      const dx = ((this.place.x + 1) / 2) * box.width - x, dy = ((1 - this.place.y) / 2) * box.height - y;
      const away = Math.hypot(dx, dy);
      if (away < best && Math.abs(this.place.z) < 1) [best, found] = [away, body.index];
    });
    return found;
  }
}
