// The camera: where it stands at first, how it follows a body, what is near and far.

import { PerspectiveCamera, Vector3 } from "three";
import { OrbitControls } from "three/addons/controls/OrbitControls.js";

const FIELD_OF_VIEW = 38;
/** Seen from the front, a little from the right and from above. */
const FROM = new Vector3(0.5, -1, 0.42).normalize();
const MARGIN = 1.15;

export class Rig {
  readonly camera = new PerspectiveCamera(FIELD_OF_VIEW, 1, 0.01, 1000);
  readonly controls: OrbitControls;
  private readonly last = new Vector3();
  private readonly step = new Vector3();
  /** Where `show` has put the camera. */
  private readonly shownFrom = new Vector3();
  private following = false;

  constructor(canvas: HTMLCanvasElement, private readonly sceneRadius: number) {
    this.camera.up.set(0, 0, 1);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.enableDamping = true;
    this.controls.dampingFactor = 0.12;
    this.controls.zoomToCursor = true;
    this.controls.maxDistance = 40 * sceneRadius;
  }

  resize(width: number, height: number): void {
    this.camera.aspect = width / Math.max(1, height);
    this.camera.updateProjectionMatrix();
  }

  /** Whether nobody has moved the camera since `show`. */
  get isUntouched(): boolean {
    return !this.following && this.camera.position.distanceTo(this.shownFrom) < 1e-6 * this.sceneRadius;
  }

  /** Looks at the middle of a box from so far away that all of it is in the picture. */
  show(low: Vector3, high: Vector3): void {
    const tall = Math.tan((FIELD_OF_VIEW * Math.PI) / 360), wide = tall * this.camera.aspect;
    const right = new Vector3().crossVectors(this.camera.up, FROM).normalize();
    const up = new Vector3().crossVectors(FROM, right);
    const middle = low.clone().add(high).multiplyScalar(0.5);
    let distance = 0;
    for (let corner = 0; corner < 8; corner++) {
      this.step.set(corner & 1 ? low.x : high.x, corner & 2 ? low.y : high.y, corner & 4 ? low.z : high.z).sub(middle);
      const needed = Math.max(Math.abs(this.step.dot(right)) / wide, Math.abs(this.step.dot(up)) / tall);
      distance = Math.max(distance, MARGIN * needed + this.step.dot(FROM));
    }
    this.controls.target.copy(middle);
    this.camera.position.copy(middle).addScaledVector(FROM, distance);
    this.controls.update();
    this.shownFrom.copy(this.camera.position);
  }

  /** Looks at a place from now on, from the side it is seen from; null: stays where it is. */
  follow(place: Vector3 | null): void {
    this.following = place !== null;
    if (!place) return;
    this.last.copy(place);
    this.step.copy(place).sub(this.controls.target);
    this.camera.position.add(this.step);
    this.controls.target.copy(place);
  }

  /** Goes along with the place that is followed. */
  along(place: Vector3): void {
    if (!this.following || !Number.isFinite(place.x + place.y + place.z)) return;
    this.step.copy(place).sub(this.last);
    this.last.copy(place);
    this.camera.position.add(this.step);
    this.controls.target.add(this.step);
  }

  /** Before each picture: near and far planes around what is looked at. True while the camera still glides. */
  update(): boolean {
    const glides = this.controls.update();
    const distance = this.camera.position.distanceTo(this.controls.target);
    const near = Math.max(distance * 0.01, 1e-4), far = distance * 2 + 60 * this.sceneRadius;
    if (near !== this.camera.near || far !== this.camera.far) {
      this.camera.near = near;
      this.camera.far = far;
      this.camera.updateProjectionMatrix();
    }
    // Else done while drawing only: what is laid over the picture would lag behind it.
    this.camera.updateMatrixWorld();
    return glides;
  }
}
