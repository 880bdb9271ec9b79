// Undoes physsim/view/page/coding.py: differences along the row, zigzag, byte planes.

/** Whole numbers, `length` * `rows` of them, frame by frame: [frame * rows + row]. */
export type Codes = Uint8Array | Uint16Array | Uint32Array;

/** The table that a coded section holds. `bytes`: what zlib gave back. */
export function decoded(bytes: Uint8Array, rows: number, length: number, planes: number): Codes {
  const numbers = rows * length;
  if (bytes.length !== rows + planes * numbers) throw new Error("a section of the page is incomplete");
  const codes = emptyCodes(numbers, planes);
  const row = new Int32Array(length);
  for (let r = 0; r < rows; r++) {
    readRow(bytes, rows + r * length, numbers, planes, row);
    for (let order = bytes[r]; order > 0; order--) sumUp(row);
    const unused = 32 - 8 * planes;
    for (let t = 0, at = r; t < length; t++, at += rows) codes[at] = (row[t] << unused) >>> unused;
  }
  return codes;
}

/** The code that stands for NaN. */
export function codeOfNaN(planes: number): number {
  return 256 ** planes - 1;
}

function emptyCodes(numbers: number, planes: number): Codes {
  if (planes === 1) return new Uint8Array(numbers);
  return planes === 2 ? new Uint16Array(numbers) : new Uint32Array(numbers);
}

/** Residuals of one row: 0, 1, 2, 3 stand for 0, -1, 1, -2. */
function readRow(bytes: Uint8Array, start: number, stride: number, planes: number, row: Int32Array): void {
  for (let t = 0; t < row.length; t++) {
    let folded = bytes[start + t];
    for (let plane = 1; plane < planes; plane++) folded |= bytes[start + plane * stride + t] << (8 * plane);
    row[t] = (folded >>> 1) ^ -(folded & 1);
  }
}

/** Runs over at 32 bits, as it did when differences were taken. */
function sumUp(row: Int32Array): void {
  let sum = 0;
  for (let t = 0; t < row.length; t++) {
    sum = (sum + row[t]) | 0;
    row[t] = sum;
  }
}
