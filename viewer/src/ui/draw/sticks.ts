// Many arrows or rods in one call of the graphics card: each is two points, a width and a colour.

import {
  BufferGeometry, type Color, ConeGeometry, CylinderGeometry, DynamicDrawUsage, Float32BufferAttribute, GreaterDepth,
  Group, InstancedBufferAttribute, InstancedBufferGeometry, Mesh, ShaderMaterial,
} from "three";
import { mergeGeometries } from "three/addons/utils/BufferGeometryUtils.js";

/** Lengths along the stick are 0 to 1; `part` 1 marks the head, whose length goes with the width. */
const VERTEX = `
  attribute float part;
  attribute vec3 from;
  attribute vec3 along;
  attribute vec3 tint;
  attribute float wide;
  varying vec3 vTint;
  varying vec3 vNormal;
  void main() {
    float size = length(along);
    vec3 d = size > 0.0 ? along / size : vec3(0.0, 0.0, 1.0);
    vec3 u = normalize(abs(d.z) < 0.9 ? cross(d, vec3(0.0, 0.0, 1.0)) : cross(d, vec3(1.0, 0.0, 0.0)));
    vec3 v = cross(d, u);
    float head = HEAD * min(3.4 * wide, 0.6 * size);
    float round = part > 0.5 ? min(wide, 0.25 * size) : min(0.4 * wide, 0.1 * size);
    if (HEAD < 0.5) round = wide;
    float height = part > 0.5 ? size - head + head * position.y : (size - head) * position.y;
    vec3 place = from + d * height + (u * position.x + v * position.z) * round;
    vNormal = normalMatrix * (u * normal.x + v * normal.z + d * normal.y);
    vTint = tint;
    gl_Position = size > 0.0 ? projectionMatrix * modelViewMatrix * vec4(place, 1.0) : vec4(2.0, 2.0, 2.0, 1.0);
  }`;

/** Lit from the eye, so that a drawing is as readable from every side. */
const FRAGMENT = `
  uniform float opacity;
  varying vec3 vTint;
  varying vec3 vNormal;
  void main() {
    float light = 0.5 + 0.5 * abs(normalize(vNormal).z);
    gl_FragColor = vec4(vTint * light, opacity);
    #include <colorspace_fragment>
  }`;

export class Sticks {
  /** Put this into the scene. What lies behind other things is drawn faintly. */
  readonly group = new Group();
  private geometry = new InstancedBufferGeometry();
  private readonly meshes: readonly Mesh[];
  private capacity = 0;
  private used = 0;
  private from!: InstancedBufferAttribute;
  private along!: InstancedBufferAttribute;
  private tint!: InstancedBufferAttribute;
  private wide!: InstancedBufferAttribute;

  constructor(head: boolean, seenThrough = 0.25) {
    const shape = head ? arrowShape() : rodShape();
    this.geometry.index = shape.index;
    for (const name of ["position", "normal", "part"]) this.geometry.setAttribute(name, shape.getAttribute(name));
    this.meshes = [this.mesh(head, 1), this.mesh(head, seenThrough)];
    this.group.add(...this.meshes);
    this.reserve(64);
    this.clear();
  }

  private mesh(head: boolean, opacity: number): Mesh {
    const behind = opacity < 1;
    const material = new ShaderMaterial({
      vertexShader: VERTEX, fragmentShader: FRAGMENT, defines: { HEAD: head ? "1.0" : "0.0" },
      uniforms: { opacity: { value: opacity } }, transparent: behind, depthWrite: !behind,
      ...(behind ? { depthFunc: GreaterDepth } : {}),
    });
    const mesh = new Mesh(this.geometry, material);
    mesh.frustumCulled = false;
    mesh.renderOrder = behind ? 6 : 5;
    return mesh;
  }

  clear(): void {
    this.used = 0;
    this.geometry.instanceCount = 0;
  }

  /** All in view units; `wide` is the radius of the head, or of a rod. */
  add(x: number, y: number, z: number, dx: number, dy: number, dz: number, wide: number, colour: Color): void {
    if (this.used === this.capacity) this.reserve(2 * this.capacity);
    const i = this.used++;
    this.from.setXYZ(i, x, y, z);
    this.along.setXYZ(i, dx, dy, dz);
    this.tint.setXYZ(i, colour.r, colour.g, colour.b);
    this.wide.setX(i, wide);
  }

  /** Hands what was added to the graphics card. */
  commit(): void {
    this.geometry.instanceCount = this.used;
    for (const one of [this.from, this.along, this.tint, this.wide]) {
      one.clearUpdateRanges();
      one.addUpdateRange(0, this.used * one.itemSize);
      one.needsUpdate = true;
    }
  }

  /** Grows by doubling; what was added stays. A new geometry, because three.js keeps the size that it saw first. */
  private reserve(capacity: number): void {
    this.capacity = capacity;
    const old = this.geometry;
    this.geometry = new InstancedBufferGeometry();
    this.geometry.index = old.index;
    for (const [name, one] of Object.entries(old.attributes)) this.geometry.setAttribute(name, one);
    for (const mesh of this.meshes) mesh.geometry = this.geometry;
    old.dispose();
    this.from = this.grown("from", 3);
    this.along = this.grown("along", 3);
    this.tint = this.grown("tint", 3);
    this.wide = this.grown("wide", 1);
  }

  private grown(name: string, size: number): InstancedBufferAttribute {
    const made = new InstancedBufferAttribute(new Float32Array(this.capacity * size), size);
    made.setUsage(DynamicDrawUsage);
    const old = this.geometry.getAttribute(name);
    if (old) made.array.set(old.array);
    this.geometry.setAttribute(name, made);
    return made;
  }
}

function rodShape(): BufferGeometry {
  return marked(new CylinderGeometry(1, 1, 1, 10, 1, true).translate(0, 0.5, 0), 0);
}

function arrowShape(): BufferGeometry {
  const shaft = new CylinderGeometry(1, 1, 1, 8, 1, false).translate(0, 0.5, 0);
  const head = new ConeGeometry(1, 1, 12).translate(0, 0.5, 0);
  return mergeGeometries([marked(shaft, 0), marked(head, 1)]);
}

function marked(shape: BufferGeometry, part: number): BufferGeometry {
  shape.deleteAttribute("uv");
  const count = shape.getAttribute("position").count;
  shape.setAttribute("part", new Float32BufferAttribute(new Array(count).fill(part), 1));
  return shape;
}
