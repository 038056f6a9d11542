// A ZIP archive of files that are compressed already.

const kTable = Uint32Array.from({ length: 256 }, (_, start) => {
  let value = start;
  for (let bit = 0; bit < 8; ++bit) value = value & 1 ? 0xedb88320 ^ (value >>> 1) : value >>> 1;
  return value;
});

export function crc32(bytes: Uint8Array): number {
  let value = 0xffffffff;
  for (const byte of bytes) value = kTable[(value ^ byte) & 255]! ^ (value >>> 8);
  return (value ^ 0xffffffff) >>> 0;
}

/** Little-endian numbers: those of 2 bytes are given as [value]. */
function packed(...values: readonly (number | readonly [number])[]): Uint8Array<ArrayBuffer> {
  const bytes: number[] = [];
  for (const value of values) {
    const [number, count] = typeof value === 'number' ? [value, 4] : [value[0], 2];
    for (let i = 0; i < count; ++i) bytes.push((number >>> (8 * i)) & 255);
  }
  return Uint8Array.from(bytes);
}

const kVersion = 20;
const kFirstDay = 0x00210000;
/** Offsets have 32 bits. */
const kMostBytes = 0xff000000;

/** Takes files one after the other. */
export class ZipStore {
  private readonly parts_: BlobPart[] = [];
  private readonly list_: BlobPart[] = [];
  private bytes_ = 0;
  private count_ = 0;
  private listBytes_ = 0;

  /** `name` has plain letters. Throws a sentence where the archive would be too large. */
  async add(name: string, file: Blob): Promise<void> {
    if (this.bytes_ + file.size > kMostBytes) throw new Error('A ZIP holds at most 4 GB: choose a shorter part.');
    const title = new TextEncoder().encode(name);
    const crc = crc32(new Uint8Array(await file.arrayBuffer()));
    const facts = [[0], [0], kFirstDay, crc, file.size, file.size, [title.length], [0]] as const;
    const head = packed(0x04034b50, [kVersion], ...facts);
    const entry = packed(0x02014b50, [kVersion], [kVersion], ...facts, [0], [0], [0], 0, this.bytes_);
    this.parts_.push(head, title, file);
    this.list_.push(entry, title);
    this.bytes_ += head.length + title.length + file.size;
    this.listBytes_ += entry.length + title.length;
    this.count_ += 1;
  }

  finish(): Blob {
    const end = packed(0x06054b50, [0], [0], [this.count_], [this.count_], this.listBytes_, this.bytes_, [0]);
    return new Blob([...this.parts_, ...this.list_, end], { type: 'application/zip' });
  }
}
