// Numbers over time, kept as the whole numbers they were packed in.

import { codeOfNaN, type Codes } from "./coding";
import type { Numbers, Track } from "./recording";

/** A track of a page: value = base + code * step, each row and component with its own. */
export class PackedTrack implements Track {
  private readonly columns: number;
  private readonly nan: number;

  /** codes: [frame * columns + row * components + component]; scale: base, step and error of all columns. */
  constructor(
    readonly name: string,
    readonly unit: string,
    readonly rows: number,
    readonly components: number,
    private readonly codes: Codes,
    private readonly scale: Float64Array,
    planes: number,
  ) {
    this.columns = rows * components;
    this.nan = codeOfNaN(planes);
  }

  at(frame: number, row: number, component: number): number {
    return this.value(frame * this.columns, row * this.components + component);
  }

  read(frame: number, row: number, out: Numbers, offset: number): void {
    const start = frame * this.columns;
    const first = row * this.components;
    for (let k = 0; k < this.components; k++) out[offset + k] = this.value(start, first + k);
  }

  error(row: number, component: number): number {
    return this.scale[2 * this.columns + row * this.components + component];
  }

  private value(start: number, column: number): number {
    const code = this.codes[start + column];
    return code === this.nan ? NaN : this.scale[column] + code * this.scale[this.columns + column];
  }
}
