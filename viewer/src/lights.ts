// Sky and sun.

import { DirectionalLight, Group, HemisphereLight } from "three";

const SUN_FROM = [-0.45, -0.6, 1] as const;
/** The sun stands so many radii of the scene away. */
const DISTANCE = 4;

/** Light from above and from a sun behind the viewer's left shoulder, with the shadows of a scene of this radius. */
export class Lights {
  readonly group = new Group();
  private readonly sun = new DirectionalLight(0xffffff, 2.1);
  private readonly sky = new HemisphereLight(0xffffff, 0x8a8f98, 1.35);

  constructor(radius: number) {
    const length = Math.hypot(...SUN_FROM);
    this.sun.position.set(...SUN_FROM).multiplyScalar((DISTANCE * radius) / length);
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
