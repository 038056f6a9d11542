// Where the browser keeps places: its database, or memory where there is none.

export type DrawerName = 'places' | 'files' | 'scenery';
const kDrawers: readonly DrawerName[] = ['places', 'files', 'scenery'];
const kDatabase = 'muster-places';

/** Records with an `id`. */
export interface Drawers {
  /** Whether what is put there outlasts the page. */
  readonly lasting: boolean;
  put(drawer: DrawerName, record: { readonly id: string }): Promise<void>;
  get(drawer: DrawerName, id: string): Promise<unknown>;
  all(drawer: DrawerName): Promise<readonly unknown[]>;
  remove(drawer: DrawerName, id: string): Promise<void>;
}

export class MemoryDrawers implements Drawers {
  readonly lasting = false;
  private readonly records_ = new Map<string, { readonly id: string }>();

  async put(drawer: DrawerName, record: { readonly id: string }): Promise<void> {
    this.records_.set(`${drawer} ${record.id}`, record);
    return Promise.resolve();
  }

  async get(drawer: DrawerName, id: string): Promise<unknown> {
    return Promise.resolve(this.records_.get(`${drawer} ${id}`));
  }

  async all(drawer: DrawerName): Promise<readonly unknown[]> {
    const found = [...this.records_].filter(([key]) => key.startsWith(`${drawer} `));
    return Promise.resolve(found.map(([, record]) => record));
  }

  async remove(drawer: DrawerName, id: string): Promise<void> {
    this.records_.delete(`${drawer} ${id}`);
    return Promise.resolve();
  }
}

function result<T>(request: IDBRequest<T>): Promise<T> {
  return new Promise((done, fail) => {
    request.onsuccess = () => done(request.result);
    request.onerror = () => fail(request.error ?? new Error('the browser keeps nothing'));
  });
}

class DatabaseDrawers implements Drawers {
  readonly lasting = true;

  constructor(private readonly database_: IDBDatabase) {}

  async put(drawer: DrawerName, record: { readonly id: string }): Promise<void> {
    await this.within(drawer, 'readwrite', (store) => store.put(record));
  }

  get(drawer: DrawerName, id: string): Promise<unknown> {
    return this.within(drawer, 'readonly', (store) => store.get(id));
  }

  all(drawer: DrawerName): Promise<readonly unknown[]> {
    return this.within(drawer, 'readonly', (store) => store.getAll() as IDBRequest<unknown[]>);
  }

  async remove(drawer: DrawerName, id: string): Promise<void> {
    await this.within(drawer, 'readwrite', (store) => store.delete(id));
  }

  private within<T>(
    drawer: DrawerName,
    mode: IDBTransactionMode,
    work: (store: IDBObjectStore) => IDBRequest<T>,
  ): Promise<T> {
    return result(work(this.database_.transaction(drawer, mode).objectStore(drawer)));
  }
}

/** Never fails. */
export async function openDrawers(factory: IDBFactory | undefined = globalThis.indexedDB): Promise<Drawers> {
  if (!factory) return new MemoryDrawers();
  try {
    const opening = factory.open(kDatabase, 1);
    opening.onupgradeneeded = () => {
      for (const name of kDrawers) opening.result.createObjectStore(name, { keyPath: 'id' });
    };
    return new DatabaseDrawers(await result(opening));
  } catch {
    return new MemoryDrawers();
  }
}
