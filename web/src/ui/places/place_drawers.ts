// Where the browser keeps places: its database, or memory where there is none.

import { BrowserStore, result } from '../../link/browser_store';

export type DrawerName = 'places' | 'files' | 'scenery';

/** Records with an `id`. */
export interface Drawers {
  /** Whether what is put there outlasts the page. */
  readonly lasting: boolean;
  /** Throws a sentence for the visitor where there is no room. */
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

interface Kept {
  readonly name: string;
  readonly record: unknown;
}

class DatabaseDrawers implements Drawers {
  readonly lasting = true;
  private readonly stores_: Readonly<Record<DrawerName, BrowserStore>>;

  constructor(factory: IDBFactory) {
    const store = (name: DrawerName): BrowserStore => new BrowserStore(`muster-place-${name}`, name, factory);
    this.stores_ = { places: store('places'), files: store('files'), scenery: store('scenery') };
  }

  async put(drawer: DrawerName, record: { readonly id: string }): Promise<void> {
    const kept: Kept = { name: record.id, record };
    const done = await this.stores_[drawer].within('readwrite', (store) => result(store.put(kept)));
    if (done === null) throw new Error('This browser has no room for it: download the file instead.');
  }

  async get(drawer: DrawerName, id: string): Promise<unknown> {
    const kept = await this.stores_[drawer].within('readonly', (store) =>
      result(store.get(id) as IDBRequest<Kept | undefined>),
    );
    return kept?.record;
  }

  async all(drawer: DrawerName): Promise<readonly unknown[]> {
    const all = await this.stores_[drawer].within('readonly', (store) => result(store.getAll() as IDBRequest<Kept[]>));
    return (all ?? []).map(({ record }) => record);
  }

  async remove(drawer: DrawerName, id: string): Promise<void> {
    await this.stores_[drawer].within('readwrite', (store) => result(store.delete(id)));
  }
}

export function openDrawers(factory: IDBFactory | undefined = globalThis.indexedDB): Drawers {
  return factory ? new DatabaseDrawers(factory) : new MemoryDrawers();
}
