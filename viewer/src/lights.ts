// Sky and sun.

import { DirectionalLight, Group, HemisphereLight } from "three";

const SUN_FROM = [-0.45, -0.6, 1] as const;
const SUN_AWAY = Math.hypot(...SUN_FROM);
/** Unit vector towards the sun. */
export const SUN_DIRECTION = [SUN_FROM[0] / SUN_AWAY, SUN_FROM[1] / SUN_AWAY, SUN_FROM[2] / SUN_AWAY] as const;
export const SUN_LIGHT = 2.1;
export const SKY_LIGHT = 1.35;
/** What comes back from below. */
export const GROUND_LIGHT = 0x8a8f98;
/** The sun stands so many radii of the scene away. */
const DISTANCE = 4;

/** Light from above and from a sun behind the viewer's left shoulder, with the shadows of a scene of this radius. */
export class Lights {
  readonly group = new Group();
  private readonly sun = new DirectionalLight(0xffffff, SUN_LIGHT);
  private readonly sky = new HemisphereLight(0xffffff, GROUND_LIGHT, SKY_LIGHT);

  constructor(radius: number) {
    this.sun.position.set(...SUN_DIRECTION).multiplyScalar(DISTANCE * radius);
    this.sky.position.set(0, 0, 1);
    const camera = this.sun.shadow.camera;
    camera.left = camera.bottom = -1.5 * radius;
    camera.right = camera.top = 1.5 * radius;
    camera.near = 0.5 * radius;
    camera.far = 2 * DISTANCE * radius;
    this.sun.shadow.normalBias = 0.004 * radius;
    this.sun.shadow.bias = -0.0005;
    this.group.add(this.sun, this.sun.target, this.sky);
  }

  /** side: of the shadow map, 0 for no shadows. */
  setShadows(side: number): void {
    this.sun.castShadow = side > 0;
    if (side > 0 && this.sun.shadow.mapSize.x !== side) {
      this.sun.shadow.mapSize.set(side, side);
      this.sun.shadow.map?.dispose();
      this.sun.shadow.map = null;
    }
  }
}
