// What does not change with time, and what both kinds of recordings make of it.

import type {
  Body, Field, Link, MeshData, Placed, QuantityGroup, Recording, Series, Track,
} from "./recording";

/** What does not change with time. */
export interface Still {
  readonly bodies: readonly Body[];
  readonly meshes: readonly MeshData[];
  readonly placed: readonly Placed[];
  readonly joints: readonly Link[];
  readonly springs: readonly Link[];
}

/** The part of a recording that stands still, and its quantities by name. */
export abstract class StillRecording implements Still {
  readonly bodies: readonly Body[];
  readonly meshes: readonly MeshData[];
  readonly placed: readonly Placed[];
  readonly joints: readonly Link[];
  readonly springs: readonly Link[];
  protected abstract quantities: Pick<Recording, "groups" | "members" | "fields" | "series">;

  constructor(
    still: Still,
    readonly units: Readonly<Record<string, readonly string[]>>,
  ) {
    ({ bodies: this.bodies, meshes: this.meshes, placed: this.placed, joints: this.joints, springs: this.springs } = still);
  }

  abstract track(path: string): Track | null;

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

  /** A track that every recording has. Raises an Error where it is missing. */
  protected needed(path: string): Track {
    const track = this.track(path);
    if (!track) throw new Error(`the recording has no ${path}`);
    return track;
  }
}
