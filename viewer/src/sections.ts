// The data sections of a page: base64, zlib, and then numbers.

import { decoded, type Codes } from "./coding";
import type { SectionHead, SectionNumber } from "./head";

/** Opens sections by their number. */
export interface Sections {
  codes(section: SectionNumber): Promise<Codes>;
  doubles(section: SectionNumber): Promise<Float64Array>;
  floats(section: SectionNumber): Promise<Float32Array>;
  wholes(section: SectionNumber): Promise<Uint32Array>;
}

/** Sections that stand in a document as `<script id="section-N">`; each is taken out once it was read. */
export class DocumentSections implements Sections {
  constructor(
    private readonly heads: readonly SectionHead[],
    private readonly document: Document = window.document,
  ) {}

  async codes(section: SectionNumber): Promise<Codes> {
    const head = this.heads[section];
    if (head.kind !== "coded") throw new Error("a section of the page is not what it should be");
    return decoded(await this.bytes(section), head.rows, head.length, head.planes);
  }

  async doubles(section: SectionNumber): Promise<Float64Array> {
    return new Float64Array((await this.plain(section, 8)).buffer);
  }

  async floats(section: SectionNumber): Promise<Float32Array> {
    return new Float32Array((await this.plain(section, 4)).buffer);
  }

  async wholes(section: SectionNumber): Promise<Uint32Array> {
    return new Uint32Array((await this.plain(section, 4)).buffer);
  }

  /** Bytes of numbers of `size` bytes each, which stand as all first bytes, all second bytes, and so on. */
  private async plain(section: SectionNumber, size: number): Promise<Uint8Array<ArrayBuffer>> {
    const planes = await this.bytes(section);
    const count = planes.length / size;
    if (count !== this.heads[section].length) throw new Error("a section of the page is incomplete");
    const numbers = new Uint8Array(planes.length);
    for (let plane = 0; plane < size; plane++) {
      for (let k = 0; k < count; k++) numbers[k * size + plane] = planes[plane * count + k];
    }
    return numbers;
  }

  private async bytes(section: SectionNumber): Promise<Uint8Array> {
    const element = this.document.getElementById(`section-${section}`);
    if (!element) throw new Error("a section of the page is missing");
    const packed = fromBase64(element.textContent ?? "");
    element.remove();
    const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream("deflate"));
    return new Uint8Array(await new Response(stream).arrayBuffer());
  }
}

function fromBase64(text: string): Uint8Array<ArrayBuffer> {
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let k = 0; k < letters.length; k++) bytes[k] = letters.charCodeAt(k);
  return bytes;
}
