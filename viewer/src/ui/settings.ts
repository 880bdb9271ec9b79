// What the person at the page has chosen to see. Kept in memory only.

export type Colouring = "material" | "speed" | "body";
export type ContactsOf = "all" | "selected";
export type Trails = "none" | "selected" | "all";
export type ThemeChoice = "auto" | "light" | "dark";

export interface Settings {
  contacts: boolean;
  contactsOf: ContactsOf;
  joints: boolean;
  springs: boolean;
  trails: Trails;
  /** How far back trails reach [s]; Infinity: to the start. */
  trailLength: number;
  axes: boolean;
  grid: boolean;
  centers: boolean;
  frames: boolean;
  labels: boolean;
  wireframe: boolean;
  shadows: boolean;
  colouring: Colouring;
  /** Force arrows are drawn this many times as long as usual. */
  arrowSize: number;
  theme: ThemeChoice;
}

export type Key = keyof Settings;
/** The settings that are on or off. */
export type Switch = { [K in Key]: Settings[K] extends boolean ? K : never }[Key];

export const AT_FIRST: Settings = {
  contacts: false,
  contactsOf: "all",
  joints: true,
  springs: true,
  trails: "none",
  trailLength: Infinity,
  axes: false,
  grid: true,
  centers: false,
  frames: false,
  labels: false,
  wireframe: false,
  shadows: true,
  colouring: "material",
  arrowSize: 1,
  theme: "auto",
};

/** Settings that tell who listens. */
export class Store {
  readonly now: Settings = { ...AT_FIRST };
  private readonly calls = new Map<Key, (() => void)[]>();

  set<K extends Key>(key: K, value: Settings[K]): void {
    if (this.now[key] === value) return;
    this.now[key] = value;
    for (const call of this.calls.get(key) ?? []) call();
  }

  flip(key: Switch): void {
    this.set(key, !this.now[key]);
  }

  /** Calls at once and after every change of one of the keys. */
  watch(keys: readonly Key[], call: () => void): void {
    for (const key of keys) this.calls.set(key, [...(this.calls.get(key) ?? []), call]);
    call();
  }
}
