// Finds and compiles WebAssembly, in Node and in browsers.

import type { MakeModule, ModuleOptions } from './binding/module_types.js';

/** Where a module's WebAssembly is: an address, its bytes, or what WebAssembly.compile() made of them. */
export type WasmSource = URL | string | ArrayBuffer | Uint8Array<ArrayBuffer> | WebAssembly.Module;

type Instantiated = WebAssembly.WebAssemblyInstantiatedSource;

/** Bundlers must not look for it: only Node has it. */
const kNodeFiles = 'node:fs/promises';

async function fileBytes(address: URL): Promise<Uint8Array<ArrayBuffer>> {
  const { readFile } = (await import(/* @vite-ignore */ /* webpackIgnore: true */ kNodeFiles)) as {
    readFile(path: URL): Promise<Uint8Array<ArrayBuffer>>;
  };
  return readFile(address);
}

async function fetched(address: URL, imports: WebAssembly.Imports): Promise<Instantiated> {
  const answer = await fetch(address);
  if (!answer.ok) throw new Error(`${address.href}: ${answer.status} ${answer.statusText}`.trim());
  // Some servers know no type for these files: they are compiled once they are there.
  const streams = answer.headers.get('Content-Type')?.startsWith('application/wasm');
  return streams
    ? WebAssembly.instantiateStreaming(answer, imports)
    : WebAssembly.instantiate(await answer.arrayBuffer(), imports);
}

/** An instance of what is there. */
export async function instantiate(source: WasmSource, imports: WebAssembly.Imports): Promise<WebAssembly.Instance> {
  if (source instanceof WebAssembly.Module) return WebAssembly.instantiate(source, imports);
  if (source instanceof ArrayBuffer || ArrayBuffer.isView(source))
    return (await WebAssembly.instantiate(source, imports)).instance;
  const base = (globalThis as { readonly location?: { readonly href: string } }).location?.href;
  const address = source instanceof URL ? source : new URL(source, base);
  if (address.protocol !== 'file:') return (await fetched(address, imports)).instance;
  return (await WebAssembly.instantiate(await fileBytes(address), imports)).instance;
}

/** A module with the instance that `instantiated` makes. Throws why it cannot be had. */
export function loadModule<Module>(
  make: MakeModule<Module>,
  instantiated: (imports: WebAssembly.Imports) => Promise<WebAssembly.Instance>,
  parts: ModuleOptions = {},
): Promise<Module> {
  return new Promise((done, failed) => {
    make({
      ...parts,
      instantiateWasm: (imports, use) => {
        instantiated(imports).then(use).catch(failed);
        return {};
      },
    }).then(done, failed);
  });
}
