// Bytes and texts in the memory of a WebAssembly module.

import type { ModuleMemoryFunctions } from './module_types.js';

export class ModuleMemory {
  private view_: DataView = new DataView(new ArrayBuffer(0));
  private shared_ = new Uint8Array(0);

  constructor(private readonly module_: ModuleMemoryFunctions) {}

  /** All of the memory. Another object whenever it has grown. */
  get bytes(): Uint8Array {
    const { HEAPU8: bytes, wasmMemory: memory } = this.module_;
    if (!memory || memory.buffer === bytes.buffer) return bytes;
    if (this.shared_.buffer !== memory.buffer) this.shared_ = new Uint8Array(memory.buffer);
    return this.shared_;
  }

  get view(): DataView {
    const { buffer } = this.bytes;
    if (this.view_.buffer !== buffer) this.view_ = new DataView(buffer);
    return this.view_;
  }

  copy(at: number, size: number): Uint8Array<ArrayBuffer> {
    return this.bytes.slice(at, at + size);
  }

  /** A text that ends with a zero. */
  text(at: number): string {
    // Shared memory is not decoded, so it is copied.
    return new TextDecoder().decode(this.bytes.slice(at, this.bytes.indexOf(0, at)));
  }

  /** The address; 0 where there is no memory left. */
  tryAllocate(size: number): number {
    return this.module_._malloc(Math.max(1, size));
  }

  allocate(size: number): number {
    const at = this.tryAllocate(size);
    if (at === 0) throw new Error('The engine has no memory left.');
    return at;
  }

  free(at: number): void {
    this.module_._free(at);
  }

  withBytes<T>(bytes: Uint8Array, use: (at: number) => T): T {
    const at = this.allocate(bytes.length);
    try {
      this.bytes.set(bytes, at);
      return use(at);
    } finally {
      this.free(at);
    }
  }

  withTexts<T>(texts: readonly string[], use: (at: readonly number[]) => T, at: readonly number[] = []): T {
    const [first, ...others] = texts;
    if (first === undefined) return use(at);
    const bytes = new TextEncoder().encode(`${first}\0`);
    return this.withBytes(bytes, (one) => this.withTexts(others, use, [...at, one]));
  }
}
