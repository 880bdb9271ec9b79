// Springs as coils that stretch between their ends, torsional ones as spirals that wind up.
//
// One ribbon of wire is kept for all, and the graphics card bends it for each spring: its centre line is
//   from + axis * h(s) + r(s) * (side cos f(s) + (axis x side) sin f(s)),   s from 0 to 1.
// The number of turns stays; only h stretches (linear) or only f winds up (torsional).

import {
  Color, DynamicDrawUsage, Float32BufferAttribute, GreaterDepth, Group, InstancedBufferAttribute,
  InstancedBufferGeometry, Mesh, ShaderMaterial, Vector3,
} from "three";
import type { Moment } from "../../player";
import type { Link, Recording, Track } from "../../recording";
import type { World } from "../../world";
import { interpolated } from "../numbers";
import { anchor, turned } from "../pose";
import type { Store } from "../settings";
import { DISC, Marks } from "./marks";
import { TINTED } from "./tinted";

/** The straight wire at each end of a coil, as a share of its length. */
const LEAD = 0.12;
const TURNS = 9;
/** Turns of a flat spiral at angle 0, and its inner radius as a share of the outer. */
const SPIRAL_TURNS = 3;
const INNER = 0.25;
/** Pieces of wire, and corners of its cross-section. */
const ALONG = 40 * TURNS;
const AROUND = 6;

const VERTEX = `
  attribute vec3 from;
  attribute vec3 axis;
  attribute vec3 side;
  attribute vec3 bend;
  varying vec3 vNormal;
  const float PI2 = 6.283185307179586;
  vec3 curve(float s) {
    float twist = bend.z;
    vec3 v = normalize(cross(axis, side));
    float h; float r; float f;
    if (twist > -1e8) {
      h = 0.0;
      r = bend.x * mix(${INNER}, 1.0, s);
      f = (1.0 - s) * (PI2 * ${SPIRAL_TURNS}.0 + twist);
      return from + r * (side * cos(f) + v * sin(f));
    }
    h = s;
    r = bend.x * clamp((s - ${LEAD / 2}) / ${LEAD / 2}, 0.0, 1.0) * clamp((1.0 - s - ${LEAD / 2}) / ${LEAD / 2}, 0.0, 1.0);
    f = PI2 * ${TURNS}.0 * clamp((s - ${LEAD}) / ${1 - 2 * LEAD}, 0.0, 1.0);
    return from + axis * h + r * (side * cos(f) + v * sin(f));
  }
  void main() {
    float s = position.x;
    vec3 place = curve(s);
    vec3 along = normalize(curve(min(1.0, s + 0.001)) - curve(max(0.0, s - 0.001)) + 1e-9 * side);
    vec3 u = normalize(cross(along, abs(dot(along, normalize(axis))) < 0.95 ? axis : side));
    vec3 v = cross(along, u);
    vec3 normal = u * cos(position.y) + v * sin(position.y);
    vNormal = normalMatrix * normal;
    gl_Position = projectionMatrix * modelViewMatrix * vec4(place + bend.y * normal, 1.0);
  }`;

const LINEAR = -1e9;
const WIRE = new Color("#7d8597");

export class SpringDrawing {
  private readonly group = new Group();
  private readonly geometry = new InstancedBufferGeometry();
  private readonly attributes: Record<"from" | "axis" | "side" | "bend", InstancedBufferAttribute>;
  private readonly ends = new Marks(6);
  private readonly radii: number[];
  private readonly angles: Track | null;
  private readonly a = new Vector3();
  private readonly b = new Vector3();
  private readonly side = new Vector3();

  constructor(
    private readonly recording: Recording,
    private readonly world: World,
    store: Store,
  ) {
    const count = recording.springs.length;
    this.attributes = {
      from: attribute(count), axis: attribute(count), side: attribute(count), bend: attribute(count),
    };
    this.angles = recording.track("springs/length");
    this.radii = recording.springs.map((spring) => this.radius(spring));
    this.build();
    world.overlay.add(this.group);
    store.watch(["springs"], () => {
      this.group.visible = store.now.springs && count > 0;
      world.redraw();
    });
    world.onFrame((moment) => this.group.visible && recording.frames > 0 && this.update(moment));
  }

  private build(): void {
    const { positions, index } = ribbon();
    this.geometry.setAttribute("position", new Float32BufferAttribute(positions, 3));
    this.geometry.setIndex(index);
    for (const [name, one] of Object.entries(this.attributes)) this.geometry.setAttribute(name, one);
    this.geometry.instanceCount = this.recording.springs.length;
    this.group.add(wire(this.geometry, 1), wire(this.geometry, 0.22), this.ends.points);
    for (let i = 0; i < this.radii.length; i++) this.attributes.side.setXYZ(i, 1, 0, 0);
  }

  /** Of the coil [view units]: by its typical length, within what fits between bodies. */
  private radius(spring: Link): number {
    const { bodySize, unit } = this.world;
    if (spring.kind === "torsional" || !this.recording.frames || !this.angles) return 0.6 * bodySize;
    const last = this.recording.frames - 1;
    const lengths = [0, last >> 2, last >> 1, last].map((frame) => this.angles?.at(frame, spring.index, 0) ?? 0);
    const mean = lengths.reduce((sum, one) => sum + one, 0) / lengths.length / unit;
    return Math.min(0.4 * bodySize, 0.1 * mean) || 0.2 * bodySize;
  }

  private update(moment: Moment): void {
    this.ends.clear();
    this.recording.springs.forEach((spring, i) => {
      this.toView(anchor(moment, spring, 0, this.a));
      this.toView(anchor(moment, spring, 1, this.b));
      this.attributes.from.setXYZ(i, this.a.x, this.a.y, this.a.z);
      this.ends.add(this.a.x, this.a.y, this.a.z, DISC, WIRE);
      if (spring.kind === "torsional") this.wind(moment, spring, i);
      else this.stretch(i);
    });
    this.ends.commit();
    for (const one of Object.values(this.attributes)) one.needsUpdate = true;
  }

  private stretch(i: number): void {
    const { axis, bend } = this.attributes;
    this.ends.add(this.b.x, this.b.y, this.b.z, DISC, WIRE);
    this.b.sub(this.a);
    axis.setXYZ(i, this.b.x, this.b.y, this.b.z);
    bend.setXYZ(i, this.radii[i], 0.16 * this.radii[i], LINEAR);
    this.setSide(i, this.b.normalize());
  }

  /** From body A, the outer end, to body B, the inner; `side` turns with A. */
  private wind(moment: Moment, spring: Link, i: number): void {
    const { axis, bend } = this.attributes;
    turned(moment, spring.bodies[0], spring.axis ?? [0, 0, 1], this.b);
    axis.setXYZ(i, this.b.x, this.b.y, this.b.z);
    const angle = this.angles ? interpolated(this.angles, moment, spring.index, 0) : 0;
    bend.setXYZ(i, this.radii[i], 0.035 * this.radii[i], angle);
    const [x, y, z] = spring.axis ?? [0, 0, 1];
    turned(moment, spring.bodies[0], Math.abs(z) < 0.9 ? [-y, x, 0] : [0, -z, y], this.side);
    this.side.normalize();
    this.attributes.side.setXYZ(i, this.side.x, this.side.y, this.side.z);
  }

  /** A direction across the axis that changes as little as it can, so that a coil does not spin while it swings. */
  private setSide(i: number, axis: Vector3): void {
    const { side } = this.attributes;
    this.side.set(side.getX(i), side.getY(i), side.getZ(i));
    this.side.addScaledVector(axis, -this.side.dot(axis));
    if (this.side.lengthSq() < 1e-6) this.side.set(axis.y, axis.z, -axis.x).addScaledVector(axis, -this.side.dot(axis));
    this.side.normalize();
    side.setXYZ(i, this.side.x, this.side.y, this.side.z);
  }

  private toView(point: Vector3): void {
    this.world.toView(point.x, point.y, point.z, point);
  }
}

/** What lies behind bodies is drawn faintly, by a second mesh with an opacity below 1. */
function wire(geometry: InstancedBufferGeometry, opacity: number): Mesh {
  const behind = opacity < 1;
  const mesh = new Mesh(geometry, new ShaderMaterial({
    vertexShader: VERTEX, fragmentShader: TINTED, uniforms: { tint: { value: WIRE }, opacity: { value: opacity } },
    transparent: behind, depthWrite: !behind, ...(behind ? { depthFunc: GreaterDepth } : {}),
  }));
  mesh.frustumCulled = false;
  return mesh;
}

function attribute(count: number): InstancedBufferAttribute {
  return new InstancedBufferAttribute(new Float32Array(3 * Math.max(1, count)), 3).setUsage(DynamicDrawUsage);
}

/** The wire as (share of its length, angle around it): a grid that the vertex program bends. */
function ribbon(): { positions: number[]; index: number[] } {
  const positions: number[] = [];
  const index: number[] = [];
  for (let i = 0; i <= ALONG; i++) {
    for (let k = 0; k < AROUND; k++) positions.push(i / ALONG, (2 * Math.PI * k) / AROUND, 0);
  }
  for (let i = 0; i < ALONG; i++) {
    for (let k = 0; k < AROUND; k++) {
      const here = i * AROUND + k;
      const next = i * AROUND + ((k + 1) % AROUND);
      index.push(here, next, here + AROUND, next, next + AROUND, here + AROUND);
    }
  }
  return { positions, index };
}
