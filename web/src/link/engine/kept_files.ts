// Files in the browser's database. Without one nothing is kept.

import { BrowserStore, result } from '../browser_store';
import type { FileStore, KeptFile } from './shelf_files';

interface Row {
  readonly name: string;
  readonly changed: number;
  readonly bytes: Uint8Array;
}

export class KeptFiles implements FileStore {
  private readonly store_ = new BrowserStore('muster-engine', 'files');

  async all(): Promise<readonly KeptFile[]> {
    const rows = await this.store_.within('readonly', (store) => result(store.getAll() as IDBRequest<Row[]>));
    return (rows ?? []).map(({ name, changed, bytes }) => ({ path: name, changed, bytes }));
  }

  async put({ path, changed, bytes }: KeptFile): Promise<void> {
    const row: Row = { name: path, changed, bytes };
    await this.store_.within('readwrite', (store) => result(store.put(row)));
  }

  async remove(path: string): Promise<void> {
    await this.store_.within('readwrite', (store) => result(store.delete(path)));
  }
}
