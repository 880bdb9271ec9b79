// A line plot over time on two canvases: the lines, drawn when they change, and above them the cursor.

import { nearestFrame, range, trace, type Window } from "./curve";
import { element } from "./dom";
import { quantity, superscript, unitInPrint } from "./format";
import { stroke, type Stroke } from "./palette";
import { ticks, withAir, type Ticks } from "./ticks";

export interface Line {
  name: string;
  unit: string;
  values: Float64Array;
  /** No value is off by more; 0 or NaN: not known. */
  error: number;
  stroke: number;
  shown: boolean;
}

interface Box {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

const MARGIN = { top: 22, right: 12, bottom: 32 };
/** A plot shows no shorter time than so many frames take. */
const LEAST_FRAMES = 4;
const FONT = "11px system-ui, sans-serif";

export class Plot {
  readonly element = element("div", { class: "plot" });
  /** Called with the time that was clicked or dragged to. */
  onSeek: (time: number) => void = () => undefined;
  private readonly paper = element("canvas", { "aria-hidden": "true" });
  private readonly glass = element("canvas", { role: "img" });
  private readonly tip = element("div", { class: "plot-tip", hidden: true });
  private lines: readonly Line[] = [];
  private times: Float64Array = new Float64Array(0);
  private frames = 0;
  private time = 0;
  private hover: number | null = null;
  private box: Box = { left: 50, top: MARGIN.top, right: 100, bottom: 100 };
  private across: [number, number] = [0, 1];
  /** The times that somebody zoomed to, null: all. */
  private zoomed: [number, number] | null = null;
  private upright: [number, number] = [0, 1];
  /** As of the last drawing: to ask for it costs layout. */
  private ink: Ink = { text: "", faint: "", rule: "", accent: "", dark: false };

  constructor(name: string) {
    this.element.append(this.paper, this.glass, this.tip);
    this.glass.setAttribute("aria-label", name);
    new ResizeObserver(() => this.draw()).observe(this.element);
    this.listen();
  }

  setData(times: Float64Array, frames: number, lines: readonly Line[]): void {
    this.times = times;
    this.frames = frames;
    this.lines = lines;
    this.draw();
  }

  setTime(time: number): void {
    if (time === this.time) return;
    this.time = time;
    this.drawCursor();
  }

  /** Draws everything anew: other lines, other size, other colours. */
  draw(): void {
    const context = sized(this.paper, this.element);
    if (!context) return;
    const shown = this.lines.filter((line) => line.shown);
    this.ink = inkOf(this.element);
    this.across = this.zoomed ?? this.whole();
    this.upright = withAir(...this.heights(shown));
    this.drawAxes(context, shown[0]?.unit ?? "");
    this.drawLines(context, shown);
    this.drawCursor();
  }

  private whole(): [number, number] {
    const start = this.times[0] ?? 0;
    const end = this.times[this.frames - 1] ?? 1;
    return [start, end > start ? end : start + 1];
  }

  /** Lowest and highest of what is seen. */
  private heights(shown: readonly Line[]): [number, number] {
    const rows = shown.map((line) => line.values);
    if (!this.zoomed) return range(rows, 0, this.frames);
    const [from, to] = this.zoomed.map((time) => nearestFrame(this.times, this.frames, time));
    return range(rows, from, to + 1);
  }

  /** Nearer by a factor about a time that stays where it is; all when that is more than there is. */
  private zoom(time: number, factor: number): void {
    const [start, end] = this.whole();
    const from = Math.max(start, time - (time - this.across[0]) * factor);
    const to = Math.min(end, time + (this.across[1] - time) * factor);
    if (to - from < LEAST_FRAMES * ((end - start) / this.frames)) return;
    this.zoomed = from <= start && to >= end ? null : [from, to];
    this.draw();
  }

  private drawAxes(context: CanvasRenderingContext2D, unit: string): void {
    const { clientWidth: width, clientHeight: height } = this.element;
    const upright = ticks(...this.upright, (height - 54) / 34);
    const { ink } = this;
    context.font = FONT;
    const widest = Math.max(...upright.labels.map((label) => context.measureText(label).width), 12);
    this.box = { left: Math.ceil(widest) + 12, top: MARGIN.top, right: width - MARGIN.right, bottom: height - MARGIN.bottom };
    const across = ticks(...this.across, (this.box.right - this.box.left) / 70);
    context.lineWidth = 1;
    context.fillStyle = ink.faint;
    this.drawUpright(context, upright, ink.rule);
    this.drawAcross(context, across, ink.rule);
    context.fillStyle = ink.text;
    context.textAlign = "left";
    context.fillText(axisTitle(unit, upright.exponent), 4, 13);
    context.textAlign = "right";
    context.fillText(`time / ${power(across.exponent)}s`, this.box.right, height - 4);
  }

  private drawUpright(context: CanvasRenderingContext2D, marks: Ticks, rule: string): void {
    context.textAlign = "right";
    context.textBaseline = "middle";
    marks.values.forEach((value, i) => {
      const y = Math.round(this.y(value)) + 0.5;
      if (y < this.box.top - 1 || y > this.box.bottom + 1) return;
      line(context, this.box.left, y, this.box.right, y, rule);
      context.fillText(marks.labels[i], this.box.left - 6, y);
    });
    context.textBaseline = "alphabetic";
  }

  private drawAcross(context: CanvasRenderingContext2D, marks: Ticks, rule: string): void {
    context.textAlign = "center";
    marks.values.forEach((value, i) => {
      const x = Math.round(this.x(value)) + 0.5;
      line(context, x, this.box.top, x, this.box.bottom + 4, rule);
      context.fillText(marks.labels[i], x, this.box.bottom + 15);
    });
  }

  private drawLines(context: CanvasRenderingContext2D, shown: readonly Line[]): void {
    const view: Window = { times: this.times, frames: this.frames, x: (t) => this.x(t), y: (v) => this.y(v) };
    const { dark } = this.ink;
    context.save();
    context.beginPath();
    context.rect(this.box.left, this.box.top - 2, this.box.right - this.box.left + 1, this.box.bottom - this.box.top + 4);
    context.clip();
    context.lineWidth = 1.75;
    context.lineJoin = "round";
    for (const one of shown) {
      const { dash, ...ink }: Stroke = stroke(one.stroke);
      context.strokeStyle = dark ? ink.dark : ink.light;
      context.setLineDash([...dash]);
      context.beginPath();
      trace(context, view, one.values);
      context.stroke();
    }
    context.restore();
  }

  private drawCursor(): void {
    const context = sized(this.glass, this.element);
    if (!context || !this.frames) return;
    if (this.time >= this.across[0] && this.time <= this.across[1]) this.drawNow(context);
    if (this.hover !== null) this.drawHover(context, this.hover);
  }

  private drawNow(context: CanvasRenderingContext2D): void {
    const { ink } = this;
    const x = this.x(this.time);
    context.lineWidth = 1.5;
    line(context, x, this.box.top, x, this.box.bottom, ink.accent);
    context.fillStyle = ink.accent;
    context.beginPath();
    context.moveTo(x - 5, this.box.top - 6);
    context.lineTo(x + 5, this.box.top - 6);
    context.lineTo(x, this.box.top + 1);
    context.fill();
  }

  private drawHover(context: CanvasRenderingContext2D, frame: number): void {
    const { ink } = this;
    const x = this.x(this.times[frame]);
    context.setLineDash([3, 3]);
    line(context, x, this.box.top, x, this.box.bottom, ink.text);
    context.setLineDash([]);
    for (const one of this.lines) {
      const value = one.values[frame];
      if (!one.shown || !Number.isFinite(value)) continue;
      const pen = stroke(one.stroke);
      context.fillStyle = ink.dark ? pen.dark : pen.light;
      context.beginPath();
      context.arc(x, this.y(value), 3.5, 0, 2 * Math.PI);
      context.fill();
    }
  }

  private listen(): void {
    let dragging = false;
    const glass = this.glass;
    glass.addEventListener("pointerdown", (event) => {
      dragging = true;
      glass.setPointerCapture(event.pointerId);
      this.onSeek(this.timeAt(event));
    });
    glass.addEventListener("pointermove", (event) => {
      this.setHover(this.timeAt(event));
      if (dragging) this.onSeek(this.timeAt(event));
    });
    glass.addEventListener("pointerup", () => (dragging = false));
    glass.addEventListener("pointercancel", () => (dragging = false));
    glass.addEventListener("pointerleave", () => this.setHover(null));
    glass.addEventListener("wheel", (event) => {
      if (!event.ctrlKey) return;
      event.preventDefault();
      this.zoom(this.timeAt(event), Math.exp(0.003 * event.deltaY));
    }, { passive: false });
    glass.addEventListener("dblclick", () => this.zoom(this.time, 1e9));
  }

  private setHover(time: number | null): void {
    const frame = time === null || !this.frames ? null : nearestFrame(this.times, this.frames, time);
    if (frame === this.hover) return;
    this.hover = frame;
    this.showTip(frame);
    this.drawCursor();
  }

  private showTip(frame: number | null): void {
    this.tip.hidden = frame === null;
    if (frame === null) return;
    const rows = this.lines
      .filter((one) => one.shown)
      .map((one) => element("div", {}, `${one.name}: ${quantity(one.values[frame], one.unit, 5, one.error)}`));
    this.tip.replaceChildren(element("strong", {}, quantity(this.times[frame], "s", 6)), ...rows);
    const x = this.x(this.times[frame]);
    const onLeft = x > (this.box.left + this.box.right) / 2;
    this.tip.style.left = onLeft ? "auto" : `${x + 10}px`;
    this.tip.style.right = onLeft ? `${this.element.clientWidth - x + 10}px` : "auto";
  }

  private timeAt(event: MouseEvent): number {
    const at = event.clientX - this.glass.getBoundingClientRect().left;
    const share = (at - this.box.left) / Math.max(1, this.box.right - this.box.left);
    return this.across[0] + Math.min(1, Math.max(0, share)) * (this.across[1] - this.across[0]);
  }

  private x(time: number): number {
    const share = (time - this.across[0]) / (this.across[1] - this.across[0]);
    return this.box.left + share * (this.box.right - this.box.left);
  }

  private y(value: number): number {
    const share = (value - this.upright[0]) / (this.upright[1] - this.upright[0]);
    return this.box.bottom - share * (this.box.bottom - this.box.top);
  }
}

interface Ink {
  text: string;
  faint: string;
  rule: string;
  accent: string;
  dark: boolean;
}

function inkOf(frame: HTMLElement): Ink {
  const style = getComputedStyle(frame);
  const of = (name: string): string => style.getPropertyValue(name).trim();
  const dark = document.documentElement.dataset.theme === "dark";
  return { text: of("--text"), faint: of("--text-faint"), rule: of("--rule"), accent: of("--accent"), dark };
}

/** The name of the axis, e.g. "×10³ J"; it stands above the labels. */
function axisTitle(unit: string, exponent: number): string {
  return `${power(exponent)}${unitInPrint(unit)}`;
}

function power(exponent: number): string {
  return exponent ? `10${superscript(exponent)} ` : "";
}

function line(context: CanvasRenderingContext2D, x: number, y: number, toX: number, toY: number, colour: string): void {
  context.strokeStyle = colour;
  context.beginPath();
  context.moveTo(x, y);
  context.lineTo(toX, toY);
  context.stroke();
}

/** An empty canvas as large as its frame, in CSS pixels; null while it is not on the page. */
function sized(canvas: HTMLCanvasElement, frame: HTMLElement): CanvasRenderingContext2D | null {
  const { clientWidth: width, clientHeight: height } = frame;
  const context = canvas.getContext("2d");
  if (!context || !width || !height) return null;
  const ratio = window.devicePixelRatio || 1;
  const [w, h] = [Math.round(width * ratio), Math.round(height * ratio)];
  if (canvas.width !== w || canvas.height !== h) {
    canvas.width = w;
    canvas.height = h;
  }
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  return context;
}
