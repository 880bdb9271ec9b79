// Looking along the axes.

import { Vector3 } from "three";
import type { World } from "../world";

export interface Viewpoint {
  readonly name: string;
  /** From what is looked at to the eye. */
  readonly direction: readonly [number, number, number];
}

export const VIEWPOINTS: readonly Viewpoint[] = [
  { name: "+x", direction: [1, 0, 0] },
  { name: "\u2212y", direction: [0, -1, 0] },
  { name: "above", direction: [0, 0, 1] },
  { name: "corner", direction: [0.5, -0.75, 0.43] },
];

/** Turns the camera about what it looks at; the distance stays. */
export function lookFrom(world: World, { direction }: Viewpoint): void {
  const { camera, controls } = world;
  const distance = camera.position.distanceTo(controls.target);
  camera.position.copy(controls.target).addScaledVector(new Vector3(...direction).normalize(), distance);
  controls.update();
  world.redraw();
}
