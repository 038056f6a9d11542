// Copies of takes in the browser: a take is safe even where the server's folder is lost.

import type { ShelvedTake } from '../../model/take_facts';
import { BrowserStore, result } from '../../link/browser_store';

interface Copy {
  readonly name: string;
  readonly take: ShelvedTake;
  readonly file: Blob;
}

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

/** Nothing here fails: without storage there are no copies. */
export class TakeCopies {
  private readonly store_: BrowserStore;

  constructor(factory: IDBFactory | undefined = globalThis.indexedDB) {
    this.store_ = new BrowserStore('muster-takes', 'takes', factory);
  }

  async keep(take: ShelvedTake, file: Blob): Promise<void> {
    await this.store_.within('readwrite', async (store) => {
      await result(store.put({ name: take.name, take, file } satisfies Copy));
      const all = (await result(store.getAll())) as Copy[];
      const old = all.sort((a, b) => b.take.changed - a.take.changed).slice(kMostCopies);
      for (const { name } of old) await result(store.delete(name));
    });
  }

  async list(): Promise<readonly ShelvedTake[]> {
    const all = await this.store_.within('readonly', (store) => result(store.getAll() as IDBRequest<Copy[]>));
    return (all ?? []).map(({ take }) => take);
  }

  async read(name: string): Promise<Blob | null> {
    const copy = await this.store_.within('readonly', (store) =>
      result(store.get(name) as IDBRequest<Copy | undefined>),
    );
    return copy?.file ?? null;
  }

  async remove(name: string): Promise<void> {
    await this.store_.within('readwrite', (store) => result(store.delete(name)));
  }
}
