// The JSON head of a page, as physsim/view/page/pack.py and head.py write it.

/** Each different word once, and for each place which one. */
export interface Indexed {
  readonly words: readonly string[];
  readonly of: readonly number[];
}

/** What is needed to open a section; numbers of sections stand wherever the head says `section`. */
export type SectionHead =
  | { readonly kind: "coded"; readonly rows: number; readonly length: number; readonly planes: number }
  | { readonly kind: "f8" | "f4" | "u4"; readonly length: number };

/** The number of a section. */
export type SectionNumber = number;

export interface BodiesHead {
  readonly name: readonly string[];
  readonly material: Indexed;
  readonly colour: Indexed;
  readonly fixed: readonly (0 | 1)[];
  /** 13 of each: mass, centre (3), inertia (9) */
  readonly numbers: SectionNumber;
}

export interface MeshHead {
  readonly vertices: SectionNumber;
  readonly normals: SectionNumber;
  readonly triangles: SectionNumber;
  /** The same with fewer triangles, null where there is no such. */
  readonly coarse: MeshHead | null;
}

export interface PlacedHead {
  readonly mesh: readonly number[];
  readonly body: readonly number[];
  readonly kind: Indexed;
  readonly material: Indexed;
  readonly colour: Indexed;
  readonly shown: readonly (0 | 1)[];
  readonly collides: readonly (0 | 1)[];
  /** 10 of each: scale (3), position (3), orientation (4) */
  readonly numbers: SectionNumber;
}

export interface LinksHead {
  readonly name: readonly string[];
  readonly kind: Indexed;
  readonly bodies: readonly (readonly [number, number])[];
  /** 9 of each: anchors (6), axis (3), NaN where there is none */
  readonly numbers: SectionNumber;
}

export interface TrackHead {
  readonly name: string;
  readonly unit: string;
  readonly rows: number;
  readonly components: number;
  readonly codes: SectionNumber;
  /** base, step and error, rows * components of each */
  readonly scale: SectionNumber;
}

/** Points in the order of their bodies; all but `in_file` and `scale` have `count` columns. */
export interface ContactsHead {
  readonly count: number;
  readonly frame: SectionNumber;
  readonly body_a: SectionNumber;
  readonly body_b: SectionNumber;
  readonly sliding: SectionNumber;
  /** How many each frame has in the file. */
  readonly in_file: SectionNumber;
  readonly position: SectionNumber;
  /** base, step and error of x, y, z */
  readonly scale: SectionNumber;
  /** The upper bytes of float32, 3 rows. */
  readonly force: SectionNumber;
  readonly force_error: number;
}

export interface AboutHead {
  readonly title: string;
  readonly file: string;
  readonly status: "running" | "complete" | "failed" | "interrupted";
  readonly detail: string;
  readonly physsim_version: string;
  readonly frames_in_file: number;
  readonly notes: readonly string[];
}

/** What does not change with time. */
export interface StillHead {
  readonly bodies: BodiesHead;
  readonly meshes: readonly MeshHead[];
  readonly placed: PlacedHead;
  readonly joints: LinksHead;
  readonly springs: LinksHead;
  /** Units that differ from row to row, by dataset: "joints/coordinate", "springs/length", ... */
  readonly units: Readonly<Record<string, readonly string[]>>;
}

export interface Head extends StillHead {
  readonly version: number;
  readonly about: AboutHead;
  readonly frames: number;
  readonly times: SectionNumber;
  readonly tracks: readonly TrackHead[];
  readonly contacts: ContactsHead | null;
  readonly sections: readonly SectionHead[];
}

export const VERSION = 1;
