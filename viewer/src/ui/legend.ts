// What the picture means, in its corner: a scale bar with numbers, colours, force arrows, signs.

import { Vector3 } from "three";
import type { Recording } from "../recording";
import type { World } from "../world";
import { materialNumbers, PATTERNS } from "./colouring";
import { element, setText } from "./dom";
import type { ContactDrawing } from "./draw/contacts";
import { exact, quantity } from "./format";
import { paced } from "./pace";
import { viridisGradient } from "./palette";
import type { Store } from "./settings";
import { roundBelow, ticks } from "./ticks";

const MOST_MATERIALS = 8;
const LONGEST_BAR = 130;

export class Legend {
  readonly element = element("div", { class: "key", role: "group", "aria-label": "What the picture means" });
  private readonly scale = element("div", { class: "scale" });
  private readonly bar = element("span", { class: "bar-line" });
  private readonly length = element("span", {});
  private readonly colours = element("div", { class: "colours" });
  private readonly forces = element("div", { class: "forces" });
  private readonly omitted = element("div", { class: "row" });
  private readonly eye = new Vector3();
  private readonly measure = paced(() => this.printScale(), 150);

  constructor(
    private readonly recording: Recording,
    private readonly world: World,
    private readonly store: Store,
    private readonly contacts: ContactDrawing,
  ) {
    this.scale.append(this.bar, this.length);
    this.scale.title = "Length at the point that the camera turns about";
    const cell = element("div", { class: "row" }, element("span", { class: "sign cell" }), `grid: ${inMetres(world.gridCell)}`);
    this.element.append(this.colours, this.forces, cell, this.scale);
    store.watch(["grid"], () => (cell.hidden = !store.now.grid));
    store.watch(["colouring"], () => this.printColours());
    store.watch(["contacts", "arrowSize"], () => this.printForces());
    world.onFrame(() => this.measure());
    recording.onGrowth(paced(() => {
      this.printColours();
      this.printForces();
    }, 1000));
  }

  /** A round length at the point that the camera turns about, as long as it looks there. */
  private printScale(): void {
    const { camera, controls, canvas, unit } = this.world;
    const distance = this.eye.copy(camera.position).distanceTo(controls.target);
    const pixels = (canvas.clientHeight * camera.projectionMatrix.elements[5]) / 2 / distance / unit;
    if (!(pixels > 0) || !Number.isFinite(pixels)) return;
    const length = roundBelow(LONGEST_BAR / pixels);
    this.bar.style.width = `${(length * pixels).toFixed(1)}px`;
    setText(this.length, inMetres(length));
    this.omitted.hidden = this.contacts.omitted === 0;
    setText(this.omitted, `${this.contacts.omitted} weaker ones are not in this page`);
  }

  private printColours(): void {
    const { colouring } = this.store.now;
    if (colouring === "material") this.colours.replaceChildren(...this.materials());
    else if (colouring === "speed") this.colours.replaceChildren(...this.speeds());
    else this.colours.replaceChildren("colours and patterns: one body each, in turn");
  }

  private materials(): HTMLElement[] {
    const numbers = materialNumbers(this.recording);
    const rows = [...numbers].slice(0, MOST_MATERIALS).map(([material, n]) => {
      const swatch = element("span", { class: `swatch pattern-${n % PATTERNS}` });
      const colour = this.recording.placed.find((placed) => placed.material === material)?.colour ?? "";
      swatch.style.setProperty("--swatch", colour);
      return element("div", { class: "row" }, swatch, material || "no material");
    });
    if (numbers.size > MOST_MATERIALS) rows.push(element("div", { class: "row" }, `and ${numbers.size - MOST_MATERIALS} more`));
    return rows;
  }

  private speeds(): HTMLElement[] {
    const top = this.recording.topSpeed || 1;
    const marks = ticks(0, top, 4);
    const strip = element("div", { class: "strip" });
    strip.style.background = viridisGradient();
    const labels = marks.values.map((value, i) => {
      const label = element("span", {}, marks.labels[i]);
      label.style.left = `${(100 * value) / top}%`;
      return label;
    });
    const unit = marks.exponent ? `speed / ${quantity(10 ** marks.exponent, "m s-1", 1)}` : "speed / (m/s)";
    return [element("div", {}, unit), strip, element("div", { class: "strip-labels" }, ...labels)];
  }

  private printForces(): void {
    this.forces.hidden = !this.store.now.contacts;
    if (this.forces.hidden) return;
    const { length, force, longest } = this.contacts.forceScale;
    this.forces.replaceChildren(
      sign("sticks", "contact that sticks"),
      sign("slides", "contact that slides"),
      sign("arrow", `${inMetres(length)} of arrow: ${exact(force)}\u202fN`),
      sign("arrow cut", `thick: stronger, cut at ${inMetres(longest)}`),
      this.omitted,
    );
  }
}

function sign(kind: string, text: string): HTMLElement {
  return element("div", { class: "row" }, element("span", { class: `sign ${kind}` }), text);
}

/** 5 mm, 20 cm, 1 m, 200 km: round numbers need no powers of ten. */
export function inMetres(length: number): string {
  const units: [number, string][] = [[1e3, "km"], [1, "m"], [1e-2, "cm"], [1e-3, "mm"], [1e-6, "µm"]];
  const [size, name] = units.find(([one]) => length >= 0.999 * one) ?? [1e-6, "µm"];
  return `${Number((length / size).toPrecision(3))}\u202f${name}`;
}
