// The camera of a run that is watched: nobody knows at its start where bodies will go.

import { Vector3 } from "three";
import type { App } from "../app";
import { paced } from "../ui/pace";

/** As many of the bodies that move may be out of sight. */
const OUTLIERS = 0.05;
/** Milliseconds between two looks. */
const PAUSE = 1000;
const TOUCHES = ["pointerdown", "wheel", "keydown"] as const;

/** Moves the camera back when bodies leave the view, until somebody touches the page. */
export function keepInSight({ recording, player, world, root }: App): void {
  const moving = recording.bodies.filter((body) => !body.fixed).map((body) => body.index);
  const place = new Vector3();
  const isOutside = (body: number): boolean => {
    const { positions } = player.moment;
    world.toView(positions[3 * body], positions[3 * body + 1], positions[3 * body + 2], place).project(world.camera);
    return !(Math.max(Math.abs(place.x), Math.abs(place.y), Math.abs(place.z)) <= 1);
  };
  const stop = recording.onGrowth(paced(() => {
    if (player.following && moving.filter(isOutside).length > OUTLIERS * moving.length) world.frameAll();
  }, PAUSE));
  for (const touch of TOUCHES) root.ownerDocument.addEventListener(touch, stop, { once: true, capture: true, passive: true });
}
