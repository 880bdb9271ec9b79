// Axes with letters: of the world at its origin, and of each body at its own.

import { CanvasTexture, Color, Group, Sprite, SpriteMaterial, SRGBColorSpace, Vector3 } from "three";
import type { Moment } from "../../player";
import type { Recording } from "../../recording";
import type { World } from "../../world";
import { turned } from "../pose";
import type { Store } from "../settings";
import { Sticks } from "./sticks";

const UNITS = [[1, 0, 0], [0, 1, 0], [0, 0, 1]] as const;
/** Vermilion, bluish green, blue: apart for all common kinds of colour blindness. */
const INKS = ["#d55e00", "#009e73", "#0072b2"].map((ink) => new Color(ink));
const PAPER = ["#d55e00", "#00805d", "#0072b2"];

export class WorldAxes {
  private readonly group = new Group();

  constructor(world: World, store: Store) {
    const sticks = new Sticks(true, 0.35);
    const origin = world.toView(0, 0, 0, new Vector3());
    const length = Math.max(2 * world.bodySize, 1.2);
    UNITS.forEach(([x, y, z], i) => {
      sticks.add(origin.x, origin.y, origin.z, length * x, length * y, length * z, 0.05 * length, INKS[i]);
      const letter = sign("XYZ"[i], PAPER[i]);
      letter.position.copy(origin).add(new Vector3(x, y, z).multiplyScalar(1.12 * length));
      this.group.add(letter);
    });
    sticks.commit();
    this.group.add(sticks.group);
    world.overlay.add(this.group);
    store.watch(["axes"], () => {
      this.group.visible = store.now.axes;
      world.redraw();
    });
  }
}

/** The frame of each body that moves: its origin and its axes. */
export class BodyFrames {
  private readonly sticks = new Sticks(true, 0.4);
  private readonly bodies: readonly number[];
  private readonly axis = new Vector3();
  private readonly origin = new Vector3();

  constructor(
    recording: Recording,
    private readonly world: World,
    store: Store,
  ) {
    this.bodies = recording.bodies.filter((body) => Number.isFinite(body.mass)).map((body) => body.index);
    world.overlay.add(this.sticks.group);
    store.watch(["frames"], () => {
      this.sticks.group.visible = store.now.frames;
      world.redraw();
    });
    world.onFrame((moment) => {
      if (this.sticks.group.visible) this.update(moment);
    });
  }

  private update(moment: Moment): void {
    const length = 0.9 * this.world.bodySize;
    this.sticks.clear();
    for (const body of this.bodies) {
      const p = moment.positions;
      const { x, y, z } = this.world.toView(p[3 * body], p[3 * body + 1], p[3 * body + 2], this.origin);
      for (let i = 0; i < 3; i++) {
        turned(moment, body, UNITS[i], this.axis).multiplyScalar(length);
        this.sticks.add(x, y, z, this.axis.x, this.axis.y, this.axis.z, 0.06 * length, INKS[i]);
      }
    }
    this.sticks.commit();
  }
}

/** A letter that faces the eye and keeps its size on the screen. */
function sign(letter: string, ink: string): Sprite {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 64;
  const context = canvas.getContext("2d");
  if (context) {
    context.font = "bold 46px system-ui, sans-serif";
    context.textAlign = "center";
    context.textBaseline = "middle";
    context.lineWidth = 8;
    context.strokeStyle = "#ffffff";
    context.strokeText(letter, 32, 34);
    context.fillStyle = ink;
    context.fillText(letter, 32, 34);
  }
  const map = new CanvasTexture(canvas);
  map.colorSpace = SRGBColorSpace;
  const sprite = new Sprite(new SpriteMaterial({ map, depthTest: false, sizeAttenuation: false, toneMapped: false }));
  sprite.scale.setScalar(0.045);
  sprite.renderOrder = 9;
  return sprite;
}
