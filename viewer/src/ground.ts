// Half-spaces as large floors and walls, and the grid on the lowest of them.

import {
  BufferAttribute, BufferGeometry, Color, DoubleSide, Group, LineBasicMaterial, LineSegments, Mesh, MeshLambertMaterial, PlaneGeometry,
  Quaternion, Vector3, type Object3D,
} from "three";
import type { Frame } from "./batch";
import { Floor } from "./floor";
import type { Moment } from "./player";
import type { Placed, Recording } from "./recording";
import { product, turned } from "./rotation";
import { round125 } from "./round125";

/** Half the side of a wall, in radii of the scene. */
const WALL = 1.3;
/** A half-space whose normal points up so much is a floor. */
const UPRIGHT = 0.8;
/** Cells of the grid across the scene, about; it reaches so many radii. */
const CELLS = 12;
const REACH = 4;
/** How opaque its lines are in the middle. */
const STRENGTH = 0.75;

/** A half-space in view units. */
interface Plane {
  readonly point: Vector3;
  readonly turn: Quaternion;
  readonly normal: Vector3;
}

export interface GroundColours {
  readonly floor: string;
  readonly wall: string;
  readonly lines: string;
}

export class Ground {
  readonly group = new Group();
  /** Side of a cell of the grid [m]. */
  readonly cell: number;
  /** Floors and walls, to be picked: `userData.body` says whose they are. */
  readonly surfaces: Object3D[] = [];
  private readonly floors: Floor[] = [];
  private readonly wall = new MeshLambertMaterial({ side: DoubleSide, transparent: true, opacity: 0.18, depthWrite: false });
  private readonly lines = new LineBasicMaterial({ vertexColors: true, transparent: true, depthWrite: false });
  private readonly grid: LineSegments;

  /** radius: of the scene, in view units; bottom: its lowest place, where there is no floor. */
  constructor(recording: Recording, moment: Moment, frame: Frame, radius: number, bottom: number) {
    const halfspaces = recording.placed.filter((placed) => placed.kind === "halfspace");
    let lowest: Plane | null = null;
    for (const placed of halfspaces) {
      const plane = planeOf(placed, moment, frame);
      if (!Number.isFinite(plane.point.length())) continue;
      this.add(placed, plane, radius);
      if (isFloor(plane) && (!lowest || plane.point.z < lowest.point.z)) lowest = plane;
    }
    this.cell = round125((2 * radius * frame.unit) / CELLS);
    this.grid = gridOf(this.cell / frame.unit, radius, this.lines);
    const at = lowest ?? { point: new Vector3(0, 0, bottom), turn: new Quaternion(), normal: new Vector3(0, 0, 1) };
    this.grid.quaternion.copy(at.turn);
    this.grid.position.copy(snapped(at, frame, this.cell / frame.unit)).addScaledVector(at.normal, 0.0008 * radius);
    this.grid.renderOrder = 1;
    this.group.add(this.grid);
  }

  setColours(colours: GroundColours): void {
    for (const floor of this.floors) floor.setColour(colours.floor);
    this.wall.color = new Color(colours.wall);
    this.lines.color = new Color(colours.lines);
  }

  setGrid(shown: boolean): void {
    this.grid.visible = shown;
  }

  setShadows(shown: boolean): void {
    for (const floor of this.floors) floor.setShadows(shown);
  }

  private add(placed: Placed, plane: Plane, radius: number): void {
    const part = isFloor(plane) ? this.newFloor(plane, radius) : this.newWall(radius);
    part.position.copy(plane.point);
    part.quaternion.copy(plane.turn);
    this.group.add(part);
    this.surfaces[this.surfaces.length - 1].userData["body"] = placed.body;
  }

  private newFloor(plane: Plane, radius: number): Object3D {
    const floor = new Floor(radius, plane.normal);
    this.floors.push(floor);
    this.surfaces.push(floor.surface);
    return floor.group;
  }

  private newWall(radius: number): Object3D {
    const wall = new Mesh(new PlaneGeometry(2 * WALL * radius, 2 * WALL * radius), this.wall);
    this.surfaces.push(wall);
    return wall;
  }
}

function isFloor(plane: Plane): boolean {
  return plane.normal.z > UPRIGHT;
}

/** Its point nearest to the middle of the scene, which is the origin of the view. */
function planeOf(placed: Placed, moment: Moment, frame: Frame): Plane {
  const q = new Float64Array(4), p = new Float64Array(3);
  product(moment.orientations, 4 * placed.body, Float64Array.from(placed.orientation), 0, q, 0);
  const [x, y, z] = placed.position;
  turned(moment.orientations, 4 * placed.body, x, y, z, p, 0);
  for (let k = 0; k < 3; k++) p[k] = (p[k] + moment.positions[3 * placed.body + k] - frame.origin[k]) / frame.unit;
  const turn = new Quaternion(q[1], q[2], q[3], q[0]);
  const normal = new Vector3(0, 0, 1).applyQuaternion(turn);
  const distance = normal.dot(new Vector3(p[0], p[1], p[2]));
  return { point: normal.clone().multiplyScalar(distance), turn, normal };
}

/** Moved within its plane so that its lines are at whole cells, of this side in view units, from the world's origin. */
function snapped(plane: Plane, frame: Frame, side: number): Vector3 {
  const back = plane.turn.clone().invert();
  const toOrigin = new Vector3(...frame.origin).multiplyScalar(-1 / frame.unit).sub(plane.point).applyQuaternion(back);
  const shift = new Vector3(toOrigin.x - side * Math.round(toOrigin.x / side), toOrigin.y - side * Math.round(toOrigin.y / side), 0);
  return shift.applyQuaternion(plane.turn).add(plane.point);
}

/** Lines that fade out with the distance from the middle. */
function gridOf(side: number, radius: number, material: LineBasicMaterial): LineSegments {
  const lines = Math.ceil((REACH * radius) / side);
  const points: number[] = [], colours: number[] = [];
  const put = (x: number, y: number): void => {
    points.push(x * side, y * side, 0);
    const away = Math.hypot(x, y) / lines;
    colours.push(1, 1, 1, STRENGTH * Math.max(0, 1 - away) ** 1.5);
  };
  for (let k = -lines; k <= lines; k++) {
    for (let m = -lines; m < lines; m += 2) {
      put(k, m);
      put(k, m + 2);
      put(m, k);
      put(m + 2, k);
    }
  }
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(Float32Array.from(points), 3));
  geometry.setAttribute("color", new BufferAttribute(Float32Array.from(colours), 4));
  return new LineSegments(geometry, material);
}
