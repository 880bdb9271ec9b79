// Sky and sun.

import { Color, DirectionalLight, Group, HemisphereLight, type Vector3 } from "three";

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

/** The light that a surface with this normal sends out of white light, as `out`: three.js's matt surface under `Lights`. */
export function lightOn(normal: Vector3, out: Color): Color {
  const up = 0.5 * normal.z + 0.5;
  const sun = SUN_LIGHT * Math.max(0, normal.x * SUN_DIRECTION[0] + normal.y * SUN_DIRECTION[1] + normal.z * SUN_DIRECTION[2]);
  out.set(GROUND_LIGHT).lerp(new Color(0xffffff), up).multiplyScalar(SKY_LIGHT);
  return out.addScalar(sun).multiplyScalar(1 / Math.PI);
}

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
