// The files of a module, which lie in its memory: paths begin with "/".

import { Status } from './generated/enums.js';
import { MusterError, shown } from './muster_error.js';
import type { ModuleFileSystem } from './binding/module_types.js';

/** What the numbers of failures mean; those of emscripten's C library. */
const kReasons: Readonly<Record<number, string>> = {
  20: 'exists already',
  31: 'is a folder',
  44: 'there is no such file or folder',
  54: 'is no folder',
  55: 'is not empty',
};

function reasonOf(error: unknown): string {
  const number = (error as { readonly errno?: number }).errno;
  return kReasons[number ?? 0] ?? `failed (${number ?? String(error)})`;
}

export class ModuleFiles {
  /** @internal */
  constructor(private readonly files_: ModuleFileSystem) {}

  /** Writes a file, in folders that are made where they are missing. */
  write(path: string, content: Uint8Array | string): void {
    const folder = path.replace(/\/[^/]*$/, '');
    this.attempt(path, () => {
      if (folder && folder !== path) this.files_.mkdirTree(folder);
      this.files_.writeFile(path, content);
    });
  }

  read(path: string): Uint8Array<ArrayBuffer> {
    return this.attempt(path, () => this.files_.readFile(path).slice());
  }

  readText(path: string): string {
    return new TextDecoder().decode(this.read(path));
  }

  /** All files below a folder, by their paths in it: an export as bvh makes a folder. */
  readFolder(path: string): Record<string, Uint8Array<ArrayBuffer>> {
    const found: Record<string, Uint8Array<ArrayBuffer>> = {};
    const visit = (folder: string, within: string): void => {
      for (const name of this.list(folder)) {
        if (this.isFolder(`${folder}/${name}`)) visit(`${folder}/${name}`, `${within}${name}/`);
        else found[within + name] = this.read(`${folder}/${name}`);
      }
    };
    visit(path, '');
    return found;
  }

  /** Names in a folder, sorted. */
  list(path: string): string[] {
    const names = this.attempt(path, () => this.files_.readdir(path));
    return names.filter((name) => name !== '.' && name !== '..').sort();
  }

  exists(path: string): boolean {
    try {
      this.files_.stat(path);
      return true;
    } catch {
      return false;
    }
  }

  isFolder(path: string): boolean {
    return this.attempt(path, () => this.files_.isDir(this.files_.stat(path).mode));
  }

  /** Removes a file, or a folder with all that is in it. */
  remove(path: string): void {
    if (!this.isFolder(path)) return this.attempt(path, () => this.files_.unlink(path));
    for (const name of this.list(path)) this.remove(`${path}/${name}`);
    this.attempt(path, () => this.files_.rmdir(path));
  }

  private attempt<T>(path: string, action: () => T): T {
    if (typeof path !== 'string')
      throw new MusterError(Status.InvalidArgument, `path: found ${shown(path)}, expected a text`);
    try {
      return action();
    } catch (error) {
      throw new MusterError(Status.IoError, `${path}: ${reasonOf(error)}`);
    }
  }
}
