// The world of the server as it was last, so that the engine beside the page can go on with it (docs/protocol.md, "Handover").

/** Bytes of a handover's head: magic, version, world, bytes of the take before it, bytes of the take, bytes of the rest. */
const kHeadBytes = 32;
const kMagic = 'MUSTHAND';
const kVersion = 1;

interface Head {
  readonly world: number;
  readonly takeFrom: number;
  readonly takeBytes: number;
  readonly restBytes: number;
}

function headOf(bytes: Uint8Array): Head {
  if (bytes.length < kHeadBytes) throw new Error('a handover ends in its head');
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const magic = String.fromCharCode(...bytes.subarray(0, kMagic.length));
  if (magic !== kMagic || view.getUint32(8, true) !== kVersion) throw new Error('found no handover of this version');
  const head = {
    world: view.getUint32(12, true),
    takeFrom: Number(view.getBigUint64(16, true)),
    takeBytes: view.getUint32(24, true),
    restBytes: view.getUint32(28, true),
  };
  if (kHeadBytes + head.takeBytes + head.restBytes !== bytes.length) throw new Error('a handover ends early');
  return head;
}

/** Puts handovers together: each brings what is new of the take, and all the rest each time. */
export class KeptWorld {
  private world_ = 0;
  private take_: Uint8Array[] = [];
  private takeBytes_ = 0;
  private rest_: Uint8Array | null = null;

  /** What a request for the next handover says. */
  get query(): string {
    return `handover?world=${this.world_}&take=${this.takeBytes_}`;
  }

  get known(): boolean {
    return this.rest_ !== null;
  }

  /** Throws, keeping what was there, where the bytes are no handover that goes on from it. */
  add(bytes: Uint8Array): void {
    const { world, takeFrom, takeBytes } = headOf(bytes);
    if (takeFrom !== 0 && (world !== this.world_ || takeFrom !== this.takeBytes_)) {
      throw new Error('a handover goes on from something else');
    }
    if (takeFrom === 0) this.take_ = [];
    const take = bytes.subarray(kHeadBytes, kHeadBytes + takeBytes);
    if (take.length > 0) this.take_.push(take.slice());
    this.world_ = world;
    this.takeBytes_ = takeFrom + takeBytes;
    this.rest_ = bytes.slice(kHeadBytes + takeBytes);
  }

  /** The whole handover; null where there was none. */
  whole(): Uint8Array<ArrayBuffer> | null {
    if (!this.rest_) return null;
    const all = new Uint8Array(kHeadBytes + this.takeBytes_ + this.rest_.length);
    const view = new DataView(all.buffer);
    all.set([...kMagic].map((letter) => letter.charCodeAt(0)));
    view.setUint32(8, kVersion, true);
    view.setUint32(12, this.world_, true);
    view.setUint32(24, this.takeBytes_, true);
    view.setUint32(28, this.rest_.length, true);
    let at = kHeadBytes;
    for (const piece of [...this.take_, this.rest_]) {
      all.set(piece, at);
      at += piece.length;
    }
    return all;
  }
}
