// Meshes and numbers in the forms that the graphics card takes.

import { BufferAttribute, BufferGeometry, DataTexture, FloatType, RGBAFormat } from "three";
import type { MeshData } from "./recording";

/** Solids in one row of a texture of numbers. */
export const SOLIDS_IN_A_ROW = 256;

/** Numbers that shaders look up by the number of a solid: so many texels (of four numbers) for each. */
export class Texels {
  readonly numbers: Float32Array;
  readonly texture: DataTexture;

  constructor(each: number, solids: number) {
    const rows = Math.max(1, Math.ceil(solids / SOLIDS_IN_A_ROW));
    this.numbers = new Float32Array(4 * each * SOLIDS_IN_A_ROW * rows);
    this.texture = new DataTexture(this.numbers, each * SOLIDS_IN_A_ROW, rows, RGBAFormat, FloatType);
  }
}

export function geometryOf(mesh: MeshData): BufferGeometry {
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(mesh.vertices, 3));
  geometry.setAttribute("normal", new BufferAttribute(mesh.normals, 3));
  const few = mesh.vertices.length / 3 < 65536;
  geometry.setIndex(new BufferAttribute(few ? Uint16Array.from(mesh.triangles) : mesh.triangles, 1));
  return geometry;
}

const SQUARE: MeshData = {
  vertices: new Float32Array([-1, -1, 0, 1, -1, 0, 1, 1, 0, -1, 1, 0]),
  normals: new Float32Array([0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1]),
  triangles: new Uint32Array([0, 1, 2, 0, 2, 3]),
  coarse: null,
};

/** The mesh (a square for null) so many times behind each other; `solid` says for each vertex whose it is. */
export function merged(mesh: MeshData | null, solids: number): BufferGeometry {
  const { vertices, normals, triangles } = mesh ?? SQUARE;
  const count = vertices.length / 3;
  const geometry = new BufferGeometry();
  geometry.setAttribute("position", new BufferAttribute(repeated(vertices, solids), 3));
  geometry.setAttribute("normal", new BufferAttribute(repeated(normals, solids), 3));
  geometry.setAttribute("solid", new BufferAttribute(Float32Array.from({ length: count * solids }, (_, k) => Math.floor(k / count)), 1));
  const index = new Uint32Array(triangles.length * solids);
  for (let k = 0; k < index.length; k++) index[k] = triangles[k % triangles.length] + count * Math.floor(k / triangles.length);
  geometry.setIndex(new BufferAttribute(index, 1));
  return geometry;
}

function repeated(numbers: Float32Array, times: number): Float32Array {
  const all = new Float32Array(numbers.length * times);
  for (let k = 0; k < times; k++) all.set(numbers, k * numbers.length);
  return all;
}
