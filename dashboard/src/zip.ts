// The archive of a study, of which only the files that are looked at are read: its directory first, then parts of it by `Range`.

import { ApiError, call } from "./api";

interface Entry {
  offset: number;
  size: number;
  nameLength: number;
  method: number;
}

/** The end of an archive that is read at first; the directory of a small one is in it. */
const TAIL_BYTES = 64 << 10;
/** Room for what a file's own header may have besides its name. */
const HEADER_BYTES = 30 + 256;
const [END, END_64, PLACE_64, ENTRY, FILE] = [0x06054b50, 0x06064b50, 0x07064b50, 0x02014b50, 0x04034b50];

const damaged = (): ApiError => new ApiError({ type: "about:blank", title: "The archive of the study cannot be read", status: 502 });

export class Archive {
  private constructor(
    private readonly path: string,
    private readonly etag: string,
    private readonly total: number,
    private readonly entries: Map<string, Entry>,
    private readonly signal?: AbortSignal,
  ) {}

  static async open(path: string, signal?: AbortSignal): Promise<Archive> {
    const response = await call(path, { headers: { range: `bytes=-${TAIL_BYTES}` }, cache: "no-store", signal });
    const tail = new DataView(await response.arrayBuffer());
    const etag = response.headers.get("etag") ?? "";
    const total = Number(/\/(\d+)$/.exec(response.headers.get("content-range") ?? "")?.[1] ?? tail.byteLength);
    const start = total - tail.byteLength;
    let end = tail.byteLength - 22;
    while (end >= 0 && tail.getUint32(end, true) !== END) end--;
    if (end < 0) throw damaged();
    let [count, size, offset] = [tail.getUint16(end + 10, true), tail.getUint32(end + 12, true), tail.getUint32(end + 16, true)];
    // More than 65,535 files or 4 GiB: the same numbers with 64 bits.
    if (end >= 20 && tail.getUint32(end - 20, true) === PLACE_64) {
      const at = Number(tail.getBigUint64(end - 12, true)) - start;
      if (at < 0 || tail.getUint32(at, true) !== END_64) throw damaged();
      [count, size, offset] = [at + 32, at + 40, at + 48].map((k) => Number(tail.getBigUint64(k, true))) as [number, number, number];
    }
    const archive = new Archive(path, etag, total, new Map(), signal);
    const directory = offset >= start ? new DataView(tail.buffer, offset - start, size) : new DataView(await archive.part(offset, size));
    let at = 0;
    for (let k = 0; k < count; k++) {
      if (directory.getUint32(at, true) !== ENTRY) throw damaged();
      const [nameLength, extraLength, noteLength] = [28, 30, 32].map((field) => directory.getUint16(at + field, true)) as [number, number, number];
      const name = new TextDecoder().decode(new Uint8Array(directory.buffer, directory.byteOffset + at + 46, nameLength));
      let [packed, entry] = [directory.getUint32(at + 20, true), directory.getUint32(at + 42, true)];
      const unpacked = directory.getUint32(at + 24, true);
      // What does not fit into 32 bits is in a field of its own, in this order.
      for (let field = at + 46 + nameLength; field + 4 <= at + 46 + nameLength + extraLength; ) {
        const [kind, length] = [directory.getUint16(field, true), directory.getUint16(field + 2, true)];
        let value = field + 4;
        const next = () => Number(directory.getBigUint64((value += 8) - 8, true));
        if (kind === 1) {
          if (unpacked === 0xffffffff) next();
          if (packed === 0xffffffff) packed = next();
          if (entry === 0xffffffff) entry = next();
        }
        field += 4 + length;
      }
      archive.entries.set(name, { offset: entry, size: packed, nameLength, method: directory.getUint16(at + 10, true) });
      at += 46 + nameLength + extraLength + noteLength;
    }
    return archive;
  }

  has(name: string): boolean {
    return this.entries.has(name);
  }

  names(): string[] {
    return [...this.entries.keys()];
  }

  /** The bytes of a file, which the service stores uncompressed. */
  async bytes(name: string): Promise<ArrayBuffer> {
    const entry = this.entries.get(name);
    if (entry === undefined || entry.method !== 0) throw damaged();
    const bytes = await this.part(entry.offset, HEADER_BYTES + entry.nameLength + entry.size);
    const head = new DataView(bytes);
    if (head.getUint32(0, true) !== FILE) throw damaged();
    const from = 30 + head.getUint16(26, true) + head.getUint16(28, true);
    return bytes.slice(from, from + entry.size);
  }

  async text(name: string): Promise<string> {
    return new TextDecoder().decode(await this.bytes(name));
  }

  private async part(from: number, length: number): Promise<ArrayBuffer> {
    const last = Math.min(this.total, from + length) - 1;
    const response = await call(this.path, { headers: { range: `bytes=${from}-${last}`, "if-range": this.etag }, cache: "no-store", signal: this.signal });
    const bytes = await response.arrayBuffer();
    if (response.status === 206) return bytes;
    // A server that knows no ranges sends all of it; another archive is sent whole too.
    if (response.headers.get("etag") !== this.etag) throw new ApiError({ type: "about:blank", title: "The study was computed again: open it anew", status: 409 });
    return bytes.slice(from, last + 1);
  }
}
