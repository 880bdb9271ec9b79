// Everything that can be plotted, found by a few words of its name.

import type { Field, QuantityGroup, Recording } from "../recording";

/** A plot to make: its heading and the quantities in it. */
export interface Entry {
  readonly title: string;
  /** Names as in `expect`. */
  readonly names: readonly string[];
  readonly unit: string;
}

const STATE = ["kinetic_translational", "kinetic_rotational", "gravitational", "gravitation", "spring", "total"];

/** Plots of all energies, for runs that recorded them. */
export function energyEntries(recording: Recording): Entry[] {
  if (!recording.groups.includes("energy")) return [];
  const fields = recording.fields("energy").map((field) => field.field);
  const sums = fields.filter((field) => !STATE.includes(field) && field !== "kinetic");
  const state = STATE.filter((field) => fields.includes(field));
  const entry = (title: string, of: readonly string[]): Entry => ({
    title, names: of.map((field) => `energy.${field}`), unit: "J",
  });
  return [
    entry("energy: state", state), entry("energy: work and losses", sums), entry("energy: all columns", [...state, ...sums]),
  ].filter((one) => one.names.length);
}

/** The entries whose names hold every word of `text`, at most `most`, and whether there are more. */
export function search(recording: Recording, text: string, most: number): { found: Entry[]; more: boolean } {
  const words = text.toLowerCase().split(/\s+/).filter(Boolean);
  const found: Entry[] = [];
  for (const entry of entries(recording)) {
    const title = entry.title.toLowerCase();
    if (!words.every((word) => title.includes(word))) continue;
    if (found.length === most) return { found, more: true };
    found.push(entry);
  }
  return { found, more: false };
}

function* entries(recording: Recording): Generator<Entry> {
  yield* energyEntries(recording);
  for (const group of recording.groups) yield* ofGroup(recording, group);
}

function* ofGroup(recording: Recording, group: QuantityGroup): Generator<Entry> {
  const members = recording.members(group);
  if (!members.length) yield* ofOwner(group, recording.fields(group));
  for (const member of members) yield* ofOwner(`${group}.${member}`, recording.fields(group, member));
}

/** A vector as one plot of all its components, then each by itself. */
function* ofOwner(owner: string, fields: readonly Field[]): Generator<Entry> {
  for (const { field, unit, components } of fields) {
    const title = `${owner}.${field}`;
    const parts = components.map((component) => `${title}.${component}`);
    yield { title, names: parts.length ? parts : [title], unit };
    for (const part of parts) yield { title: part, names: [part], unit };
  }
}

/** The entry of that name, with components or without; null when nothing of it was recorded. */
export function entryOf(recording: Recording, name: string): Entry | null {
  for (const suffix of ["", ".x", ".w"]) {
    const first = recording.series(name + suffix);
    if (!first) continue;
    const parts = suffix === "" ? [name] : (suffix === ".x" ? ["x", "y", "z"] : ["w", "x", "y", "z"]).map((c) => `${name}.${c}`);
    return { title: name, names: parts, unit: first.unit };
  }
  return null;
}

/** The names of an entry without what they have in common, for a legend. */
export function shortNames(names: readonly string[]): string[] {
  const prefix = names[0].slice(0, names[0].lastIndexOf(".") + 1);
  const shared = names.every((name) => name.startsWith(prefix));
  return names.map((name) => (shared ? name.slice(prefix.length) : name).replaceAll("_", " "));
}
