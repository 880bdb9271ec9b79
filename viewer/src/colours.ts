// The colours of materials: how bodies are painted at first.

import { Color } from "three";
import type { Placed } from "./recording";
import type { Painter } from "./world";

/** Paints every solid in the colour of its material. */
export function byMaterial(placed: readonly Placed[]): Painter {
  const colours = placed.map((one) => new Color(one.colour));
  return (_body, number, _moment, paint) => void paint.colour.copy(colours[number]);
}
