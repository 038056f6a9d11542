// The visitor's own character, kept in the browser so that it is there again after a reload.

import { BrowserStore, result } from '../../link/browser_store';

/** Larger characters are not kept [bytes]. */
export const kMostKept = 64 << 20;
const kRecord = 'character';

interface Kept {
  readonly name: typeof kRecord;
  readonly files: readonly { readonly name: string; readonly data: Blob }[];
}

export interface CharacterCopy {
  keep(files: readonly File[]): Promise<void>;
  /** The files that were kept last; none where there are none. */
  read(): Promise<readonly File[]>;
  forget(): Promise<void>;
}

export class OwnPeopleCopy implements CharacterCopy {
  private readonly store_: BrowserStore;

  constructor(factory?: IDBFactory) {
    this.store_ = new BrowserStore('muster-character', 'characters', factory ?? globalThis.indexedDB);
  }

  async keep(files: readonly File[]): Promise<void> {
    if (files.reduce((sum, file) => sum + file.size, 0) > kMostKept) return this.forget();
    const kept: Kept = { name: kRecord, files: files.map((file) => ({ name: file.name, data: file })) };
    await this.store_.within('readwrite', (store) => result(store.put(kept)));
  }

  async read(): Promise<readonly File[]> {
    const found = await this.store_.within('readonly', (store) =>
      result(store.get(kRecord) as IDBRequest<Kept | undefined>),
    );
    return (found?.files ?? []).map(({ name, data }) => new File([data], name));
  }

  async forget(): Promise<void> {
    await this.store_.within('readwrite', (store) => result(store.delete(kRecord)));
  }
}
