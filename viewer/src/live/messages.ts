// Messages of a run that is watched, as physsim/view/live/wire.py writes them.

export interface Message {
  readonly kind: "frame" | "end" | "whole" | "alive";
  readonly facts: Readonly<Record<string, unknown>>;
  readonly arrays: readonly NamedArray[];
}

export interface NamedArray {
  readonly name: string;
  readonly values: Float64Array | Int32Array | Uint8Array;
}

interface Head {
  readonly kind: Message["kind"];
  readonly facts: Readonly<Record<string, unknown>>;
  readonly arrays: readonly (readonly [name: string, type: string, shape: readonly number[]])[];
}

/** All messages of a stream as they come; one that is cut off is left out. */
export async function* messagesOf(stream: ReadableStream<Uint8Array>): AsyncGenerator<Message> {
  const source = new Source(stream.getReader());
  for (;;) {
    const lengths = await source.take(8);
    if (!lengths) return;
    const view = new DataView(lengths.buffer);
    const head = view.getUint32(0, true);
    const body = view.getUint32(4, true);
    const data = await source.take(head + body);
    if (!data) return;
    yield messageOf(data, head);
  }
}

function messageOf(data: Uint8Array<ArrayBuffer>, length: number): Message {
  const head = JSON.parse(new TextDecoder().decode(data.subarray(0, length))) as Head;
  let start = length;
  const arrays = head.arrays.map(([name, type, shape]) => {
    const count = shape.reduce((product, size) => product * size, 1);
    const [values, bytes] = arrayOf(data.buffer, type, start, count);
    start += 8 * Math.ceil(bytes / 8);
    return { name, values };
  });
  return { kind: head.kind, facts: head.facts, arrays };
}

/** An array that begins at a multiple of 8, and how many bytes it takes in the message. */
function arrayOf(buffer: ArrayBuffer, type: string, start: number, count: number): [NamedArray["values"], number] {
  switch (type) {
    case "<f8":
      return [new Float64Array(buffer, start, count), 8 * count];
    case "<i8":
      return [Float64Array.from(new BigInt64Array(buffer, start, count), Number), 8 * count];
    case "<i4":
      return [new Int32Array(buffer, start, count), 4 * count];
    case "|i1":
    case "|u1":
    case "|b1":
      return [new Uint8Array(buffer, start, count), count];
    default:
      throw new Error(`the run sends numbers of the unknown type ${type}`);
  }
}

/** A stream in pieces of the size that is asked for. */
class Source {
  private rest: Uint8Array = new Uint8Array(0);

  constructor(private readonly reader: ReadableStreamDefaultReader<Uint8Array>) {}

  /** So many bytes in a buffer of their own; null when the stream ends before. */
  async take(size: number): Promise<Uint8Array<ArrayBuffer> | null> {
    const taken = new Uint8Array(size);
    let filled = 0;
    while (filled < size) {
      if (!this.rest.length) {
        const { done, value } = await this.reader.read();
        if (done) return null;
        this.rest = value;
      }
      const part = this.rest.subarray(0, size - filled);
      taken.set(part, filled);
      filled += part.length;
      this.rest = this.rest.subarray(part.length);
    }
    return taken;
  }
}
