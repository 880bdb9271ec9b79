// A click or tap in the view selects the body under it; a drag turns the view and selects nothing.

import type { World } from "../world";

/** A finger or hand may move this far and still click [CSS pixels]. */
const STILL = 6;

export function listenToPicks(world: World, picked: (body: number | null) => void): void {
  const { canvas } = world;
  let down: { x: number; y: number; id: number } | null = null;
  let fingers = 0;
  canvas.addEventListener("pointerdown", (event) => {
    fingers += 1;
    down = fingers === 1 && event.button === 0 ? { x: event.clientX, y: event.clientY, id: event.pointerId } : null;
  });
  const release = (event: PointerEvent): void => {
    fingers = Math.max(0, fingers - 1);
    const start = down;
    if (!start || start.id !== event.pointerId) return;
    down = null;
    if (event.type !== "pointerup" || Math.hypot(event.clientX - start.x, event.clientY - start.y) > STILL) return;
    picked(world.pick(event.clientX, event.clientY));
  };
  canvas.addEventListener("pointerup", release);
  canvas.addEventListener("pointercancel", release);
}
