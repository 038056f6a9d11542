// The WebAssembly module of a site (apps/engine), with its functions by their names in C.

import { loadModule } from '../load_module.js';
import { SplitModule, type ModuleSource } from './split_module.js';
import type { ModuleFileSystem, ModuleMemoryFunctions, ModuleOptions } from '../binding/module_types.js';

/* eslint-disable @typescript-eslint/naming-convention -- The names are those of the C functions. */

export interface StudioModule extends ModuleMemoryFunctions {
  readonly FS: ModuleFileSystem;
  /** The sentence of the last failure. */
  _muster_text(): number;
  _muster_open(scenario: number, version: number, threads: number): number;
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
  _muster_export(order: number, path: number): number;
}

/** What exports need. */
export interface ExportParts extends Pick<ModuleOptions, 'sql'> {
  /** Tells how far it is, 0 to 1. */
  onProgress?: (share: number) => void;
}

export interface LoadedStudioModule {
  readonly module: StudioModule;
  /** Loads what is seldom used. Functions that are called before wait for it, and everything with them. */
  readonly loadRest: () => Promise<void>;
}

interface Loader<Options> {
  default(options: Options): Promise<StudioModule>;
}

const placed = (file: string, folder: string): string => new URL(file, folder).href;

/** Loads the module from a folder, `engine/` of a site. */
export async function loadStudioModule(
  folder: string,
  source: ModuleSource,
  parts: ExportParts = {},
): Promise<LoadedStudioModule> {
  const loader = import(/* @vite-ignore */ /* webpackIgnore: true */ placed('muster-engine.js', folder)) as Promise<
    Loader<ModuleOptions & ExportParts>
  >;
  const [first, rest] = ['muster-engine.wasm.xz', 'muster-engine-rest.wasm'].map((file) => placed(file, folder));
  const split = await SplitModule.load(first!, rest!, source);
  const module = await loadModule((await loader).default, (imports) => split.instantiate(imports), parts);
  return { module, loadRest: () => split.loadRest() };
}

/** Worlds of a page change: for a while there are the threads of two or three. */
const kWorlds = 3;

/** Loads the module for isolated pages, whose worlds may have so many threads. */
export async function loadThreadedModule(folder: string, threads: number): Promise<LoadedStudioModule> {
  const loader = (await import(
    /* @vite-ignore */ /* webpackIgnore: true */ placed('muster-engine-threads.js', folder)
  )) as Loader<{ locateFile(name: string): string; workers: number }>;
  const workers = kWorlds * (threads - 1);
  const module = await loader.default({ workers, locateFile: (file) => placed(file, folder) });
  return { module, loadRest: () => Promise.resolve() };
}
