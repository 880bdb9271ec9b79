// One plot with its heading, legend and buttons.

import type { Recording, Series } from "../recording";
import { shortNames, type Entry } from "./catalogue";
import { csv } from "./csv";
import { button, element, icon, setText, svgLine } from "./dom";
import { quantity } from "./format";
import { CLOSE, COPY } from "./icons";
import { stroke } from "./palette";
import { Plot, type Line } from "./plot";
import { nearestFrame } from "./curve";

/** Below this share of the largest a line is taken for zero and not shown at first. */
const NOTHING = 1e-12;

export class PlotCard {
  readonly element: HTMLElement;
  private readonly plot: Plot;
  private lines: Line[] = [];
  /** Lines that somebody switched on or off; the others are shown when they are not zero. */
  private readonly chosen = new Map<number, boolean>();
  private inLegend = "";
  private readonly values: HTMLElement[] = [];
  private readonly note = element("p", { class: "note", hidden: true });
  private readonly legend = element("ul", { class: "legend" });
  private readonly said = element("span", { class: "said", role: "status" });

  constructor(
    private readonly recording: Recording,
    readonly entry: Entry,
    onSeek: (time: number) => void,
    onClose: () => void,
  ) {
    this.plot = new Plot(`${entry.title} against time`);
    this.plot.onSeek = onSeek;
    this.element = element(
      "section", { class: "plot-card", "aria-label": entry.title },
      element("header", {},
        element("h3", {}, entry.title), this.said,
        button(`Copy ${entry.title} as CSV`, icon(...COPY), "", () => void this.copy()),
        button(`Close ${entry.title}`, icon(...CLOSE), "", onClose)),
      this.plot.element, this.legend, this.note,
    );
    this.read();
  }

  /** Takes the values anew: more frames came. */
  read(): void {
    const series = this.entry.names.map((name) => this.recording.series(name)).filter((one) => one !== null);
    const sizes = series.map((one) => largest(one));
    const top = Math.max(...sizes);
    const names = shortNames(this.entry.names);
    this.lines = series.map((one, i) => ({
      name: names[i], unit: one.unit, values: one.values, error: one.error || 0, stroke: i,
      shown: this.chosen.get(i) ?? (sizes[i] > NOTHING * top || series.length === 1),
    }));
    const notes = [...new Set(series.map((one) => one.note).filter(Boolean))];
    this.note.hidden = !notes.length;
    setText(this.note, notes.join(" "));
    this.plot.setData(this.recording.times, this.recording.frames, this.lines);
    const shown = this.lines.map((line) => line.shown).join();
    if (shown !== this.inLegend) this.makeLegend();
    this.inLegend = shown;
  }

  /** Moves the cursor. */
  setTime(time: number): void {
    this.plot.setTime(time);
  }

  /** The numbers beside the lines; costs layout. */
  printValues(time: number): void {
    const frames = Math.min(this.recording.frames, this.lines[0]?.values.length ?? 0);
    if (!frames) return;
    const frame = nearestFrame(this.recording.times, frames, time);
    this.lines.forEach((line, i) => setText(this.values[i], quantity(line.values[frame], line.unit, 5, line.error)));
  }

  redraw(): void {
    this.plot.draw();
    this.makeLegend();
  }

  private makeLegend(): void {
    const dark = document.documentElement.dataset.theme === "dark";
    const old = this.values.map((value) => value.textContent ?? "");
    this.values.length = 0;
    this.legend.replaceChildren(...this.lines.map((line, i) => {
      const pen = stroke(line.stroke);
      const value = element("output", { "aria-live": "off" }, old[i] ?? "");
      this.values.push(value);
      const box = element("input", { type: "checkbox" });
      box.checked = line.shown;
      box.addEventListener("change", () => {
        this.chosen.set(i, box.checked);
        this.lines[i].shown = box.checked;
        this.plot.draw();
      });
      return element("li", {}, element("label", {},
        box, svgLine(30, 10, dark ? pen.dark : pen.light, pen.dash), element("span", {}, line.name), value));
    }));
  }

  private async copy(): Promise<void> {
    const columns = this.entry.names.map((name, i) => ({ name, unit: this.lines[i].unit, values: this.lines[i].values }));
    const text = csv(this.recording.times, this.recording.frames, columns);
    try {
      await navigator.clipboard.writeText(text);
      setText(this.said, "copied");
      window.setTimeout(() => setText(this.said, ""), 2000);
    } catch {
      this.offer(text);
    }
  }

  /** Browsers that do not let pages write to the clipboard: the text itself, selected. */
  private offer(text: string): void {
    const area = element("textarea", { readonly: true, rows: 12, "aria-label": "CSV text" });
    area.value = text;
    const box = element("dialog", { class: "sheet" }, element("h2", {}, "CSV text"), area);
    box.append(button("Close", "Close", "", () => box.close()));
    box.addEventListener("close", () => box.remove());
    this.element.append(box);
    box.showModal();
    area.select();
  }
}

function largest(series: Series): number {
  let top = 0;
  for (const value of series.values) if (Math.abs(value) > top) top = Math.abs(value);
  return top;
}
