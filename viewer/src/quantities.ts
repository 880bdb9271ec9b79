// Names as in a scene's `expect` (bodies.ball.position.z, energy.total) and their values over time.
// The names, and how each follows from what is recorded, are those of physsim/scene/quantity.py and
// physsim/recording/quantities.py.

import type { Body, Contacts, Field, Link, QuantityGroup, Series, Track } from "./recording";
import { turned } from "./rotation";

/** What quantities are computed from. */
export interface Source {
  readonly frames: number;
  readonly bodies: readonly Body[];
  readonly joints: readonly Link[];
  readonly springs: readonly Link[];
  track(path: string): Track | null;
  contacts(frame: number): Contacts | null;
  /** Units that differ from row to row: "joints/coordinate", "springs/length", ... */
  readonly units: Readonly<Record<string, readonly string[]>>;
  /** Relative, of each component of a contact force. */
  readonly forceError: number;
}

/** What is known of one quantity before it is computed; `fill` writes a vector for one frame. */
interface Recipe extends Field {
  fill(frame: number, out: Float64Array): void;
  error(component: number): number;
  note?: string;
}

const XYZ = ["x", "y", "z"] as const;
const WXYZ = ["w", "x", "y", "z"] as const;
const STATE_ENERGIES = ["kinetic_translational", "kinetic_rotational", "gravitational", "gravitation", "spring"];
const ENERGIES = [
  ...STATE_ENERGIES, "work_forces", "work_motors", "lost_damping", "lost_friction", "lost_impact", "stabilization", "residual",
];
const SUMS: Readonly<Record<string, readonly string[]>> = {
  kinetic: ["kinetic_translational", "kinetic_rotational"],
  total: STATE_ENERGIES,
};
const COORDINATES = ["coordinate", "coordinate_2", "coordinate_3"];

/** What can be plotted, and the numbers of it. */
export class Quantities {
  private readonly known = new Map<string, Series>();
  private readonly rows: Readonly<Record<string, ReadonlyMap<string, number>>>;

  constructor(private readonly source: Source) {
    const numbered = (some: readonly { name: string }[]) => new Map(some.map((one, row) => [one.name, row]));
    this.rows = { bodies: numbered(source.bodies), joints: numbered(source.joints), springs: numbered(source.springs) };
  }

  get groups(): QuantityGroup[] {
    const all: QuantityGroup[] = ["bodies", "joints", "springs", "energy", "momentum", "contacts", "solver"];
    return all.filter((group) => (this.rows[group] ? this.rows[group].size > 0 : this.recipes(group, -1).length > 0));
  }

  members(group: QuantityGroup): readonly string[] {
    return this.rows[group] ? [...this.rows[group].keys()] : [];
  }

  fields(group: QuantityGroup, member?: string): readonly Field[] {
    return this.recipes(group, this.rowOf(group, member ?? ""));
  }

  /** Computed once for a number of frames; null for a name that stands for nothing here, or for a whole vector. */
  series(name: string): Series | null {
    const known = this.known.get(name);
    if (known && known.values.length === this.source.frames) return known;
    const found = this.find(name);
    if (!found) return null;
    const series = this.computed(name, found[0], found[1]);
    this.known.set(name, series);
    return series;
  }

  private computed(name: string, recipe: Recipe, component: number): Series {
    const values = new Float64Array(this.source.frames);
    const vector = new Float64Array(Math.max(1, recipe.components.length));
    for (let frame = 0; frame < values.length; frame++) {
      recipe.fill(frame, vector);
      values[frame] = vector[component];
    }
    return { name, unit: recipe.unit, values, error: recipe.error(component), note: recipe.note ?? "" };
  }

  /** The recipe and the component of a name, read from the right: names of bodies may hold dots. */
  private find(name: string): [Recipe, number] | null {
    const [group, rest] = cut(name, name.indexOf("."));
    if (name === "time") return [timeRecipe(this.source), 0];
    for (const [owner, words] of endings(rest, Boolean(this.rows[group]))) {
      const row = this.rowOf(group, owner);
      if (this.rows[group] && row < 0) continue;
      const [field, part] = cut(words, words.indexOf("."));
      const recipe = this.recipes(group as QuantityGroup, row).find((one) => one.field === field);
      const component = recipe ? (recipe.components.length ? recipe.components.indexOf(part) : part ? -1 : 0) : -1;
      if (recipe && component >= 0) return [recipe, component];
    }
    return null;
  }

  private rowOf(group: string, member: string): number {
    return this.rows[group]?.get(member) ?? -1;
  }

  private recipes(group: QuantityGroup, row: number): Recipe[] {
    const source = this.source;
    if (this.rows[group] && row < 0) return [];
    switch (group) {
      case "bodies":
        return bodyRecipes(source, source.bodies[row]);
      case "joints":
        return jointRecipes(source, row);
      case "springs":
        return springRecipes(source, row);
      case "energy":
        return energyRecipes(source);
      case "momentum":
        return ["linear", "angular"].flatMap((field) => recorded(source, `momentum/${field}`, 0, field));
      case "contacts":
        return recorded(source, "solver/contact_count", 0, "count");
      case "solver":
        return ["residual", "iterations", "fallbacks"].flatMap((field) => recorded(source, `solver/${field}`, 0, field));
    }
  }
}

function cut(text: string, at: number): [string, string] {
  return at < 0 ? [text, ""] : [text.slice(0, at), text.slice(at + 1)];
}

/** "a.b.speed" as ["a.b", "speed"] and ["a", "b.speed"]; without owners as ["", "a.b.speed"]. */
function endings(rest: string, owned: boolean): [string, string][] {
  if (!owned) return [["", rest]];
  const last = rest.lastIndexOf(".");
  const before = rest.lastIndexOf(".", last - 1);
  return [last, before].filter((at) => at > 0).map((at) => cut(rest, at));
}

function timeRecipe(source: Source): Recipe {
  const track = source.track("time");
  return { field: "time", unit: "s", components: [], error: () => 0, fill: (frame, out) => track?.read(frame, 0, out, 0) };
}

/** A dataset as it is; none when it was not recorded. */
function recorded(source: Source, path: string, row: number, field: string, unit?: string): Recipe[] {
  const track = source.track(path);
  if (!track) return [];
  return [
    {
      field,
      unit: unit ?? track.unit,
      components: track.components === 3 ? XYZ : track.components === 4 ? WXYZ : [],
      fill: (frame, out) => track.read(frame, row, out, 0),
      error: (component) => track.error(row, component),
    },
  ];
}

/** The length of a recorded vector, which is off by no more than the vector is. */
function lengthOf(source: Source, path: string, row: number, field: string): Recipe[] {
  const track = source.track(path);
  if (!track) return [];
  const vector = new Float64Array(3);
  return [
    {
      field,
      unit: track.unit,
      components: [],
      fill: (frame, out) => {
        track.read(frame, row, vector, 0);
        out[0] = Math.hypot(vector[0], vector[1], vector[2]);
      },
      error: () => vectorError(track, row),
    },
  ];
}

function vectorError(track: Track, row: number): number {
  let square = 0;
  for (let k = 0; k < track.components; k++) square += track.error(row, k) ** 2;
  return Math.sqrt(square);
}

function bodyRecipes(source: Source, body: Body): Recipe[] {
  const row = body.index;
  return [
    ...["position", "orientation", "velocity", "angular_velocity"].flatMap((path) => recorded(source, path, row, path)),
    ...lengthOf(source, "velocity", row, "speed"),
    ...lengthOf(source, "angular_velocity", row, "angular_speed"),
    ...dynamics(source, body),
    ...contactForce(source, body),
  ];
}

/** E = (m v.v + w.L) / 2, p = m v, L = R I R^T w; 0 for a fixed body. Goldstein, 3rd ed., eqs. 1.31, 5.9 and 5.16. */
function dynamics(source: Source, body: Body): Recipe[] {
  const [turn, speed, spin] = ["orientation", "velocity", "angular_velocity"].map((path) => source.track(path));
  if (!turn || !speed || !spin) return [];
  const q = new Float64Array(4), inverse = new Float64Array(4), v = new Float64Array(3), w = new Float64Array(3);
  const own = new Float64Array(3), turning = new Float64Array(3), L = new Float64Array(3);
  const I = body.inertia;
  const angularMomentum = (frame: number): void => {
    turn.read(frame, body.index, q, 0);
    spin.read(frame, body.index, w, 0);
    inverse[0] = q[0];
    for (let k = 1; k < 4; k++) inverse[k] = -q[k];
    turned(inverse, 0, w[0], w[1], w[2], own, 0);
    for (let k = 0; k < 3; k++) turning[k] = I[3 * k] * own[0] + I[3 * k + 1] * own[1] + I[3 * k + 2] * own[2];
    turned(q, 0, turning[0], turning[1], turning[2], L, 0);
  };
  const mass = body.fixed ? 0 : body.mass;
  const note = "computed in the page from velocities and inertia";
  const whole = { error: () => NaN, note };
  return [
    {
      field: "kinetic_energy",
      unit: "J",
      components: [],
      fill: (frame, out) => {
        speed.read(frame, body.index, v, 0);
        angularMomentum(frame);
        out[0] = body.fixed ? 0 : (mass * dot(v, v) + dot(w, L)) / 2;
      },
      ...whole,
    },
    {
      field: "momentum",
      unit: "kg m s-1",
      components: XYZ,
      fill: (frame, out) => {
        speed.read(frame, body.index, out, 0);
        for (let k = 0; k < 3; k++) out[k] = body.fixed ? 0 : out[k] * mass;
      },
      error: (component) => mass * speed.error(body.index, component),
    },
    {
      field: "angular_momentum",
      unit: "kg m2 s-1",
      components: XYZ,
      fill: (frame, out) => {
        angularMomentum(frame);
        if (body.fixed) out.fill(0);
        else out.set(L);
      },
      ...whole,
    },
  ];
}

function dot(a: Float64Array, b: Float64Array): number {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/** Sum over the contact points of a body; what of them was left out of the page is missing. */
function contactForce(source: Source, body: Body): Recipe[] {
  if (!source.frames || !source.contacts(0)) return [];
  return [
    {
      field: "contact_force",
      unit: "N",
      components: XYZ,
      fill: (frame, out) => {
        out.fill(0);
        const contacts = source.contacts(frame);
        for (let k = 0; contacts && k < contacts.count; k++) {
          const sign = Number(contacts.bodyA[k] === body.index) - Number(contacts.bodyB[k] === body.index);
          for (let axis = 0; sign && axis < 3; axis++) out[axis] += sign * contacts.force[3 * k + axis];
        }
      },
      error: () => NaN,
      note: "summed up in the page over the contact points that it holds",
    },
  ];
}

function jointRecipes(source: Source, row: number): Recipe[] {
  return [
    ...recorded(source, "joints/force", row, "force"),
    ...recorded(source, "joints/torque", row, "torque"),
    ...lengthOf(source, "joints/force", row, "reaction"),
    ...COORDINATES.flatMap((field) => {
      const unit = source.units[`joints/${field}`]?.[row] ?? "";
      return unit ? recorded(source, `joints/${field}`, row, field, unit) : [];
    }),
    ...recorded(source, "joints/violation", row, "violation"),
    ...recorded(source, "joints/angular_violation", row, "angular_violation"),
  ];
}

/** Length and force stand for the angle and the torque of torsional springs. */
function springRecipes(source: Source, row: number): Recipe[] {
  const torsional = source.units["springs/length"]?.[row] === "rad";
  return [
    ...recorded(source, "springs/length", row, torsional ? "angle" : "length", torsional ? "rad" : "m"),
    ...recorded(source, "springs/force", row, torsional ? "torque" : "force", torsional ? "N m" : "N"),
  ];
}

function energyRecipes(source: Source): Recipe[] {
  const terms = ENERGIES.flatMap((field) => recorded(source, `energy/${field}`, 0, field));
  if (!terms.length) return [];
  return [...Object.entries(SUMS).map(([field, parts]) => sumOf(field, terms.filter((one) => parts.includes(one.field)))), ...terms];
}

function sumOf(field: string, terms: readonly Recipe[]): Recipe {
  const one = new Float64Array(1);
  return {
    field,
    unit: "J",
    components: [],
    fill: (frame, out) => {
      let sum = 0;
      for (const term of terms) {
        term.fill(frame, one);
        sum += one[0];
      }
      out[0] = sum;
    },
    error: () => terms.reduce((sum, term) => sum + term.error(0), 0),
  };
}
