// Bytes and texts in the memory of a WebAssembly module.

import type { ModuleMemoryFunctions } from './engine_module';

export class ModuleMemory {
  constructor(private readonly module_: ModuleMemoryFunctions) {}

  copy(at: number, size: number): Uint8Array<ArrayBuffer> {
    return this.module_.HEAPU8.slice(at, at + size);
  }

  /** A text that ends with a zero. */
  text(at: number): string {
    const { HEAPU8: heap } = this.module_;
    return new TextDecoder().decode(heap.slice(at, heap.indexOf(0, at)));
  }

  withBytes<T>(bytes: Uint8Array, use: (at: number) => T): T {
    const at = this.module_._malloc(Math.max(1, bytes.length));
    if (at === 0) throw new Error('The engine has no memory left.');
    try {
      this.module_.HEAPU8.set(bytes, at);
      return use(at);
    } finally {
      this.module_._free(at);
    }
  }

  withTexts<T>(texts: readonly string[], use: (at: readonly number[]) => T, at: readonly number[] = []): T {
    const [first, ...others] = texts;
    if (first === undefined) return use(at);
    const bytes = new TextEncoder().encode(`${first}\0`);
    return this.withBytes(bytes, (one) => this.withTexts(others, use, [...at, one]));
  }
}
