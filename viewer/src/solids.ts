// Bodies as instanced meshes: one draw call for all solids that share a mesh.

import {
  BufferAttribute, BufferGeometry, Color, DynamicDrawUsage, InstancedBufferAttribute, InstancedMesh, type Material,
} from "three";
import type { Moment } from "./player";
import type { MeshData, Placed } from "./recording";
import { product, turned } from "./rotation";
import type { Paint, Painter } from "./world";

/** View units: (metres - origin) / unit. */
export interface Frame {
  readonly unit: number;
  readonly origin: readonly [number, number, number];
}

/** The meshes of a recording for the graphics card. */
export function geometriesOf(meshes: readonly MeshData[]): BufferGeometry[] {
  return meshes.map((mesh) => {
    const geometry = new BufferGeometry();
    geometry.setAttribute("position", new BufferAttribute(mesh.vertices, 3));
    geometry.setAttribute("normal", new BufferAttribute(mesh.normals, 3));
    const few = mesh.vertices.length / 3 < 65536;
    geometry.setIndex(new BufferAttribute(few ? Uint16Array.from(mesh.triangles) : mesh.triangles, 1));
    return geometry;
  });
}

/** All solids of one mesh. */
export class Batch {
  readonly mesh: InstancedMesh;
  private readonly patterns: InstancedBufferAttribute;
  private readonly place = new Float64Array(3);
  private readonly turn = new Float64Array(4);
  private readonly own: Float64Array;

  /** numbers: which of `placed` they are. */
  constructor(
    geometry: BufferGeometry,
    material: Material,
    private readonly placed: readonly Placed[],
    readonly numbers: readonly number[],
    private readonly frame: Frame,
  ) {
    const shared = geometry.clone();
    this.patterns = new InstancedBufferAttribute(new Float32Array(numbers.length), 1);
    shared.setAttribute("pattern", this.patterns);
    this.mesh = new InstancedMesh(shared, material, numbers.length);
    this.mesh.instanceMatrix.setUsage(DynamicDrawUsage);
    this.mesh.frustumCulled = false;
    this.mesh.matrixAutoUpdate = false;
    this.mesh.instanceColor = new InstancedBufferAttribute(new Float32Array(3 * numbers.length), 3);
    this.own = Float64Array.from(numbers.flatMap((number) => placed[number].orientation));
  }

  /** Puts all solids where their bodies are. */
  move(moment: Moment): void {
    const out = this.mesh.instanceMatrix.array as Float32Array;
    for (let k = 0; k < this.numbers.length; k++) {
      const placed = this.placed[this.numbers[k]];
      const { place, turn } = this;
      turned(moment.orientations, 4 * placed.body, placed.position[0], placed.position[1], placed.position[2], place, 0);
      for (let axis = 0; axis < 3; axis++) {
        place[axis] = (moment.positions[3 * placed.body + axis] + place[axis] - this.frame.origin[axis]) / this.frame.unit;
      }
      product(moment.orientations, 4 * placed.body, this.own, 4 * k, turn, 0);
      writeMatrix(out, 16 * k, place, turn, placed.scale, this.frame.unit);
    }
    this.mesh.instanceMatrix.needsUpdate = true;
  }

  paint(painter: Painter, moment: Moment, paint: Paint): void {
    const colours = this.mesh.instanceColor as InstancedBufferAttribute;
    const out = colours.array as Float32Array, patterns = this.patterns.array as Float32Array;
    for (let k = 0; k < this.numbers.length; k++) {
      const number = this.numbers[k];
      paint.pattern = 0;
      painter(this.placed[number].body, number, moment, paint);
      paint.colour.toArray(out, 3 * k);
      patterns[k] = paint.pattern;
    }
    colours.needsUpdate = true;
    this.patterns.needsUpdate = true;
  }
}

/** One batch for each mesh that is used by the chosen solids. */
export function batchesOf(
  geometries: readonly BufferGeometry[], material: Material, placed: readonly Placed[], frame: Frame,
  chosen: (placed: Placed) => boolean,
): Batch[] {
  const numbers = geometries.map((): number[] => []);
  placed.forEach((one, number) => {
    if (one.kind !== "halfspace" && chosen(one)) numbers[one.mesh].push(number);
  });
  return geometries.flatMap((geometry, mesh) =>
    numbers[mesh].length ? [new Batch(geometry, material, placed, numbers[mesh], frame)] : [],
  );
}

/** Paints every solid in the colour of its material. */
export function byMaterial(placed: readonly Placed[]): Painter {
  const colours = placed.map((one) => new Color(one.colour));
  return (_body, number, _moment, paint) => void paint.colour.copy(colours[number]);
}

/** Column by column: turned, scaled, moved. Nothing is drawn of a solid whose numbers are not finite. */
function writeMatrix(
  out: Float32Array, at: number, place: Float64Array, q: Float64Array, scale: readonly number[], unit: number,
): void {
  const w = q[0], x = q[1], y = q[2], z = q[3];
  if (!Number.isFinite(place[0] + place[1] + place[2] + w + x + y + z)) {
    out.fill(0, at, at + 16);
    return;
  }
  const a = scale[0] / unit, b = scale[1] / unit, c = scale[2] / unit;
  out[at] = (1 - 2 * (y * y + z * z)) * a;
  out[at + 1] = 2 * (x * y + w * z) * a;
  out[at + 2] = 2 * (x * z - w * y) * a;
  out[at + 3] = 0;
  out[at + 4] = 2 * (x * y - w * z) * b;
  out[at + 5] = (1 - 2 * (x * x + z * z)) * b;
  out[at + 6] = 2 * (y * z + w * x) * b;
  out[at + 7] = 0;
  out[at + 8] = 2 * (x * z + w * y) * c;
  out[at + 9] = 2 * (y * z - w * x) * c;
  out[at + 10] = (1 - 2 * (x * x + y * y)) * c;
  out[at + 11] = 0;
  for (let k = 0; k < 3; k++) out[at + 12 + k] = place[k];
  out[at + 15] = 1;
}
