// `window.physsim`: the page as programs see it (tests, lessons, other pages that embed it).

import type { App, Ui } from "./app";
import type { Numbers, Track } from "./recording";

/** Numbers of the selected body at the moment that is shown, SI, as the file names them. */
export interface BodyNumbers {
  readonly position: number[];
  readonly orientation: number[];
  readonly velocity: number[];
  readonly angular_velocity: number[];
  readonly mass: number;
  readonly material: string;
  readonly fixed: boolean;
  /** No number differs from the file's by more, on a frame. */
  readonly error: Readonly<Record<"position" | "orientation" | "velocity" | "angular_velocity", number[]>>;
}

export interface State {
  /** [s] */
  readonly time: number;
  /** The frame at or before it. */
  readonly frame: number;
  readonly frames: number;
  readonly playing: boolean;
  readonly speed: number;
  readonly selected: string | null;
  readonly numbers: BodyNumbers | null;
}

export interface Physsim {
  /** Fulfilled when the page can be played; fails with what is wrong. All else may be called after that. */
  readonly ready: Promise<void>;
  play(): void;
  pause(): void;
  /** Shows a time [s]. */
  seek(time: number): void;
  /** Pauses n frames further. */
  step(n: number): void;
  /** Selects a body by its name; null: none. */
  select(name: string | null): void;
  state(): State;
  /** Pictures per second of the last second in which something moved. */
  fps(): number;
  /** What the pictures are drawn with, in words: "1280x720 (1 of a pixel), shadows 1024". */
  quality(): string;
}

declare global {
  interface Window {
    physsim: Physsim;
  }
}

interface Running {
  readonly app: App;
  readonly ui: Ui;
}

/** The interface of a page that is being opened. */
export function apiOf(opening: Promise<Running>): Physsim {
  let running: Running | null = null;
  const now = (): Running => {
    if (!running) throw new Error("the page is not open yet: await physsim.ready");
    return running;
  };
  return {
    ready: opening.then((parts) => void (running = parts)),
    play: () => now().app.player.play(),
    pause: () => now().app.player.pause(),
    seek: (time) => now().app.player.seek(time),
    step: (n) => now().app.player.step(n),
    select: (name) => now().ui.select(name === null ? null : bodyNamed(now().app, name)),
    state: () => stateOf(now()),
    fps: () => now().app.world.fps(),
    quality: () => now().app.world.quality(),
  };
}

/** The index of a body. */
export function bodyNamed(app: App, name: string): number {
  const body = app.recording.bodies.find((one) => one.name === name);
  if (!body) throw new Error(`there is no body ${JSON.stringify(name)}`);
  return body.index;
}

function stateOf({ app, ui }: Running): State {
  const { player, recording } = app;
  const body = ui.selected();
  return {
    time: player.moment.time,
    frame: player.moment.frame,
    frames: recording.frames,
    playing: player.playing,
    speed: player.speed,
    selected: body === null ? null : recording.bodies[body].name,
    numbers: body === null ? null : numbersOf(app, body),
  };
}

function numbersOf({ recording, player }: App, body: number): BodyNumbers {
  const { moment } = player;
  const { material, mass, fixed } = recording.bodies[body];
  const part = (list: Numbers, size: number): number[] => Array.from(list.slice(size * body, size * body + size));
  const errors = (track: Track): number[] => Array.from({ length: track.components }, (_, k) => track.error(body, k));
  return {
    position: part(moment.positions, 3),
    orientation: part(moment.orientations, 4),
    velocity: part(moment.velocities, 3),
    angular_velocity: spinOf(recording.angularVelocity, moment.frame, moment.fraction, body),
    mass,
    material,
    fixed,
    error: {
      position: errors(recording.position),
      orientation: errors(recording.orientation),
      velocity: errors(recording.velocity),
      angular_velocity: errors(recording.angularVelocity),
    },
  };
}

/** On the straight line between two frames. */
function spinOf(track: Track, frame: number, fraction: number, body: number): number[] {
  return [0, 1, 2].map((k) => {
    const here = track.at(frame, body, k);
    return fraction === 0 ? here : here + fraction * (track.at(frame + 1, body, k) - here);
  });
}
