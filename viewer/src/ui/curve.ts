// Lines of thousands of numbers in a few hundred columns of pixels, without losing a peak.

/** What a plot draws; the frames of `values` are those of `times`. */
export interface Window {
  times: Float64Array;
  frames: number;
  /** Time to pixels. */
  x: (time: number) => number;
  /** Value to pixels. */
  y: (value: number) => number;
}

/** With more frames to a pixel than this, columns of pixels are drawn in place of frames. */
const CROWDED = 4;

/** Traces `values` into the current path: every frame, or where they are crowded the first, lowest, highest and last
 *  of every column of pixels. NaN breaks. */
export function trace(context: CanvasRenderingContext2D, view: Window, values: Float64Array): void {
  const { times, frames, x, y } = view;
  const crowded = frames > CROWDED * (x(times[frames - 1]) - x(times[0]));
  let column = NaN;
  let open = false;
  let low = 0;
  let high = 0;
  let last = 0;
  for (let frame = 0; frame < frames; frame++) {
    const value = values[frame];
    const at = x(times[frame]);
    if (Number.isNaN(value)) {
      if (open) close(context, column, y, low, high, last);
      open = false;
      continue;
    }
    if (crowded && open && Math.floor(at) === Math.floor(column)) {
      low = Math.min(low, value);
      high = Math.max(high, value);
      last = value;
      continue;
    }
    if (open) close(context, column, y, low, high, last);
    if (open) context.lineTo(at, y(value));
    else context.moveTo(at, y(value));
    open = true;
    column = at;
    low = high = last = value;
  }
  if (open) close(context, column, y, low, high, last);
}

function close(
  context: CanvasRenderingContext2D, x: number, y: (value: number) => number, low: number, high: number, last: number,
): void {
  if (low === high) {
    context.lineTo(x + 0.01, y(last));
    return;
  }
  context.lineTo(x, y(low));
  context.lineTo(x, y(high));
  context.lineTo(x, y(last));
}

/** Lowest and highest of several rows of numbers from one frame to before another; [NaN, NaN] when there are none.
 *  NaN and infinities do not count. */
export function range(rows: readonly Float64Array[], from: number, to: number): [number, number] {
  let low = NaN;
  let high = NaN;
  for (const row of rows) {
    for (let frame = from; frame < Math.min(to, row.length); frame++) {
      const value = row[frame];
      if (!Number.isFinite(value)) continue;
      if (!(value >= low)) low = value;
      if (!(value <= high)) high = value;
    }
  }
  return [low, high];
}

/** The frame whose time is nearest; times rise. */
export function nearestFrame(times: Float64Array, frames: number, time: number): number {
  let low = 0;
  let high = frames - 1;
  while (high - low > 1) {
    const middle = (low + high) >> 1;
    if (times[middle] <= time) low = middle;
    else high = middle;
  }
  return time - times[low] <= times[Math.max(low, high)] - time ? low : high;
}
