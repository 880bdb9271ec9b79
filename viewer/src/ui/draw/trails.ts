// The ways that bodies have gone. All segments lie in the graphics card once; only the time moves.

import {
  BufferGeometry, Color, Float32BufferAttribute, InstancedBufferGeometry, InstancedInterleavedBuffer,
  InterleavedBufferAttribute, Mesh, ShaderMaterial, Vector2, Vector3,
} from "three";
import type { Recording } from "../../recording";
import type { World } from "../../world";
import { paced } from "../pace";
import { apart } from "../palette";
import type { Selection } from "../selection";
import type { Store } from "../settings";
import { bodyCenter } from "../pose";

/** More segments than this are not kept; frames are left out then. */
const MOST_SEGMENTS = 300_000;
const NUMBERS = 9;

/** A segment is widened on the screen, and cut at the moment that is shown and where it is too old. */
const VERTEX = `
  attribute vec4 from;
  attribute vec4 to;
  attribute float body;
  uniform vec2 screen;
  uniform float wide;
  uniform float now;
  uniform float span;
  uniform vec3 inks[6];
  varying vec3 vTint;
  varying float vAge;
  void main() {
    float reach = clamp((now - from.w) / max(to.w - from.w, 1e-30), 0.0, 1.0);
    vec4 a = projectionMatrix * modelViewMatrix * vec4(from.xyz, 1.0);
    vec4 b = projectionMatrix * modelViewMatrix * vec4(mix(from.xyz, to.xyz, reach), 1.0);
    vec2 way = (b.xy / b.w - a.xy / a.w) * screen;
    vec2 across = length(way) > 0.0 ? normalize(vec2(-way.y, way.x)) : vec2(0.0);
    vec4 place = mix(a, b, position.x);
    place.xy += across * position.y * wide / screen * place.w;
    vAge = (now - mix(from.w, to.w, position.x * reach)) / span;
    vTint = inks[int(mod(body, 6.0))];
    bool hidden = from.w >= now || a.w < 0.0 || b.w < 0.0;
    gl_Position = hidden ? vec4(2.0, 2.0, 2.0, 1.0) : place;
  }`;

const FRAGMENT = `
  varying vec3 vTint;
  varying float vAge;
  void main() {
    if (vAge > 1.0) discard;
    gl_FragColor = vec4(vTint, 1.0 - 0.75 * clamp(vAge, 0.0, 1.0));
    #include <colorspace_fragment>
  }`;

export class TrailDrawing {
  private readonly geometry = new InstancedBufferGeometry();
  private readonly mesh: Mesh;
  private readonly uniforms = {
    screen: { value: new Vector2(1, 1) }, wide: { value: 2.5 }, now: { value: 0 }, span: { value: 1 },
    inks: { value: Array.from({ length: 6 }, (_, i) => new Color().setRGB(...apart(i), "srgb")) },
  };
  private made = "";

  constructor(
    private readonly recording: Recording,
    private readonly world: World,
    private readonly store: Store,
    private readonly selection: Selection,
  ) {
    const quad = new Float32BufferAttribute([0, -1, 0, 1, -1, 0, 1, 1, 0, 0, 1, 0], 3);
    this.geometry.setAttribute("position", quad);
    this.geometry.setIndex([0, 1, 2, 0, 2, 3]);
    this.geometry.instanceCount = 0;
    this.mesh = new Mesh(this.geometry, new ShaderMaterial({
      vertexShader: VERTEX, fragmentShader: FRAGMENT, uniforms: this.uniforms, transparent: true, depthWrite: false,
    }));
    this.mesh.frustumCulled = false;
    world.overlay.add(this.mesh);
    selection.onChange(() => this.choose());
    store.watch(["trails", "trailLength"], () => this.choose());
    recording.onGrowth(paced(() => this.choose(), 500));
    world.onFrame((moment) => this.update(moment.time));
  }

  private update(now: number): void {
    if (!this.mesh.visible) return;
    this.uniforms.now.value = now;
    this.world.renderer.getSize(this.uniforms.screen.value).multiplyScalar(0.5);
  }

  /** Reads the ways of the bodies that are wanted, unless they are there already. */
  private choose(): void {
    const bodies = this.wanted();
    const { frames, times } = this.recording;
    this.mesh.visible = bodies.length > 0 && frames > 1;
    this.world.redraw();
    const { trailLength } = this.store.now;
    const whole = frames ? times[frames - 1] - times[0] : 1;
    this.uniforms.span.value = Math.max(1e-12, Math.min(trailLength, whole));
    const key = `${frames}:${bodies.join(",")}`;
    if (!this.mesh.visible || key === this.made) return;
    this.made = key;
    this.fill(bodies);
  }

  private wanted(): number[] {
    const { trails } = this.store.now;
    const { body, followed } = this.selection;
    if (trails === "none") return [];
    const moving = this.recording.bodies.filter((one) => !one.fixed).map((one) => one.index);
    return trails === "all" ? moving : moving.filter((one) => one === body || one === followed);
  }

  private fill(bodies: readonly number[]): void {
    const { frames, times } = this.recording;
    const stride = Math.max(1, Math.ceil((bodies.length * frames) / MOST_SEGMENTS));
    const steps = Math.ceil((frames - 1) / stride);
    const data = new Float32Array(NUMBERS * steps * bodies.length);
    const point = new Vector3();
    let at = 0;
    for (const body of bodies) {
      for (let step = 0; step <= steps; step++) {
        const frame = Math.min(frames - 1, step * stride);
        bodyCenter(this.recording, frame, body, point);
        this.world.toView(point.x, point.y, point.z, point);
        if (step > 0) setEnd(data, at - NUMBERS + 4, point, times[frame]);
        if (step === steps) break;
        setEnd(data, at, point, times[frame]);
        data[at + 8] = body;
        at += NUMBERS;
      }
    }
    this.give(data);
  }

  private give(data: Float32Array): void {
    const buffer = new InstancedInterleavedBuffer(data, NUMBERS);
    const set = (name: string, size: number, offset: number): BufferGeometry =>
      this.geometry.setAttribute(name, new InterleavedBufferAttribute(buffer, size, offset));
    set("from", 4, 0);
    set("to", 4, 4);
    set("body", 1, 8);
    this.geometry.instanceCount = data.length / NUMBERS;
  }
}

function setEnd(data: Float32Array, at: number, point: Vector3, time: number): void {
  data[at] = point.x;
  data[at + 1] = point.y;
  data[at + 2] = point.z;
  data[at + 3] = time;
}
