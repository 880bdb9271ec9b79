// A page's head and sections as a recording.

import { PackedContacts } from "./contacts";
import { VERSION, type Head, type Indexed, type LinksHead, type MeshHead, type StillHead, type TrackHead } from "./head";
import { Quantities } from "./quantities";
import type { About, Body, Contacts, Link, MeshData, Placed, Recording, SolidKind, Track } from "./recording";
import type { Sections } from "./sections";
import { StillRecording, type Still } from "./still";
import { PackedTrack } from "./tracks";

type Vector = readonly [number, number, number];

/** Opens the sections that hold bodies, shapes, joints and springs. */
export async function stillOf(head: StillHead, sections: Sections): Promise<Still> {
  return {
    bodies: await bodiesOf(head, sections),
    meshes: await meshesOf(head, sections),
    placed: await placedOf(head, sections),
    joints: linksOf(head.joints, await sections.doubles(head.joints.numbers)),
    springs: linksOf(head.springs, await sections.doubles(head.springs.numbers)),
  };
}

/** Opens all sections. Raises an Error in plain words when the page is incomplete. */
export async function recordingOf(head: Head, sections: Sections): Promise<Recording> {
  if (head.version !== VERSION) throw new Error(`the page is of version ${head.version}, its script of ${VERSION}`);
  const still = await stillOf(head, sections);
  const times = await sections.doubles(head.times);
  const tracks = new Map<string, Track>([["time", timeTrack(times)]]);
  for (const track of head.tracks) tracks.set(track.name, await trackOf(track, head, sections));
  const planes = head.contacts ? planesOf(head, head.contacts.force) : 0;
  const contacts = head.contacts && (await PackedContacts.from(head.contacts, head.frames, planes, sections));
  return new PackedRecording(head, still, times, tracks, contacts);
}

async function trackOf(track: TrackHead, head: Head, sections: Sections): Promise<Track> {
  const codes = await sections.codes(track.codes);
  const scale = await sections.doubles(track.scale);
  const { name, unit, rows, components } = track;
  return new PackedTrack(name, unit, rows, components, codes, scale, planesOf(head, track.codes));
}

function planesOf(head: Head, section: number): number {
  const found = head.sections[section];
  return found.kind === "coded" ? found.planes : 0;
}

function timeTrack(times: Float64Array): Track {
  return {
    name: "time",
    unit: "s",
    rows: 1,
    components: 1,
    at: (frame) => times[frame],
    read: (frame, _row, out, offset) => void (out[offset] = times[frame]),
    error: () => 0,
  };
}

class PackedRecording extends StillRecording implements Recording {
  readonly about: About;
  readonly frames: number;
  readonly growing = false;
  readonly forceError: number;
  readonly position: Track;
  readonly orientation: Track;
  readonly velocity: Track;
  readonly angularVelocity: Track;
  readonly topSpeed: number;
  protected readonly quantities: Quantities;

  constructor(
    head: Head,
    still: Still,
    readonly times: Float64Array,
    private readonly tracks: ReadonlyMap<string, Track>,
    private readonly packed: PackedContacts | null,
  ) {
    super(still, head.units);
    this.about = aboutOf(head);
    this.frames = head.frames;
    this.forceError = head.contacts?.force_error ?? 0;
    this.position = this.needed("position");
    this.orientation = this.needed("orientation");
    this.velocity = this.needed("velocity");
    this.angularVelocity = this.needed("angular_velocity");
    this.topSpeed = topSpeed(this.bodies, this.velocity, 0, this.frames);
    this.quantities = new Quantities(this);
  }

  onGrowth(): () => void {
    return () => undefined;
  }

  track(path: string): Track | null {
    return this.tracks.get(path) ?? null;
  }

  contacts(frame: number): Contacts | null {
    return this.packed?.at(frame) ?? null;
  }

  get strongestContact(): number {
    return this.packed?.strongest ?? 0;
  }
}

function aboutOf(head: Head): About {
  const { title, file, status, detail, notes } = head.about;
  return { title, file, status, detail, notes, physsimVersion: head.about.physsim_version, framesInFile: head.about.frames_in_file };
}

/** Largest speed of a body that is not fixed, from a frame to before another [m/s]. */
export function topSpeed(bodies: readonly Body[], velocity: Track, first: number, end = first + 1): number {
  const v = new Float64Array(3);
  let square = 0;
  for (const body of bodies) {
    for (let frame = first; !body.fixed && frame < end; frame++) {
      velocity.read(frame, body.index, v, 0);
      const own = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
      if (own > square) square = own;
    }
  }
  return Math.sqrt(square);
}

async function bodiesOf(head: StillHead, sections: Sections): Promise<Body[]> {
  const { name, material, colour, fixed, numbers } = head.bodies;
  const values = await sections.doubles(numbers);
  return name.map((word, index) => ({
    index,
    name: word,
    material: wordOf(material, index),
    mass: values[13 * index],
    fixed: fixed[index] === 1,
    colour: wordOf(colour, index),
    center: three(values, 13 * index + 1),
    inertia: Array.from(values.subarray(13 * index + 4, 13 * index + 13)),
  }));
}

async function meshesOf(head: StillHead, sections: Sections): Promise<MeshData[]> {
  const meshes: MeshData[] = [];
  for (const mesh of head.meshes) meshes.push(await meshOf(mesh, sections));
  return meshes;
}

async function meshOf(head: MeshHead, sections: Sections): Promise<MeshData> {
  return {
    vertices: await sections.floats(head.vertices),
    normals: await sections.floats(head.normals),
    triangles: await sections.wholes(head.triangles),
    coarse: head.coarse && (await meshOf(head.coarse, sections)),
  };
}

async function placedOf(head: StillHead, sections: Sections): Promise<Placed[]> {
  const { mesh, body, kind, material, colour, shown, collides, numbers } = head.placed;
  const values = await sections.doubles(numbers);
  return mesh.map((number, k) => ({
    mesh: number,
    body: body[k],
    kind: wordOf(kind, k) as SolidKind,
    scale: three(values, 10 * k),
    position: three(values, 10 * k + 3),
    orientation: [values[10 * k + 6], values[10 * k + 7], values[10 * k + 8], values[10 * k + 9]],
    colour: wordOf(colour, k),
    material: wordOf(material, k),
    shown: shown[k] === 1,
    collides: collides[k] === 1,
  }));
}

function linksOf(head: LinksHead, values: Float64Array): Link[] {
  return head.name.map((name, index) => ({
    index,
    name,
    kind: wordOf(head.kind, index),
    bodies: head.bodies[index],
    anchors: [three(values, 9 * index), three(values, 9 * index + 3)],
    axis: Number.isFinite(values[9 * index + 6]) ? three(values, 9 * index + 6) : null,
  }));
}

function wordOf(words: Indexed, place: number): string {
  return words.words[words.of[place]];
}

function three(values: Float64Array, at: number): Vector {
  return [values[at], values[at + 1], values[at + 2]];
}
