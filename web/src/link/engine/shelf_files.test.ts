import { expect, it } from 'vitest';
import { ShelfFiles, type EngineFiles, type KeptFile } from './shelf_files';

/** Files of an engine, in memory. */
class Files implements EngineFiles {
  readonly all = new Map<string, { content: Uint8Array; mtime: Date }>();
  time = 0;
  mkdirTree(): void {}
  writeFile(path: string, content: Uint8Array | string): void {
    const bytes = typeof content === 'string' ? new TextEncoder().encode(content) : content;
    this.all.set(path, { content: bytes, mtime: new Date(++this.time) });
  }
  readFile(path: string): Uint8Array {
    return this.all.get(path)!.content;
  }
  readdir(folder: string): string[] {
    const names = [...this.all.keys()].filter((path) => path.startsWith(`${folder}/`));
    return ['.', '..', ...new Set(names.map((path) => path.slice(folder.length + 1).split('/')[0]!))];
  }
  stat(path: string): { size: number; mtime: Date; mode: number } {
    const found = this.all.get(path);
    return { size: found?.content.length ?? 0, mtime: found?.mtime ?? new Date(0), mode: found ? 1 : 0 };
  }
  isFile(mode: number): boolean {
    return mode === 1;
  }
  unlink(path: string): void {
    this.all.delete(path);
  }
  utime(path: string, _: number, changed: number): void {
    this.all.get(path)!.mtime = new Date(changed);
  }
}

class Store {
  readonly rows = new Map<string, KeptFile>();
  writes = 0;
  async all(): Promise<KeptFile[]> {
    return [...this.rows.values()];
  }
  async put(file: KeptFile): Promise<void> {
    this.writes += 1;
    this.rows.set(file.path, file);
  }
  async remove(path: string): Promise<void> {
    this.rows.delete(path);
  }
}

const kFolders = ['/takes', '/takes/removed'];

it('keeps what is new, changed, moved and gone, and nothing twice', async () => {
  const [files, store] = [new Files(), new Store()];
  const shelf = new ShelfFiles(files, store, kFolders);
  await shelf.load();
  files.writeFile('/takes/a.take', 'one');
  files.writeFile('/takes/b.take', 'two');
  await shelf.save();
  await shelf.save();
  expect(store.writes).toBe(2);
  files.writeFile('/takes/a.take', 'more');
  files.writeFile('/takes/removed/b.take', files.readFile('/takes/b.take'));
  files.unlink('/takes/b.take');
  await shelf.save();
  expect([...store.rows.keys()].sort()).toEqual(['/takes/a.take', '/takes/removed/b.take']);
  expect(new TextDecoder().decode(store.rows.get('/takes/a.take')!.bytes)).toBe('more');
});

it('brings everything back with its time, and writes none of it again', async () => {
  const [before, store] = [new Files(), new Store()];
  const first = new ShelfFiles(before, store, kFolders);
  before.writeFile('/takes/a.take', 'one');
  before.utime('/takes/a.take', 5000, 5000);
  await first.save();
  const after = new Files();
  const second = new ShelfFiles(after, store, kFolders);
  await second.load();
  expect(after.stat('/takes/a.take')).toEqual({ size: 3, mtime: new Date(5000), mode: 1 });
  await second.save();
  expect(store.writes).toBe(1);
});
