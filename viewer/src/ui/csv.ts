// A plot as text that spreadsheets read.

export interface CsvColumn {
  name: string;
  unit: string;
  values: ArrayLike<number>;
}

/** One row for each frame: the time, then the columns; what is not a number stays empty. */
export function csv(times: ArrayLike<number>, frames: number, columns: readonly CsvColumn[]): string {
  const heads = [{ name: "time", unit: "s" }, ...columns].map(head);
  const rows = [heads.join(",")];
  for (let frame = 0; frame < frames; frame++) {
    rows.push([times[frame], ...columns.map((column) => column.values[frame])].map(cell).join(","));
  }
  return `${rows.join("\r\n")}\r\n`;
}

function head(column: { name: string; unit: string }): string {
  const text = column.unit && column.unit !== "1" ? `${column.name} [${column.unit}]` : column.name;
  return /[",\r\n]/.test(text) ? `"${text.replaceAll('"', '""')}"` : text;
}

function cell(value: number): string {
  return Number.isFinite(value) ? String(Number(value.toPrecision(12))) : "";
}
