// Memory for the time of one call, taken from one block and given back at once. Calls may nest.

import { Status } from '../generated/enums.js';
import { MusterError } from '../muster_error.js';
import type { ModuleMemory } from './module_memory.js';

const kBlock = 1 << 16;
/** Doubles and 64-bit integers stand at multiples of it. */
const kAlignment = 8;

export class Arena {
  private readonly block_: number;
  private top_ = 0;
  private readonly large_: number[] = [];

  constructor(private readonly memory_: ModuleMemory) {
    this.block_ = memory_.allocate(kBlock);
  }

  /** Zeroed bytes. */
  take(size: number): number {
    const rounded = Math.ceil(size / kAlignment) * kAlignment;
    const at = this.top_ + rounded <= kBlock ? this.block_ + this.top_ : this.takeLarge(rounded);
    if (at === this.block_ + this.top_) this.top_ += rounded;
    this.memory_.bytes.fill(0, at, at + rounded);
    return at;
  }

  /** Gives back what is taken during `use`. */
  within<T>(use: () => T): T {
    const [top, large] = [this.top_, this.large_.length];
    try {
      return use();
    } finally {
      this.top_ = top;
      for (const at of this.large_.splice(large)) this.memory_.free(at);
    }
  }

  private takeLarge(size: number): number {
    const at = this.memory_.tryAllocate(size);
    if (at === 0)
      throw new MusterError(
        Status.OutOfMemory,
        `what is given takes ${size} bytes, and the module has no memory left for them`,
      );
    this.large_.push(at);
    return at;
  }
}
