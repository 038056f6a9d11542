// The library as one object.

import type { LogFunction } from './binding/callbacks.js';
import { Invoker } from './binding/invoker.js';
import type { MakeModule, MusterModule } from './binding/module_types.js';
import { kHandleClasses, MusterFunctions } from './generated/verbs.js';
import { instantiate, loadModule, type WasmSource } from './load_module.js';
import { ModuleFiles } from './module_files.js';
import { SqlFiles, type SqlLibrary } from './sql_files.js';
import makeModule from 'muster-module';

export class Muster extends MusterFunctions {
  /** The module's files: what is read and written by path lies there. */
  readonly files: ModuleFiles;

  /** @internal */
  constructor(module: MusterModule) {
    super(new Invoker(module, kHandleClasses));
    this.files = new ModuleFiles(module.FS);
  }

  /** Sends messages to a function from now on; null for none, as at first. */
  setLog(action: LogFunction | null): void {
    this.invoke_.setLog(action);
  }

  /** The memory that the module has taken [bytes]. It does not shrink. */
  memorySize(): number {
    return this.invoke_.memory.bytes.length;
  }
}

export interface LoadOptions {
  /** Where muster.wasm is; beside this file where it is not given. A compiled module can be shared with workers. */
  readonly wasm?: WasmSource | undefined;
  /** SQLite for exports for JuPedSim: `await initSqlJs()` of the package sql.js. Without it they fail with `Unsupported`. */
  readonly sqlite?: SqlLibrary | undefined;
}

/** Loads the library. Each call gives a library with a memory of its own. */
export async function loadMuster({ wasm, sqlite }: LoadOptions = {}): Promise<Muster> {
  const make = makeModule as MakeModule<MusterModule>;
  const source = wasm ?? new URL('./muster.wasm', import.meta.url);
  const module = await loadModule(make, (imports) => instantiate(source, imports), {
    // The library prints nothing; what stops it is thrown.
    print: () => undefined,
    printErr: () => undefined,
    ...(sqlite ? { sql: new SqlFiles(sqlite) } : {}),
  });
  return new Muster(module);
}
