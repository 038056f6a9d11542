// The WebAssembly modules of apps/engine, as emscripten makes them, with their functions by their names in C.

/* eslint-disable @typescript-eslint/naming-convention -- The names are those of the C functions. */

export interface EngineFiles {
  mkdirTree(path: string): void;
  writeFile(path: string, content: Uint8Array | string): void;
  readFile(path: string): Uint8Array;
  readdir(path: string): string[];
  stat(path: string): { readonly size: number; readonly mtime: Date; readonly mode: number };
  isFile(mode: number): boolean;
  utime(path: string, accessed: number, changed: number): void;
}

export interface ModuleMemoryFunctions {
  readonly HEAPU8: Uint8Array;
  _malloc(size: number): number;
  _free(at: number): void;
}

/** What both modules have. */
interface AnyModule extends ModuleMemoryFunctions {
  readonly FS: EngineFiles;
  /** The sentence of the last failure. */
  _muster_text(): number;
}

/** The studio's. */
export interface EngineModule extends AnyModule {
  _muster_open(scenario: number, version: number): number;
  _muster_connect(): number;
  _muster_disconnect(client: number): void;
  _muster_receive(client: number, at: number, size: number): void;
  _muster_advance(seconds: number): number;
  _muster_collect(client: number): number;
  _muster_message(index: number): number;
  _muster_message_size(index: number): number;
  _muster_ask(method: number, target: number, body: number, size: number): number;
  _muster_answer(): number;
  _muster_answer_size(): number;
  _muster_answer_type(): number;
}

/** That of exports. */
export interface ExporterModule extends AnyModule {
  _muster_export(order: number, path: number): number;
}

/** What a module is given. */
export interface ModuleOptions {
  locateFile(name: string): string;
  /** Tells how far an export is, 0 to 1. */
  onProgress(share: number): void;
}

export type MakeModule<Module> = (options: ModuleOptions) => Promise<Module>;
