// The three.js scene: bodies, floor, light, camera, and the loop that draws them.
//
// Lengths in the three.js scene are not metres: a scene of planets and one of grains are both brought to about ten
// units, around the origin, because the graphics card computes in single precision. `toView` and `unit` convert.

import type { Camera, Color, Group, Scene, Vector3, WebGLRenderer } from "three";
import type { OrbitControls } from "three/addons/controls/OrbitControls.js";
import type { Moment } from "./player";

/** How a body is painted; `Painter` fills it in. */
export interface Paint {
  colour: Color;
  /** 0 plain, 1 halves, 2 stripes, 3 checks, 4 rings: drawn in two shades of the colour, fixed to the body.
   *  So that turning is seen, and materials can be told apart without colours. */
  pattern: number;
}

/** Paints one solid of a body at the moment that is shown. Must not allocate. */
export type Painter = (body: number, placed: number, moment: Moment, paint: Paint) => void;

export type Theme = "light" | "dark";

export interface World {
  readonly scene: Scene;
  readonly camera: Camera;
  readonly controls: OrbitControls;
  readonly renderer: WebGLRenderer;
  /** The element that is drawn into. */
  readonly canvas: HTMLCanvasElement;
  /** Drawings of the user interface go here; lengths in view units. Not picked, cast no shadows. */
  readonly overlay: Group;
  /** Metres of one view unit. */
  readonly unit: number;
  /** A point of the world [m] in view units. Returns `out`. */
  toView(x: number, y: number, z: number, out: Vector3): Vector3;
  /** A typical size of the bodies that move, in view units: to scale arrows, axes and coils. */
  readonly bodySize: number;

  /** Called before every picture, after the bodies were put in their places. Must not allocate. `elapsed`: seconds of the
   *  wall since the last picture. Returns how to stop that. */
  onFrame(call: (moment: Moment, elapsed: number) => void): () => void;
  /** Asks for a new picture: nothing is drawn while nothing changes. */
  redraw(): void;

  /** The body that is seen at a point of the window (clientX, clientY), null for none. */
  pick(x: number, y: number): number | null;
  /** `changes`: whether the paint depends on the moment (then it is asked for in every picture). */
  setColouring(painter: Painter, changes: boolean): void;
  /** Outlines one body, null for none. */
  setSelected(body: number | null): void;
  /** Keeps the camera beside a body, null: lets go. */
  follow(body: number | null): void;
  /** Moves the camera so that all that moves is seen. */
  frameAll(): void;
  /** Wireframes of what stands for the bodies in contacts. */
  setCollisionShapes(shown: boolean): void;
  /** Side of a cell of the grid [m]; its lines are at whole cells from the world's origin. */
  readonly gridCell: number;
  setGrid(shown: boolean): void;
  setShadows(wanted: boolean): void;
  setTheme(theme: Theme): void;

  /** Pictures per second, measured over the last second in which something moved; 0 before. */
  fps(): number;
  /** What the governor settled on, in words: "1280x720, shadows". */
  quality(): string;
}
