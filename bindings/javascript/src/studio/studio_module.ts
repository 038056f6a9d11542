// The WebAssembly modules of a site (apps/engine), with their functions by their names in C.

import type { ModuleFileSystem, ModuleMemoryFunctions, ModuleOptions } from '../binding/module_types.js';

/* eslint-disable @typescript-eslint/naming-convention -- The names are those of the C functions. */

/** What both modules have. */
interface AnyModule extends ModuleMemoryFunctions {
  readonly FS: ModuleFileSystem;
  /** The sentence of the last failure. */
  _muster_text(): number;
}

/** The studio's. */
export interface StudioModule extends AnyModule {
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
export interface StudioModuleOptions extends ModuleOptions {
  locateFile(name: string): string;
  /** Tells how far an export is, 0 to 1. */
  onProgress(share: number): void;
}

/** Loads a module of a folder by its name, with `engine/` of a site as the folder: 'muster-engine' or 'muster-exporter'. */
export async function loadStudioModule<Module extends AnyModule>(
  folder: string,
  name: string,
  onProgress: (share: number) => void = () => undefined,
): Promise<Module> {
  const locateFile = (file: string): string => new URL(file, folder).href;
  const { default: make } = (await import(/* @vite-ignore */ /* webpackIgnore: true */ locateFile(`${name}.js`))) as {
    default: (options: StudioModuleOptions) => Promise<Module>;
  };
  return make({ locateFile, onProgress });
}
