// Functions of JavaScript that the module calls. What they throw comes out of the call that they were called by.

import type { LogLevel } from '../generated/enums.js';
import type { World } from '../generated/verbs.js';
import { wrongValue } from '../muster_error.js';
import type { MusterModule } from './module_types.js';

/** Gets a message: one sentence. It must not call the library. */
export type LogFunction = (level: LogLevel, message: string) => void;

/** Gets the world after every step, to read it; false ends the replay. The world is valid during the call only. */
export type ReplayFunction = (world: World) => boolean | void;

/** Gets the share done, 0 to 1; false ends the export. */
export type ProgressFunction = (share: number) => boolean | void;

interface Kind {
  /** As emscripten writes it: what it returns, then its parameters. */
  readonly signature: string;
  /** From the C arguments behind the context to those of the function. */
  arguments(given: readonly number[]): readonly unknown[];
}

export class Callbacks {
  private thrown_: { readonly error: unknown } | null = null;
  private rethrown_: { readonly error: unknown } | null = null;
  private log_ = 0;
  private logs_ = false;

  constructor(
    private readonly module_: MusterModule,
    private readonly kinds_: Readonly<Record<string, Kind>>,
  ) {}

  /** True while the log's function runs. */
  get logs(): boolean {
    return this.logs_;
  }

  /** Makes a C function of that kind; 0 for none. */
  add(kind: string, action: unknown, place: string): number {
    if (action === null || action === undefined) return 0;
    if (typeof action !== 'function') throw wrongValue(place, action, 'a function or null');
    const { signature, arguments: argumentsOf } = this.kinds_[kind]!;
    return this.module_.addFunction((_context: number, ...given: number[]) => {
      if (this.thrown_) return 0;
      this.logs_ = kind === 'LogFunction';
      try {
        return (action as (...values: readonly unknown[]) => unknown)(...argumentsOf(given)) === false ? 0 : 1;
      } catch (error) {
        this.thrown_ = { error };
        return 0;
      } finally {
        this.logs_ = false;
      }
    }, signature);
  }

  remove(index: number): void {
    if (index !== 0) this.module_.removeFunction(index);
  }

  /** Replaces the log's function. `set` tells the library. */
  setLog(action: unknown, set: (index: number) => void): void {
    const made = this.add('LogFunction', action, 'function');
    set(made);
    this.remove(this.log_);
    this.log_ = made;
  }

  /** Throws what a function has thrown since. */
  rethrow(): void {
    const thrown = this.thrown_;
    this.thrown_ = null;
    this.rethrown_ = thrown;
    if (thrown) throw thrown.error;
  }

  /** True for what rethrow() has thrown last: it is not the module's. */
  hasThrown(error: unknown): boolean {
    return this.rethrown_ !== null && this.rethrown_.error === error;
  }
}
