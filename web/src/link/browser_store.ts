// A list of records in the browser's database. Nothing here fails: without a database nothing is kept.

export function result<T>(request: IDBRequest<T>): Promise<T> {
  return new Promise((done, fail) => {
    request.onsuccess = () => done(request.result);
    request.onerror = () => fail(request.error ?? new Error('the browser keeps nothing'));
  });
}

/** Records with a `name`, which is their key. */
export class BrowserStore {
  constructor(
    private readonly database_: string,
    private readonly store_: string,
    private readonly factory_: IDBFactory | undefined = globalThis.indexedDB,
  ) {}

  /** What `work` does with the list; null where the browser has none, or refuses. */
  async within<T>(mode: IDBTransactionMode, work: (store: IDBObjectStore) => Promise<T>): Promise<T | null> {
    if (!this.factory_) return null;
    try {
      const opening = this.factory_.open(this.database_, 1);
      opening.onupgradeneeded = () => opening.result.createObjectStore(this.store_, { keyPath: 'name' });
      const database = await result(opening);
      try {
        return await work(database.transaction(this.store_, mode).objectStore(this.store_));
      } finally {
        database.close();
      }
    } catch {
      return null;
    }
  }
}
