// All solids that share a mesh, in one of two ways: instanced, with all triangles, light on every pixel and shadows; or
// merged into one list of few triangles. Software renderers work through instances one by one, at a fixed price each;
// merged, a thousand solids take them a fifth of the time.

import { DynamicDrawUsage, InstancedBufferAttribute, InstancedMesh, Mesh, type BufferGeometry, type Material } from "three";
import { geometryOf, merged, Texels } from "./geometry";
import type { Moment } from "./player";
import type { MeshData, Placed } from "./recording";
import { product, turned } from "./rotation";
import type { Paint, Painter } from "./world";

/** View units: (metres - origin) / unit. */
export interface Frame {
  readonly unit: number;
  readonly origin: readonly [number, number, number];
}

/** What batches are drawn with. */
export interface Surfaces {
  /** Of the instances. */
  readonly smooth: Material;
  /** Of the merged ones, which are found in these textures; `discs`: as discs that stand for spheres. */
  simple(matrices: Texels, tints: Texels, discs: boolean): Material;
}

export class Batch {
  /** With all its triangles. */
  readonly geometry: BufferGeometry;
  readonly instances: InstancedMesh;
  private simple: Mesh | null = null;
  /** Four texels for each solid: the columns of its matrix; and one: colour and pattern. */
  private readonly matrices: Texels;
  private readonly tints: Texels;
  private readonly tintAttribute: InstancedBufferAttribute;
  private readonly place = new Float64Array(3);
  private readonly turn = new Float64Array(4);
  private readonly own: Float64Array;

  /** numbers: which of `placed` they are. */
  constructor(
    private readonly data: MeshData,
    private readonly surfaces: Surfaces,
    private readonly placed: readonly Placed[],
    readonly numbers: readonly number[],
    private readonly frame: Frame,
  ) {
    this.matrices = new Texels(4, numbers.length);
    this.tints = new Texels(1, numbers.length);
    this.geometry = geometryOf(data);
    this.tintAttribute = new InstancedBufferAttribute(this.tints.numbers, 4);
    this.geometry.setAttribute("tint", this.tintAttribute);
    this.instances = new InstancedMesh(this.geometry, surfaces.smooth, numbers.length);
    this.instances.instanceMatrix = new InstancedBufferAttribute(this.matrices.numbers, 16);
    this.instances.instanceMatrix.setUsage(DynamicDrawUsage);
    this.instances.frustumCulled = false;
    this.instances.matrixAutoUpdate = false;
    this.own = Float64Array.from(numbers.flatMap((number) => placed[number].orientation));
  }

  /** How it is drawn from now on: as well as can be, or as fast. */
  setDetail(fine: boolean): void {
    if (!fine && !this.simple) this.simple = this.merge();
    this.instances.visible = fine;
    if (this.simple) this.simple.visible = !fine;
  }

  /** Puts all solids where their bodies are. */
  move(moment: Moment): void {
    const out = this.matrices.numbers;
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
    if (this.instances.visible) this.instances.instanceMatrix.needsUpdate = true;
    else this.matrices.texture.needsUpdate = true;
  }

  paint(painter: Painter, moment: Moment, paint: Paint): void {
    const out = this.tints.numbers;
    for (let k = 0; k < this.numbers.length; k++) {
      const number = this.numbers[k];
      paint.pattern = 0;
      painter(this.placed[number].body, number, moment, paint);
      paint.colour.toArray(out, 4 * k);
      out[4 * k + 3] = paint.pattern;
    }
    this.tintAttribute.needsUpdate = true;
    this.tints.texture.needsUpdate = true;
  }

  private merge(): Mesh {
    const discs = this.numbers.every((number) => this.placed[number].kind === "sphere");
    const geometry = merged(discs ? null : (this.data.coarse ?? this.data), this.numbers.length);
    const mesh = new Mesh(geometry, this.surfaces.simple(this.matrices, this.tints, discs));
    mesh.frustumCulled = false;
    mesh.matrixAutoUpdate = false;
    this.matrices.texture.needsUpdate = true;
    this.instances.parent?.add(mesh);
    return mesh;
  }
}

/** One batch for each mesh that is used by the chosen solids, spheres by themselves. */
export function batchesOf(
  meshes: readonly MeshData[], surfaces: Surfaces, placed: readonly Placed[], frame: Frame, chosen: (placed: Placed) => boolean,
): Batch[] {
  const groups = new Map<string, number[]>();
  placed.forEach((one, number) => {
    if (one.kind === "halfspace" || !chosen(one)) return;
    const key = `${one.mesh} ${one.kind === "sphere"}`;
    const group = groups.get(key);
    if (group) group.push(number);
    else groups.set(key, [number]);
  });
  return [...groups.values()].map((numbers) => new Batch(meshes[placed[numbers[0]].mesh], surfaces, placed, numbers, frame));
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
