// Copies of takes in the browser: a take is safe even where the server's folder is lost.

import type { ShelvedTake } from '../model/take_facts';

interface Copy {
  readonly name: string;
  readonly take: ShelvedTake;
  readonly file: Blob;
}

const kDatabase = 'muster-takes';
const kStore = 'takes';
/** Older ones make room for newer ones. */
export const kMostCopies = 30;

/** A take of which only the browser has a copy. */
export type CopiedTake = ShelvedTake & { readonly copyOnly: true };

export function isCopyOnly(take: ShelvedTake): take is CopiedTake {
  return 'copyOnly' in take;
}

/** What the server has, and what only the browser has, the newest first. */
export function withCopies(takes: readonly ShelvedTake[], copies: readonly ShelvedTake[]): readonly ShelvedTake[] {
  const known = new Set(takes.map((take) => take.name));
  const others = copies
    .filter((take) => !known.has(take.name))
    .map((take): CopiedTake => ({ ...take, picture: false, copyOnly: true }));
  return [...takes, ...others].sort((a, b) => b.changed - a.changed);
}

function result<T>(request: IDBRequest<T>): Promise<T> {
  return new Promise((done, fail) => {
    request.onsuccess = () => done(request.result);
    request.onerror = () => fail(request.error ?? new Error('the browser keeps no copies'));
  });
}

/** Nothing here fails: without storage there are no copies. */
export class TakeCopies {
  constructor(private readonly factory_: IDBFactory | undefined = globalThis.indexedDB) {}

  async keep(take: ShelvedTake, file: Blob): Promise<void> {
    await this.within('readwrite', async (store) => {
      await result(store.put({ name: take.name, take, file } satisfies Copy));
      const all = (await result(store.getAll())) as Copy[];
      const old = all.sort((a, b) => b.take.changed - a.take.changed).slice(kMostCopies);
      for (const { name } of old) await result(store.delete(name));
    });
  }

  async list(): Promise<readonly ShelvedTake[]> {
    const all = await this.within('readonly', (store) => result(store.getAll() as IDBRequest<Copy[]>));
    return (all ?? []).map(({ take }) => take);
  }

  async read(name: string): Promise<Blob | null> {
    const copy = await this.within('readonly', (store) => result(store.get(name) as IDBRequest<Copy | undefined>));
    return copy?.file ?? null;
  }

  async remove(name: string): Promise<void> {
    await this.within('readwrite', (store) => result(store.delete(name)));
  }

  private async within<T>(mode: IDBTransactionMode, work: (store: IDBObjectStore) => Promise<T>): Promise<T | null> {
    if (!this.factory_) return null;
    try {
      const opening = this.factory_.open(kDatabase, 1);
      opening.onupgradeneeded = () => opening.result.createObjectStore(kStore, { keyPath: 'name' });
      const database = await result(opening);
      try {
        return await work(database.transaction(kStore, mode).objectStore(kStore));
      } finally {
        database.close();
      }
    } catch {
      return null;
    }
  }
}
