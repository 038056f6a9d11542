// WebAssembly modules as emscripten makes them.

import type { SqlFiles } from '../sql_files.js';

/** A module's files, which lie in its memory. */
export interface ModuleFileSystem {
  mkdirTree(path: string): void;
  writeFile(path: string, content: Uint8Array | string): void;
  readFile(path: string): Uint8Array;
  readdir(path: string): string[];
  unlink(path: string): void;
  rmdir(path: string): void;
  stat(path: string): {
    readonly size: number;
    readonly mtime: Date;
    readonly mode: number;
  };
  isFile(mode: number): boolean;
  isDir(mode: number): boolean;
  utime(path: string, accessed: number, changed: number): void;
}

export interface ModuleMemoryFunctions {
  readonly HEAPU8: Uint8Array;
  /** Where threads share the memory: another one may have let it grow. */
  readonly wasmMemory?: WebAssembly.Memory;
  _malloc(size: number): number;
  _free(at: number): void;
}

export type NativeFunction = (...given: number[]) => number;

/** The module of the C API: all functions by their names, with `_` in front. */
export interface MusterModule extends ModuleMemoryFunctions {
  readonly FS: ModuleFileSystem;
  addFunction(action: (...given: number[]) => number | void, signature: string): number;
  removeFunction(index: number): void;
}

/** What emscripten asks for a module's instance. */
export interface ModuleOptions {
  instantiateWasm?(imports: WebAssembly.Imports, use: (instance: WebAssembly.Instance) => void): object;
  locateFile?(name: string): string;
  /** Prints what the C library writes to its output and its errors. */
  print?(line: string): void;
  printErr?(line: string): void;
  /** For exports as SQLite files. */
  sql?: SqlFiles;
}

export type MakeModule<Module> = (options: ModuleOptions) => Promise<Module>;
