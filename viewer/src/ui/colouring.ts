// What colours mean: the material, the speed, or which body it is. Patterns say the same without colours.

import { SRGBColorSpace } from "three";
import type { Recording } from "../recording";
import type { Painter, World } from "../world";
import { apart, viridis } from "./palette";
import type { Store } from "./settings";

/** Patterns that tell things apart: plain, halves, stripes, checks, rings. */
export const PATTERNS = 5;

/** Number of each material, in the order of first use. */
export function materialNumbers(recording: Recording): Map<string, number> {
  const numbers = new Map<string, number>();
  for (const { material } of recording.placed) if (!numbers.has(material)) numbers.set(material, numbers.size);
  return numbers;
}

/** Paints the world as the settings say. */
export function keepColours(recording: Recording, world: World, store: Store): void {
  const painters = { material: byMaterial(recording), speed: bySpeed(recording), body: byBody() };
  store.watch(["colouring"], () => {
    const { colouring } = store.now;
    world.setColouring(painters[colouring], colouring === "speed");
    world.redraw();
  });
}

function byMaterial(recording: Recording): Painter {
  const numbers = materialNumbers(recording);
  const patterns = recording.placed.map((placed) => (numbers.get(placed.material) ?? 0) % PATTERNS);
  return (_body, placed, _moment, paint) => {
    paint.colour.set(recording.placed[placed].colour);
    paint.pattern = patterns[placed];
  };
}

function bySpeed(recording: Recording): Painter {
  const rgb: [number, number, number] = [0, 0, 0];
  return (body, _placed, { velocities }, paint) => {
    if (recording.bodies[body].fixed) paint.colour.set("#9aa0a8");
    else {
      const speed = Math.hypot(velocities[3 * body], velocities[3 * body + 1], velocities[3 * body + 2]);
      viridis(speed / (recording.topSpeed || 1), rgb);
      paint.colour.setRGB(rgb[0], rgb[1], rgb[2], SRGBColorSpace);
    }
    paint.pattern = 0;
  };
}

function byBody(): Painter {
  return (body, _placed, _moment, paint) => {
    const [r, g, b] = apart(body);
    paint.colour.setRGB(r, g, b, SRGBColorSpace);
    paint.pattern = body % PATTERNS;
  };
}
