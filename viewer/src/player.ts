// The clock of the page: which moment is shown, and whether it runs.

import type { Recording } from "./recording";

/** The moment that is shown. One object for the whole life of the page; its arrays are overwritten. */
export interface Moment {
  /** [s] */
  time: number;
  /** The frame at or before `time`. */
  frame: number;
  /** How far on the way to the next frame, 0 to 1; 0: exactly the frame. */
  fraction: number;
  /** (bodies * 3) of each body's own origin [m] */
  positions: Float64Array;
  /** (bodies * 4) unit quaternions (w, x, y, z), body -> world */
  orientations: Float64Array;
  /** (bodies * 3) of the centres of mass [m/s] */
  velocities: Float64Array;
}

export interface Player {
  readonly recording: Recording;
  readonly moment: Moment;
  readonly playing: boolean;
  /** Whether it plays at the newest moment of a recording that grows, and goes on with it. */
  readonly following: boolean;
  /** Simulated seconds in one second of the wall; 1 is real time. */
  readonly speed: number;
  readonly loop: boolean;
  /** Time of the first and of the last frame [s]. */
  readonly start: number;
  readonly end: number;
  /** From the start again when it stands at the end, unless more may come. */
  play(): void;
  pause(): void;
  toggle(): void;
  /** Shows a time [s], kept within start and end. Goes on playing when it does. */
  seek(time: number): void;
  /** Pauses on the n-th frame from the one that is shown; negative: back. */
  step(n: number): void;
  setSpeed(speed: number): void;
  setLoop(loop: boolean): void;
  /** Called when playing, speed, loop or the moment changed, once per drawn picture at most. Returns how to stop that. */
  onChange(call: () => void): () => void;
}
