// Marks of a fixed size on the screen: contact points and centres of mass. Shapes tell them apart, not colours.

import { BufferAttribute, BufferGeometry, DynamicDrawUsage, Points, ShaderMaterial, type Color } from "three";

export const DISC = 0;
export const DIAMOND = 1;
/** The sign of the centre of mass: quarters in turns light and dark. */
export const QUARTERS = 2;

const VERTEX = `
  attribute vec3 tint;
  attribute float shape;
  uniform float size;
  varying vec3 vTint;
  varying float vShape;
  void main() {
    vTint = tint;
    vShape = shape;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
    gl_PointSize = size;
  }`;

const FRAGMENT = `
  varying vec3 vTint;
  varying float vShape;
  void main() {
    vec2 p = 2.0 * gl_PointCoord - 1.0;
    bool diamond = abs(vShape - ${DIAMOND}.0) < 0.5;
    bool quarters = abs(vShape - ${QUARTERS}.0) < 0.5;
    float far = diamond ? abs(p.x) + abs(p.y) : length(p);
    if (far > 1.0) discard;
    vec3 colour = vTint;
    if (quarters) colour = p.x * p.y > 0.0 ? vec3(0.01) : vec3(0.98);
    if (far > 0.8) colour = quarters ? vec3(0.01) : vec3(1.0);
    gl_FragColor = vec4(colour, 1.0);
    #include <colorspace_fragment>
  }`;

export class Marks {
  readonly points: Points;
  private capacity = 0;
  private used = 0;
  private place!: BufferAttribute;
  private tint!: BufferAttribute;
  private shape!: BufferAttribute;
  private readonly geometry = new BufferGeometry();

  /** size: in CSS pixels, of a few; many are drawn smaller. */
  constructor(private readonly size: number) {
    const material = new ShaderMaterial({
      vertexShader: VERTEX, fragmentShader: FRAGMENT, uniforms: { size: { value: size } }, depthTest: false,
      depthWrite: false, transparent: true,
    });
    this.points = new Points(this.geometry, material);
    this.points.frustumCulled = false;
    this.points.renderOrder = 8;
    this.points.onBeforeRender = (renderer) => {
      material.uniforms.size.value = this.pixels() * renderer.getPixelRatio();
      material.uniformsNeedUpdate = true;
    };
    this.reserve(256);
    this.clear();
  }

  private pixels(): number {
    return this.size * (this.used > 200 ? 0.5 : this.used > 50 ? 0.7 : 1);
  }

  clear(): void {
    this.used = 0;
    this.geometry.setDrawRange(0, 0);
  }

  add(x: number, y: number, z: number, shape: number, colour: Color): void {
    if (this.used === this.capacity) this.reserve(2 * this.capacity);
    const i = this.used++;
    this.place.setXYZ(i, x, y, z);
    this.tint.setXYZ(i, colour.r, colour.g, colour.b);
    this.shape.setX(i, shape);
  }

  commit(): void {
    this.geometry.setDrawRange(0, this.used);
    for (const one of [this.place, this.tint, this.shape]) {
      one.clearUpdateRanges();
      one.addUpdateRange(0, this.used * one.itemSize);
      one.needsUpdate = true;
    }
  }

  private reserve(capacity: number): void {
    this.capacity = capacity;
    this.place = this.grown("position", 3);
    this.tint = this.grown("tint", 3);
    this.shape = this.grown("shape", 1);
  }

  private grown(name: string, size: number): BufferAttribute {
    const made = new BufferAttribute(new Float32Array(this.capacity * size), size).setUsage(DynamicDrawUsage);
    const old = this.geometry.getAttribute(name);
    if (old) (made.array as Float32Array).set(old.array);
    this.geometry.setAttribute(name, made);
    return made;
  }
}
