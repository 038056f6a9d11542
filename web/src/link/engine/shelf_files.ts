// The shelf's files outlive the page: they are read from the browser's database at the start, and what changes in the engine's
// folder is written back.

import type { ModuleFileSystem } from 'muster-engine/studio';

/** The engine's files, as far as the shelf needs them. */
export type EngineFiles = Pick<
  ModuleFileSystem,
  'mkdirTree' | 'writeFile' | 'readFile' | 'readdir' | 'stat' | 'isFile' | 'utime'
>;

/** A file with the time of its last change [ms]. */
export interface KeptFile {
  readonly path: string;
  readonly changed: number;
  readonly bytes: Uint8Array;
}

/** Where files are kept. */
export interface FileStore {
  all(): Promise<readonly KeptFile[]>;
  put(file: KeptFile): Promise<void>;
  remove(path: string): Promise<void>;
}

export class ShelfFiles {
  /** Size and time of the files as they are kept. */
  private kept_ = new Map<string, string>();

  constructor(
    private readonly files_: EngineFiles,
    private readonly store_: FileStore,
    private readonly folders_: readonly string[],
  ) {}

  /** Puts the kept files into the engine's folders. */
  async load(): Promise<void> {
    for (const folder of this.folders_) this.files_.mkdirTree(folder);
    for (const { path, changed, bytes } of await this.store_.all()) {
      this.files_.writeFile(path, bytes);
      this.files_.utime(path, changed, changed);
      this.kept_.set(path, this.stateOf(path));
    }
  }

  /** Writes what has changed since. */
  async save(): Promise<void> {
    const now = new Map<string, string>();
    for (const folder of this.folders_) for (const path of this.filesIn(folder)) now.set(path, this.stateOf(path));
    for (const [path, state] of now) {
      if (this.kept_.get(path) === state) continue;
      const { mtime } = this.files_.stat(path);
      await this.store_.put({ path, changed: mtime.getTime(), bytes: this.files_.readFile(path).slice() });
      this.kept_.set(path, state);
    }
    for (const path of [...this.kept_.keys()]) {
      if (now.has(path)) continue;
      await this.store_.remove(path);
      this.kept_.delete(path);
    }
  }

  private filesIn(folder: string): string[] {
    return this.files_
      .readdir(folder)
      .map((name) => `${folder}/${name}`)
      .filter((path) => this.files_.isFile(this.files_.stat(path).mode));
  }

  private stateOf(path: string): string {
    const { size, mtime } = this.files_.stat(path);
    return `${size} ${mtime.getTime()}`;
  }
}
