// A run that is watched while it computes, as a recording that grows.

import { stillOf } from "../decode";
import type { AboutHead, SectionHead, StillHead } from "../head";
import { Quantities } from "../quantities";
import type { About, Contacts, Recording, Track } from "../recording";
import type { Sections } from "../sections";
import { StillRecording, type Still } from "../still";
import { Frames, type TrackKind } from "./frames";
import { messagesOf, type Message } from "./messages";
import { Pace } from "./pace";
import { LastingTrack, wholeRecording, type Store } from "./store";

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

export class LiveRecording extends StillRecording implements Recording {
  readonly forceError = 0;
  /** Simulated time that the run is to reach [s]. */
  readonly duration: number;
  about: About;
  status: LiveStatus = "running";
  private readonly grown: Frames;
  private readonly address: string;
  private readonly calls = new Set<() => void>();
  private readonly tracks = new Map<string, LastingTrack>();
  private store: Store;
  protected quantities: Pick<Recording, "groups" | "members" | "fields" | "series">;
  private whole: Recording | null = null;
  private newest = -1;
  private telling = false;
  private readonly pace = new Pace();

  constructor(head: LiveHead, still: Still) {
    super(still, head.units);
    const { physsim_version, frames_in_file, ...about } = head.about;
    this.about = { ...about, physsimVersion: physsim_version, framesInFile: frames_in_file };
    this.duration = head.live.duration;
    this.address = head.live.frames;
    this.store = this.grown = new Frames(head.live.tracks, still.bodies);
    this.quantities = new Quantities(this);
  }

  get frames(): number {
    return this.store.frames;
  }

  get times(): Float64Array {
    return this.store.times;
  }

  get growing(): boolean {
    return this.status === "running";
  }

  get strongestContact(): number {
    return this.store.strongestContact;
  }

  get topSpeed(): number {
    return this.store.topSpeed;
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
    return this.store.contacts(frame);
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
    if (this.growing) this.end("lost", LOST, 0);
  }

  private async follow(): Promise<void> {
    const answer = await fetch(`${this.address}?after=${this.newest}`, { cache: "no-store" });
    if (!answer.ok || !answer.body) return;
    for await (const message of messagesOf(answer.body)) await this.take(message);
  }

  private async take({ kind, facts, arrays }: Message): Promise<void> {
    if (kind === "frame") this.takeFrame({ kind, facts, arrays });
    if (kind === "end") this.end(facts.status as About["status"], facts.detail as string, facts.frames as number);
    if (kind === "whole") {
      this.whole = await wholeRecording(arrays[0].values as Uint8Array);
      this.tell();
    }
  }

  private takeFrame(message: Message): void {
    this.newest = message.facts.frame as number;
    this.grown.add(message);
    if (!this.tracks.size) this.begin();
    this.tell();
  }

  /** The first frame tells what there is. */
  private begin(): void {
    for (const name of this.grown.names) this.tracks.set(name, new LastingTrack(this.grown.track(name)!));
    this.quantities = new Quantities(this);
  }

  private end(status: LiveStatus, detail: string, framesInFile: number): void {
    this.status = status;
    this.about = { ...this.about, detail, framesInFile, status: status === "lost" ? "running" : status };
    this.tell();
  }

  /** Tells of growth, once for all frames that came in a while. Not with the next picture: a tab that nobody sees has
   *  no pictures, but its frames have to be thinned out. Frames keep their numbers until it is told. */
  private tell(): void {
    if (this.telling) return;
    this.telling = true;
    setTimeout(() => {
      this.telling = false;
      if (this.whole) this.takeWhole(this.whole);
      else if (this.grown.thinOut()) this.quantities = new Quantities(this);
      for (const call of [...this.calls]) call();
      this.pace.measure();
    }, this.pace.rest);
  }

  /** From now on everything is read from the recording of the whole file. */
  private takeWhole(whole: Recording): void {
    this.store = this.quantities = whole;
    this.about = whole.about;
    for (const [name, track] of this.tracks) track.source = whole.track(name) ?? track.source;
  }
}
