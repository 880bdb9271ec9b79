// The world as it is drawn: puts the parts together and draws them when something changed.

import {
  Color, Group, MeshBasicMaterial, PCFShadowMap, Scene, Vector3, WebGLRenderer, type Camera,
} from "three";
import type { OrbitControls } from "three/addons/controls/OrbitControls.js";
import { batchesOf, type Batch, type Frame } from "./batch";
import { bodyRadii, diagonal, sceneBox, typicalRadius, type Box } from "./bounds";
import type { Clock } from "./clock";
import { byMaterial } from "./colours";
import { Governor, type Quality } from "./governor";
import { Ground } from "./ground";
import { Lights } from "./lights";
import { Markers } from "./markers";
import { bodyMaterial, simpleMaterial } from "./material";
import { Outline } from "./outline";
import { Picker } from "./picker";
import type { Moment } from "./player";
import { Rate } from "./rate";
import type { Recording } from "./recording";
import { Rig } from "./rig";
import type { Paint, Painter, Theme, World } from "./world";

/** The diagonal of the scene in view units. */
const SIZE = 10;
const RADIUS = SIZE / 2;
/** Milliseconds without motion after which a better picture is drawn. */
const STILL_AFTER = 250;

const THEMES = {
  light: { background: "#e9edf2", floor: "#cfd6de", wall: "#9aa7b5", lines: "#8b98a6", outline: "#d9480f", shapes: "#1c4f8a" },
  dark: { background: "#14171c", floor: "#2a2f37", wall: "#66707d", lines: "#5c6673", outline: "#ffa94d", shapes: "#9cc4f5" },
} as const;

type Call = (moment: Moment, elapsed: number) => void;

export class Stage implements World {
  readonly scene = new Scene();
  readonly overlay = new Group();
  readonly unit: number;
  readonly bodySize: number;
  readonly canvas: HTMLCanvasElement;
  private readonly frame: Frame;
  private readonly radii: Float64Array;
  private readonly rig: Rig;
  private readonly lights = new Lights(RADIUS);
  private readonly ground: Ground;
  private readonly markers: Markers;
  private readonly batches: readonly Batch[];
  private shapes: readonly Batch[] = [];
  private readonly shapeMaterial = new MeshBasicMaterial({ wireframe: true });
  private readonly outline: Outline;
  private readonly picker: Picker;
  private readonly governor: Governor;
  private readonly rate = new Rate();
  private readonly calls = new Set<Call>();
  private readonly paint: Paint = { colour: new Color(), pattern: 0 };
  private painter: Painter;
  private repaint = true;
  private repaintAlways = false;
  private shadowsWanted = true;
  private followed: number | null = null;
  private readonly place = new Vector3();
  private scheduled = false;
  /** What is to be set before the next picture. */
  private sizeDue = true;
  private qualityDue = true;
  /** Drawn as a still picture. */
  private still = true;
  private settling = 0;
  private lastTick = 0;
  private lastTime = NaN;

  /** software: whether the processor draws instead of a graphics card. */
  constructor(
    readonly renderer: WebGLRenderer,
    private readonly recording: Recording,
    private readonly clock: Clock,
    software: boolean,
  ) {
    this.canvas = renderer.domElement;
    this.radii = bodyRadii(recording);
    const box = sceneBox(recording, this.radii);
    this.unit = diagonal(box) / SIZE;
    this.frame = { unit: this.unit, origin: middleOf(box) };
    this.bodySize = typicalRadius(recording, this.radii) / this.unit || 0.02 * SIZE;
    this.governor = new Governor(window.devicePixelRatio, software, recording.placed.length);
    this.rig = new Rig(this.canvas, RADIUS);
    const surfaces = { smooth: bodyMaterial(), simple: simpleMaterial };
    this.batches = batchesOf(recording.meshes, surfaces, recording.placed, this.frame, (placed) => placed.shown);
    this.ground = new Ground(recording, clock.moment, this.frame, RADIUS, (box.low[2] - this.frame.origin[2]) / this.unit);
    this.markers = new Markers(recording.bodies, this.radii, this.frame, RADIUS);
    this.outline = new Outline(recording.placed, this.batches);
    this.picker = new Picker(this.canvas, this.rig.camera, recording.placed, this.batches, this.ground, this.markers);
    this.painter = byMaterial(recording.placed);
    this.assemble();
    this.setTheme("light");
    this.rig.controls.addEventListener("change", () => this.redraw());
    recording.onGrowth(() => this.redraw());
    new ResizeObserver(() => this.resized()).observe(this.canvas);
    this.resize();
  }

  get camera(): Camera {
    return this.rig.camera;
  }

  get controls(): OrbitControls {
    return this.rig.controls;
  }

  toView(x: number, y: number, z: number, out: Vector3): Vector3 {
    const { unit, origin } = this.frame;
    return out.set((x - origin[0]) / unit, (y - origin[1]) / unit, (z - origin[2]) / unit);
  }

  onFrame(call: Call): () => void {
    this.calls.add(call);
    return () => this.calls.delete(call);
  }

  redraw(): void {
    if (this.scheduled) return;
    this.scheduled = true;
    requestAnimationFrame((now) => this.tick(now));
  }

  pick(x: number, y: number): number | null {
    return this.picker.pick(x, y);
  }

  setColouring(painter: Painter, changes: boolean): void {
    this.painter = painter;
    this.repaint = true;
    this.repaintAlways = changes;
    this.redraw();
  }

  setSelected(body: number | null): void {
    this.outline.set(body);
    this.redraw();
  }

  follow(body: number | null): void {
    this.followed = body;
    this.rig.follow(body === null ? null : this.placeOf(body));
    this.redraw();
  }

  frameAll(): void {
    const box = sceneBox(this.recording, this.radii);
    this.follow(null);
    this.rig.show(this.toView(...box.low, new Vector3()), this.toView(...box.high, new Vector3()));
    this.redraw();
  }

  setCollisionShapes(shown: boolean): void {
    if (shown && !this.shapes.length) {
      const wires = { smooth: this.shapeMaterial, simple: () => this.shapeMaterial };
      this.shapes = batchesOf(this.recording.meshes, wires, this.recording.placed, this.frame, (placed) => placed.collides);
      for (const batch of this.shapes) this.scene.add(batch.instances);
    }
    for (const batch of this.shapes) batch.instances.visible = shown;
    this.redraw();
  }

  get gridCell(): number {
    return this.ground.cell;
  }

  setGrid(shown: boolean): void {
    this.ground.setGrid(shown);
    this.redraw();
  }

  setShadows(wanted: boolean): void {
    this.shadowsWanted = wanted;
    this.qualityDue = true;
    this.redraw();
  }

  setTheme(theme: Theme): void {
    const colours = THEMES[theme];
    this.scene.background = new Color(colours.background);
    this.ground.setColours(colours);
    this.outline.setColour(colours.outline);
    this.shapeMaterial.color.set(colours.shapes);
    this.redraw();
  }

  fps(): number {
    return this.rate.perSecond;
  }

  quality(): string {
    const { pixels, shadows, fine } = this.current;
    const size = `${this.canvas.width}x${this.canvas.height} (${pixels} of a pixel)`;
    const shadow = shadows && this.shadowsWanted ? `shadows ${shadows}` : "no shadows";
    return `${size}, ${shadow}, ${fine ? "fine" : "coarse"}`;
  }

  private assemble(): void {
    this.scene.add(this.lights.group, this.ground.group, this.markers.points, this.outline.group, this.overlay);
    for (const batch of this.batches) {
      batch.instances.castShadow = true;
      batch.instances.receiveShadow = true;
      this.scene.add(batch.instances);
    }
    this.renderer.shadowMap.type = PCFShadowMap;
    this.renderer.shadowMap.autoUpdate = false;
  }

  private tick(now: number): void {
    this.scheduled = false;
    const elapsed = this.lastTick ? Math.max(0, (now - this.lastTick) / 1000) : 0;
    const playing = this.clock.playing && !this.clock.following;
    this.clock.advance(playing ? elapsed : 0);
    if (playing && this.rate.count(now) && this.governor.measure(elapsed)) this.qualityDue = true;
    if (!playing) {
      this.rate.pause();
      this.governor.restart();
    }
    const glides = this.prepare(elapsed);
    this.settle(playing || glides || this.clock.moment.time !== this.lastTime);
    this.draw();
    const goesOn = this.clock.playing && !this.clock.following;
    this.lastTick = goesOn ? now : 0;
    if (goesOn || glides) this.redraw();
  }

  /** Puts everything in its place; true while the camera still glides. */
  private prepare(elapsed: number): boolean {
    const { moment } = this.clock;
    if (this.sizeDue) this.resize();
    for (const batch of this.batches) batch.move(moment);
    for (const batch of this.shapes) if (batch.instances.visible) batch.move(moment);
    this.markers.move(moment);
    if (this.followed !== null) this.rig.along(this.placeOf(this.followed));
    const glides = this.rig.update();
    if (this.repaint || this.repaintAlways) {
      for (const batch of this.batches) batch.paint(this.painter, moment, this.paint);
      this.repaint = false;
    }
    for (const call of this.calls) call(moment, elapsed);
    this.outline.move(this.canvas.clientWidth, this.canvas.clientHeight);
    return glides;
  }

  private draw(): void {
    const { time } = this.clock.moment;
    if (this.qualityDue) this.applyQuality();
    this.renderer.shadowMap.needsUpdate ||= time !== this.lastTime;
    this.lastTime = time;
    this.renderer.render(this.scene, this.rig.camera);
  }

  /** Draws in the quality of what moves, and once more in that of a still picture when nothing has moved for a while. */
  private settle(moves: boolean): void {
    if (!moves && (this.still || this.settling)) return;
    window.clearTimeout(this.settling);
    this.settling = window.setTimeout(() => this.become(true), STILL_AFTER);
    if (moves && this.still) this.become(false);
  }

  private become(still: boolean): void {
    if (still) this.settling = 0;
    this.still = still;
    if (this.governor.still === this.governor.quality) return;
    this.qualityDue = true;
    this.redraw();
  }

  private placeOf(body: number): Vector3 {
    const { positions } = this.clock.moment;
    return this.toView(positions[3 * body], positions[3 * body + 1], positions[3 * body + 2], this.place);
  }

  private get current(): Quality {
    return this.still ? this.governor.still : this.governor.quality;
  }

  private applyQuality(): void {
    const { pixels, shadows, fine } = this.current;
    this.qualityDue = false;
    const side = this.shadowsWanted ? shadows : 0;
    for (const batch of this.batches) batch.setDetail(fine);
    this.lights.setShadows(side);
    this.ground.setShadows(side > 0);
    this.renderer.shadowMap.enabled = side > 0;
    this.renderer.shadowMap.needsUpdate = true;
    this.renderer.setPixelRatio(Math.min(pixels, Math.max(1, window.devicePixelRatio)));
  }

  private resized(): void {
    this.sizeDue = true;
    this.redraw();
  }

  private resize(): void {
    const width = this.canvas.clientWidth || 1, height = this.canvas.clientHeight || 1;
    const untouched = this.rig.isUntouched;
    this.rig.resize(width, height);
    this.renderer.setSize(width, height, false);
    this.sizeDue = false;
    // A panel that opens beside the picture must not hide what moves.
    if (untouched) this.frameAll();
  }
}

function middleOf(box: Box): [number, number, number] {
  return [0, 1, 2].map((axis) => (box.low[axis] + box.high[axis]) / 2) as [number, number, number];
}
