// A run that is watched while it computes, as a recording that grows.

import { stillOf, topSpeed, type Still } from "../decode";
import type { AboutHead, SectionHead, StillHead } from "../head";
import { Quantities } from "../quantities";
import type { About, Body, Contacts, Field, Link, MeshData, Placed, QuantityGroup, Recording, Series, Track } from "../recording";
import type { Sections } from "../sections";
import { Frames, type TrackKind } from "./frames";
import { messagesOf, type Message } from "./messages";

/** The head of a page that is fed by a run. */
export interface LiveHead extends StillHead {
  readonly about: AboutHead;
  readonly live: {
    /** Address of the stream, from the page. */
    readonly frames: string;
    /** Simulated time that the run is to reach [s]. */
    readonly duration: number;
    readonly tracks: readonly TrackKind[];
  };
  readonly sections: readonly SectionHead[];
}

/** running, how the run ended, or lost: nothing more will be known of it. */
export type LiveStatus = About["status"] | "lost";

/** After the connection broke: so often it is tried again, with so many milliseconds between. */
const ATTEMPTS = 5;
const PAUSE = 1000;
/** Milliseconds between two times that growth is told. */
const REST = 15;
const LOST = "the connection to the run was lost";

/** The recording with its first frame; it goes on growing by itself. Raises an Error when there is no run. */
export async function watched(head: LiveHead, sections: Sections): Promise<LiveRecording> {
  const recording = new LiveRecording(head, await stillOf(head, sections));
  const first = new Promise<void>((resolve) => {
    const stop = recording.onGrowth(() => {
      stop();
      resolve();
    });
  });
  void recording.listen();
  await first;
  if (!recording.frames) throw new Error(`Nothing can be shown: ${recording.about.detail || LOST}.`);
  return recording;
}

export class LiveRecording implements Recording {
  readonly bodies: readonly Body[];
  readonly meshes: readonly MeshData[];
  readonly placed: readonly Placed[];
  readonly joints: readonly Link[];
  readonly springs: readonly Link[];
  readonly units: Readonly<Record<string, readonly string[]>>;
  readonly forceError = 0;
  /** Simulated time that the run is to reach [s]. */
  readonly duration: number;
  about: About;
  status: LiveStatus = "running";
  topSpeed = 0;
  private readonly stored: Frames;
  private readonly address: string;
  private readonly calls = new Set<() => void>();
  private tracks = new Map<string, Track>();
  private quantities: Quantities;
  private newest = -1;
  private telling = false;

  constructor(head: LiveHead, still: Still) {
    ({ bodies: this.bodies, meshes: this.meshes, placed: this.placed, joints: this.joints, springs: this.springs } = still);
    const { physsim_version, frames_in_file, ...about } = head.about;
    this.about = { ...about, physsimVersion: physsim_version, framesInFile: frames_in_file };
    this.units = head.units;
    this.duration = head.live.duration;
    this.address = head.live.frames;
    this.stored = new Frames(head.live.tracks);
    this.quantities = new Quantities(this);
  }

  get frames(): number {
    return this.stored.count;
  }

  get times(): Float64Array {
    return this.stored.times;
  }

  get growing(): boolean {
    return this.status === "running";
  }

  get strongestContact(): number {
    return this.stored.strongestContact;
  }

  get position(): Track {
    return this.needed("position");
  }

  get orientation(): Track {
    return this.needed("orientation");
  }

  get velocity(): Track {
    return this.needed("velocity");
  }

  get angularVelocity(): Track {
    return this.needed("angular_velocity");
  }

  onGrowth(call: () => void): () => void {
    this.calls.add(call);
    return () => this.calls.delete(call);
  }

  track(path: string): Track | null {
    return this.tracks.get(path) ?? null;
  }

  contacts(frame: number): Contacts | null {
    return this.stored.contacts(frame);
  }

  get groups(): readonly QuantityGroup[] {
    return this.quantities.groups;
  }

  members(group: QuantityGroup): readonly string[] {
    return this.quantities.members(group);
  }

  fields(group: QuantityGroup, member?: string): readonly Field[] {
    return this.quantities.fields(group, member);
  }

  series(name: string): Series | null {
    return this.quantities.series(name);
  }

  /** Takes frames in until the run ends; tries again when the connection breaks. */
  async listen(): Promise<void> {
    for (let attempt = 0; attempt < ATTEMPTS && this.growing; attempt++) {
      if (attempt) await new Promise((resolve) => setTimeout(resolve, PAUSE));
      const before = this.newest;
      try {
        await this.follow();
      } catch {
        // A connection that breaks is tried again like one that ends.
      }
      if (this.newest > before) attempt = 0;
    }
    if (this.growing) this.end("lost", LOST);
  }

  private async follow(): Promise<void> {
    const answer = await fetch(`${this.address}?after=${this.newest}`, { cache: "no-store" });
    if (!answer.ok || !answer.body) return;
    for await (const message of messagesOf(answer.body)) this.take(message);
  }

  private take(message: Message): void {
    if (message.kind === "frame") this.takeFrame(message);
    if (message.kind === "end") this.end(message.facts.status as About["status"], message.facts.detail as string);
  }

  private takeFrame(message: Message): void {
    this.newest = message.facts.frame as number;
    const first = !this.frames;
    this.stored.add(message);
    if (first) this.begin();
    this.topSpeed = Math.max(this.topSpeed, topSpeed(this.only(this.frames - 1)));
    this.tell();
  }

  private begin(): void {
    this.tracks = this.stored.tracks();
    this.quantities = new Quantities(this);
  }

  /** One frame as a recording of its own. */
  private only(frame: number): Pick<Recording, "bodies" | "velocity" | "frames"> {
    const { velocity } = this;
    return { bodies: this.bodies, frames: 1, velocity: { ...velocity, read: (_, row, out, at) => velocity.read(frame, row, out, at) } };
  }

  private end(status: LiveStatus, detail: string): void {
    this.status = status;
    const inFile = this.newest + 1;
    this.about = { ...this.about, detail, framesInFile: inFile, status: status === "lost" ? "running" : status };
    this.tell();
  }

  /** Tells of growth, once for all frames that came in a while. Not with the next picture: a tab that nobody sees has
   *  no pictures, but its frames have to be thinned out. Frames keep their numbers until it is told. */
  private tell(): void {
    if (this.telling) return;
    this.telling = true;
    setTimeout(() => {
      this.telling = false;
      if (this.stored.thinOut()) this.quantities = new Quantities(this);
      for (const call of [...this.calls]) call();
    }, REST);
  }

  private needed(path: string): Track {
    const track = this.tracks.get(path);
    if (!track) throw new Error(`the run sends no ${path}`);
    return track;
  }
}
