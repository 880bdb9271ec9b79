// Marks of a fixed size on the screen: contact points and centres of mass. Shapes tell them apart, not colours.

import { BufferAttribute, BufferGeometry, DynamicDrawUsage, Points, ShaderMaterial, type Color } from "three";

const MANY = 60;

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
    float far = vShape == ${DIAMOND}.0 ? abs(p.x) + abs(p.y) : length(p);
    if (far > 1.0) discard;
    vec3 colour = vTint;
    if (vShape == ${DIAMOND}.0 && far < 0.45) colour = vec3(1.0);
    if (vShape == ${QUARTERS}.0) colour = p.x * p.y > 0.0 ? vec3(0.01) : vec3(0.98);
    if (far > 0.78) colour = vShape == ${QUARTERS}.0 ? vec3(0.01) : vec3(1.0);
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

  /** size: in CSS pixels; among many marks a third smaller. */
  constructor(private readonly size: number) {
    const material = new ShaderMaterial({
      vertexShader: VERTEX, fragmentShader: FRAGMENT, uniforms: { size: { value: size } }, depthTest: false,
      depthWrite: false, transparent: true,
    });
    this.points = new Points(this.geometry, material);
    this.points.frustumCulled = false;
    this.points.renderOrder = 8;
    this.points.onBeforeRender = (renderer) => {
      material.uniforms.size.value = (this.used > MANY ? 0.65 : 1) * this.size * renderer.getPixelRatio();
      material.uniformsNeedUpdate = true;
    };
    this.reserve(256);
    this.clear();
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
