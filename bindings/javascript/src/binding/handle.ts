/// <reference lib="esnext.disposable" preserve="true" />
// What classes of the binding have in common.

import type { FunctionName } from '../generated/signatures.js';
import { MusterError } from '../muster_error.js';
import { Status } from '../generated/enums.js';
import type { Invoker } from './invoker.js';
import type { Owner } from './read_out.js';

/** Calls functions that belong to no object. */
export class Caller {
  /** @internal */
  constructor(protected readonly invoke_: Invoker) {}

  protected call_(name: FunctionName, ...given: unknown[]): unknown {
    return this.invoke_.call(name, null, given);
  }
}

/** An object in the module's memory, which lives until destroy(). */
export class Handle implements Owner {
  private epoch_ = 0;

  /** @internal */
  constructor(
    /** @internal */
    readonly invoker: Invoker,
    /** @internal */
    readonly index1: number,
    /** @internal */
    readonly generation: number,
  ) {}

  /** Rises whenever what was read of it is no longer valid. */
  get epoch(): number {
    return this.epoch_;
  }

  /** @internal */
  moved(): void {
    this.epoch_ += 1;
  }

  /** For `using`: as destroy(), but nothing where it is gone already. */
  [Symbol.dispose](): void {
    const own = this as unknown as { destroy(): void };
    try {
      own.destroy();
    } catch (error) {
      if (!(error instanceof MusterError) || error.code !== Status.NotFound) throw error;
    }
  }

  protected call_(name: FunctionName, ...given: unknown[]): unknown {
    return this.invoker.call(name, this, given);
  }
}
