// The selected joint or spring: its kind, its bodies, what it measures and bears at this moment.

import type { Player } from "../player";
import { WORLD, type Link, type Recording, type Track } from "../recording";
import { element, textButton } from "./dom";
import { interpolated } from "./numbers";
import { Reading } from "./reading";
import type { Selection } from "./selection";

const XYZ = ["x", "y", "z"];
const OF_JOINTS = ["coordinate", "coordinate_2", "coordinate_3", "force", "torque", "violation", "angular_violation"];
const OF_SPRINGS = ["length", "force"];
const IN_TORSION: Record<string, string> = { length: "angle", force: "torque" };

interface Row {
  track: Track;
  reading: Reading;
  values: number[];
}

export class LinkCard {
  readonly element: HTMLElement;
  private readonly rows: Row[] = [];

  constructor(
    private readonly recording: Recording,
    private readonly player: Player,
    private readonly link: Link,
    what: "joint" | "spring",
    selection: Selection,
    plot: (name: string) => void,
  ) {
    for (const path of what === "joint" ? OF_JOINTS : OF_SPRINGS) this.addRow(what, path, plot);
    this.element = element(
      "section", { class: "card" },
      element("h3", { class: "name" }, link.name),
      element("p", { class: "facts" }, `${link.kind} ${what} between`),
      element("div", { class: "between" }, ...link.bodies.map((body) => this.end(body, selection))),
      ...this.rows.map((row) => row.reading.element),
    );
    if (!this.rows.length) this.element.append(element("p", { class: "note" }, "Nothing about it was recorded."));
    this.print();
  }

  print(): void {
    if (!this.recording.frames) return;
    for (const { track, reading, values } of this.rows) {
      for (let i = 0; i < values.length; i++) values[i] = interpolated(track, this.player.moment, this.link.index, i);
      reading.print(values, this.player.playing, (i) => track.error(this.link.index, i));
    }
  }

  private addRow(what: "joint" | "spring", path: string, plot: (name: string) => void): void {
    const track = this.recording.track(`${what}s/${path}`);
    if (!track || Number.isNaN(track.at(0, this.link.index, 0))) return;
    const field = this.link.kind === "torsional" ? (IN_TORSION[path] ?? path) : path;
    const known = this.recording.fields(`${what}s`, this.link.name).find((one) => one.field === field);
    const parts = track.components === 3 ? XYZ : [];
    const reading = new Reading(field.replaceAll("_", " "), known?.unit ?? track.unit, parts,
      known ? () => plot(`${what}s.${this.link.name}.${field}`) : null);
    this.rows.push({ track, reading, values: new Array<number>(track.components).fill(0) });
  }

  private end(body: number, selection: Selection): Node {
    const name = body === WORLD ? "world" : this.recording.bodies[body].name;
    if (body === WORLD) return element("span", {}, name);
    return textButton(() => selection.selectBody(body), name);
  }
}
