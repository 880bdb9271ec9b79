// The frames of a run that is watched, as many as a browser has room for.

import { emptyContacts } from "../contacts";
import { topSpeed } from "../decode";
import type { Body, Contacts, Numbers, Track } from "../recording";
import type { Message } from "./messages";
import type { Store } from "./store";

/** Memory of all frames together [bytes], and how many frames there may be of small scenes. */
const MOST_BYTES = 128 * 1024 * 1024;
const MOST_FRAMES = 20_000;
/** The newest part of the frames, which is not thinned out. */
const RECENT = 0.25;
/** What may be left when older frames were thinned out, of the most that there may be. */
const ROOM = 0.9;

/** A dataset that frames may have. */
export interface TrackKind {
  readonly name: string;
  readonly unit: string;
  readonly components: number;
}

interface Frame {
  readonly arrival: number;
  readonly time: number;
  /** Of all tracks, one after the other. */
  readonly numbers: Float64Array;
  readonly contacts: Contacts | null;
  readonly bytes: number;
}

/** Where a track stands in the numbers of a frame. */
interface Place extends TrackKind {
  readonly rows: number;
  readonly offset: number;
}

/** Frames in the order they came. Old ones become sparser when there are too many, the same everywhere. */
export class Frames implements Store {
  times = new Float64Array(1024);
  strongestContact = 0;
  topSpeed = 0;
  private kept: Frame[] = [];
  private places: readonly Place[] = [];
  private bytes = 0;
  private arrivals = 0;
  private stride = 1;
  private tracks = new Map<string, Track>();

  constructor(
    private readonly kinds: readonly TrackKind[],
    private readonly bodies: readonly Body[],
  ) {}

  get frames(): number {
    return this.kept.length;
  }

  /** Names of all datasets that frames have. */
  get names(): string[] {
    return [...this.tracks.keys()];
  }

  /** Takes in a frame; the first one tells what was recorded. */
  add(message: Message): void {
    if (!this.kept.length) this.begin(message);
    const frame = this.frameOf(message);
    this.kept.push(frame);
    this.bytes += frame.bytes;
    this.noteTime(this.kept.length - 1);
    if (frame.contacts) this.strongestContact = Math.max(this.strongestContact, strongestOf(frame.contacts));
    const velocity = this.tracks.get("velocity");
    if (velocity) this.topSpeed = Math.max(this.topSpeed, topSpeed(this.bodies, velocity, this.kept.length - 1));
  }

  /** When there are too many frames: of the older ones those stay whose arrival a stride divides, which doubles when
   *  that is not enough. Returns whether frames went, so that others have other numbers now. */
  thinOut(): boolean {
    if (!this.fills(1)) return false;
    while (this.kept.length > 2 && this.fills(ROOM)) {
      const recent = Math.max(Math.trunc((1 - RECENT) * this.kept.length), 1);
      this.kept = this.kept.filter((frame, k) => k >= recent || frame.arrival % this.stride === 0);
      this.bytes = this.kept.reduce((sum, frame) => sum + frame.bytes, 0);
      if (this.fills(ROOM)) this.stride *= 2;
    }
    this.kept.forEach((_, k) => this.noteTime(k));
    return true;
  }

  track(path: string): Track | null {
    return this.tracks.get(path) ?? null;
  }

  contacts(frame: number): Contacts | null {
    return this.kept[frame].contacts;
  }

  private begin(message: Message): void {
    this.places = placesOf(this.kinds, message);
    this.tracks = new Map(this.places.map((place) => [place.name, this.trackAt(place)]));
  }

  private fills(part: number): boolean {
    return this.bytes > part * MOST_BYTES || this.kept.length > part * MOST_FRAMES;
  }

  private frameOf(message: Message): Frame {
    const last = this.places[this.places.length - 1];
    const time = message.facts.time as number;
    const numbers = new Float64Array(last ? last.offset + last.rows * last.components : 0).fill(NaN);
    const arrays = new Map(message.arrays.map((array) => [array.name, array.values]));
    arrays.set("time", Float64Array.of(time));
    for (const { name, offset } of this.places) {
      const values = arrays.get(name);
      if (values) numbers.set(values, offset);
    }
    const contacts = contactsOf(arrays);
    const bytes = numbers.byteLength + (contacts ? 57 * contacts.count : 0);
    return { arrival: this.arrivals++, time, numbers, contacts, bytes };
  }

  private trackAt({ name, unit, rows, components, offset }: Place): Track {
    return {
      name,
      unit,
      rows,
      components,
      at: (frame, row, component) => this.kept[frame].numbers[offset + row * components + component],
      read: (frame, row, out: Numbers, to) => {
        const { numbers } = this.kept[frame];
        const from = offset + row * components;
        for (let k = 0; k < components; k++) out[to + k] = numbers[from + k];
      },
      error: () => 0,
    };
  }

  private noteTime(frame: number): void {
    if (frame === this.times.length) {
      const longer = new Float64Array(2 * frame);
      longer.set(this.times);
      this.times = longer;
    }
    this.times[frame] = this.kept[frame].time;
  }
}

function placesOf(kinds: readonly TrackKind[], message: Message): Place[] {
  const lengths = new Map([["time", 1], ...message.arrays.map((array) => [array.name, array.values.length] as const)]);
  const places: Place[] = [];
  let offset = 0;
  for (const kind of kinds) {
    const length = lengths.get(kind.name);
    if (length === undefined) continue;
    places.push({ ...kind, rows: length / kind.components, offset });
    offset += length;
  }
  return places;
}

function contactsOf(arrays: ReadonlyMap<string, Float64Array | Int32Array | Uint8Array>): Contacts | null {
  const bodyA = arrays.get("contacts/body_a");
  const bodyB = arrays.get("contacts/body_b");
  const position = arrays.get("contacts/position");
  const force = arrays.get("contacts/force");
  const sliding = arrays.get("contacts/sliding");
  if (!bodyA || !bodyB || !position || !force || !sliding) return null;
  const contacts = emptyContacts(bodyA.length);
  contacts.count = bodyA.length;
  contacts.bodyA.set(bodyA);
  contacts.bodyB.set(bodyB);
  contacts.position.set(position);
  contacts.force.set(force);
  contacts.sliding.set(sliding);
  return contacts;
}

function strongestOf({ count, force }: Contacts): number {
  let square = 0;
  for (let k = 0; k < 3 * count; k += 3) square = Math.max(square, force[k] ** 2 + force[k + 1] ** 2 + force[k + 2] ** 2);
  return Math.sqrt(square);
}
