// What a recording that grows reads from: the frames that came so far, and when the run is over, the whole of it.

import { recordingOf } from "../decode";
import type { Head } from "../head";
import type { Numbers, Recording, Track } from "../recording";
import { DocumentSections } from "../sections";

export type Store = Pick<Recording, "frames" | "times" | "contacts" | "strongestContact" | "topSpeed" | "track">;

/** A track that stays the same object while what it reads from is replaced. */
export class LastingTrack implements Track {
  constructor(public source: Track) {}

  get name(): string {
    return this.source.name;
  }

  get unit(): string {
    return this.source.unit;
  }

  get rows(): number {
    return this.source.rows;
  }

  get components(): number {
    return this.source.components;
  }

  at(frame: number, row: number, component: number): number {
    return this.source.at(frame, row, component);
  }

  read(frame: number, row: number, out: Numbers, offset: number): void {
    this.source.read(frame, row, out, offset);
  }

  error(row: number, component: number): number {
    return this.source.error(row, component);
  }
}

/** The recording of a whole page, given as its bytes. */
export function wholeRecording(page: Uint8Array): Promise<Recording> {
  const parsed = new DOMParser().parseFromString(new TextDecoder().decode(page), "text/html");
  const head = JSON.parse(parsed.getElementById("head")?.textContent ?? "") as Head;
  return recordingOf(head, new DocumentSections(head.sections, parsed));
}
