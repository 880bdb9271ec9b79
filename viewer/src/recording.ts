// What was recorded, as the page sees it: who takes part, and numbers over time.
//
// Everything that draws or prints reads this interface. `decode.ts` makes one from the sections of a page,
// `live.ts` one that grows while a run goes on. Names, axes, units and signs are those of the trajectory file
// (docs: the trajectory file); all numbers are SI, in double precision, in the world's axes unless said otherwise.
// Nothing here allocates when asked for a frame.

/** A list of numbers to read into: `Float64Array`, `Float32Array` or a plain array. */
export type Numbers = Float64Array | Float32Array | number[];

export interface Body {
  readonly index: number;
  readonly name: string;
  readonly material: string;
  /** [kg]; Infinity for a half-space. */
  readonly mass: number;
  readonly fixed: boolean;
  /** "#rrggbb", of its material. */
  readonly colour: string;
  /** Centre of mass from the body's origin, body axes [m]. */
  readonly center: readonly [number, number, number];
  /** About the centre of mass, body axes, row by row [kg m2]. */
  readonly inertia: readonly number[];
}

/** A triangle mesh in its own axes; `Placed` scales and puts it. */
export interface MeshData {
  /** (V * 3) */
  readonly vertices: Float32Array;
  /** (V * 3), unit, outward */
  readonly normals: Float32Array;
  /** (T * 3), counter-clockwise from outside */
  readonly triangles: Uint32Array;
  /** The same with fewer triangles, null where there is no such. */
  readonly coarse: MeshData | null;
}

/** One solid of a body: mesh vertex * scale, turned and moved in the body's axes, is a point of the body. */
export interface Placed {
  readonly mesh: number;
  readonly body: number;
  readonly kind: SolidKind;
  readonly scale: readonly [number, number, number];
  /** From the body's origin, body axes [m]. */
  readonly position: readonly [number, number, number];
  /** Unit quaternion (w, x, y, z). */
  readonly orientation: readonly [number, number, number, number];
  /** "#rrggbb" */
  readonly colour: string;
  readonly material: string;
  /** What the user drew. */
  readonly shown: boolean;
  /** What stands for it in contacts. */
  readonly collides: boolean;
}

export type SolidKind =
  | "sphere" | "capsule" | "box" | "cylinder" | "cone" | "ellipsoid" | "rod" | "halfspace" | "surface";

/** The body number of the world. */
export const WORLD = -1;

/** A joint or a spring. */
export interface Link {
  readonly index: number;
  readonly name: string;
  /** As in the scene: hinge, slider, ball, ...; linear, torsional. */
  readonly kind: string;
  /** Body A and body B, `WORLD` for the world. */
  readonly bodies: readonly [number, number];
  /** Of A and of B, each in its body's own frame, from its origin [m]. */
  readonly anchors: readonly [readonly [number, number, number], readonly [number, number, number]];
  /** Unit vector in A's frame, null where the kind has none. */
  readonly axis: readonly [number, number, number] | null;
}

/** One dataset over time under the name it has in the file: `position`, `joints/force`, `energy/spring`. */
export interface Track {
  readonly name: string;
  /** SI, as the file says it: "m", "rad s-1", "J"; "" for what has none. */
  readonly unit: string;
  /** Bodies, joints or springs; 1 for what belongs to the scene. */
  readonly rows: number;
  /** Numbers of a row: 3 for a vector, 4 for a quaternion (w, x, y, z), 1 for a scalar. */
  readonly components: number;
  /** One number; NaN where the file has none. */
  at(frame: number, row: number, component: number): number;
  /** All numbers of a row into `out`, from `offset` on. */
  read(frame: number, row: number, out: Numbers, offset: number): void;
  /** Every number of it differs from the file's by no more than this; 0 where it is exact. */
  error(row: number, component: number): number;
}

/** Contact points of one frame. The arrays are used again for the next frame: copy what is to stay. */
export interface Contacts {
  /** Of points in this frame that the page holds. */
  count: number;
  /** Of points in this frame that were left out to keep the page small: the weakest. */
  omitted: number;
  bodyA: Int32Array;
  bodyB: Int32Array;
  /** (count * 3) [m] */
  position: Float64Array;
  /** (count * 3), on A, mean over the step that ends at the frame [N]; B receives the opposite. */
  force: Float64Array;
  /** 1 where the surfaces slide, 0 where they stick. */
  sliding: Uint8Array;
}

/** A name as in the scene's `expect` with what it measures, e.g. bodies.ball.velocity, m s-1, [x, y, z]. */
export interface Field {
  /** The last words: "velocity", "kinetic_energy", "coordinate", "total". */
  readonly field: string;
  readonly unit: string;
  /** Empty for a scalar. */
  readonly components: readonly string[];
}

export type QuantityGroup = "bodies" | "joints" | "springs" | "energy" | "momentum" | "contacts" | "solver";

/** One number over time. */
export interface Series {
  /** As in `expect`: "bodies.ball.position.z", "energy.total". */
  readonly name: string;
  readonly unit: string;
  /** One for each frame; NaN where there is none. */
  readonly values: Float64Array;
  /** No value differs from the file's by more; NaN when no bound is known (then `note` says why). */
  readonly error: number;
  /** What a reader of the curve must know, else "". */
  readonly note: string;
}

/** What is said about the file and about what was left out of the page. */
export interface About {
  readonly title: string;
  /** Name of the file, without folders. */
  readonly file: string;
  readonly status: "running" | "complete" | "failed" | "interrupted";
  /** Why it ended, "" when complete. */
  readonly detail: string;
  readonly physsimVersion: string;
  /** Frames in the file; the page may hold fewer. */
  readonly framesInFile: number;
  /** Sentences: precision of the numbers, thinned contacts, left out frames. For people. */
  readonly notes: readonly string[];
}

export interface Recording {
  readonly about: About;
  readonly bodies: readonly Body[];
  readonly meshes: readonly MeshData[];
  readonly placed: readonly Placed[];
  readonly joints: readonly Link[];
  readonly springs: readonly Link[];
  /** How many frames there are now; grows while a run is watched. May be 0. */
  readonly frames: number;
  /** Time of each frame [s], at least `frames` long, rising. */
  readonly times: Float64Array;
  /** Whether frames may still come: a run that is being watched. */
  readonly growing: boolean;
  /** Called whenever frames were added. Returns how to stop that. */
  onGrowth(call: () => void): () => void;

  /** (bodies, 3) of each body's own origin */
  readonly position: Track;
  /** (bodies, 4) unit quaternions (w, x, y, z), body -> world */
  readonly orientation: Track;
  /** (bodies, 3) of the centre of mass */
  readonly velocity: Track;
  /** (bodies, 3) */
  readonly angularVelocity: Track;
  /** Any dataset over time by its path in the file, null when it was not recorded:
   *  joints/{force,torque,coordinate,coordinate_2,coordinate_3,violation,angular_violation,broken}, springs/{length,force},
   *  energy/*, momentum/{linear,angular}, solver/*. */
  track(path: string): Track | null;

  /** Contacts of a frame; null when they were not recorded. The same object every time. */
  contacts(frame: number): Contacts | null;
  /** Largest force of any contact in the page [N], 0 when there is none: to scale arrows. */
  readonly strongestContact: number;
  /** Largest speed of any body that is not fixed, over all frames [m/s]: to scale colours. */
  readonly topSpeed: number;

  /** Names that can be plotted: groups that hold something, e.g. ["bodies", "energy"]. */
  readonly groups: readonly QuantityGroup[];
  /** Members of a group: names of bodies, joints, springs; [] for energy, momentum, contacts, solver. */
  members(group: QuantityGroup): readonly string[];
  /** What can be plotted of a member (of the group itself where it has no members). */
  fields(group: QuantityGroup, member?: string): readonly Field[];
  /** One number over time by its name as in `expect`; null when there is no such. Computed at the first call. */
  series(name: string): Series | null;
}
