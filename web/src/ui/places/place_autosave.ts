// Keeps a place in the browser while it is edited, and finds what was kept when the page opens.

import type { KeptPlace } from '../../model/place_files/kept_place';
import type { PlaceDefinition } from '../../model/place_files/place';
import type { PlaceLink } from './place_link';
import type { PlaceShelf } from './place_shelf';
import { readSetting, writeSetting } from '../widgets/theme';

/** So long after the last change [ms]. */
export const kAutosaveAfter = 2000;
/** When the newest copy was kept that the visitor did not want, or has opened [s since 1970]. */
const kSeenKey = 'muster.autosave.seen';
/** The place that was edited when the page was left: the server has more of it than the copy. */
const kBehindKey = 'muster.autosave.behind';
/** There is something to look for. */
const kKeptKey = 'muster.autosave';

export interface AutosaveParts {
  readonly link: Pick<PlaceLink, 'read'>;
  readonly shelf: Pick<PlaceShelf, 'autosave' | 'list' | 'read'>;
  readonly picture: () => Promise<Blob | null>;
  readonly storage?: () => Storage;
}

/** The place that was shown when the page was left. */
const kHereKey = 'muster.place';

export function placeBefore(storage: () => Storage = () => window.localStorage): string {
  return readSetting(storage, kHereKey) ?? '';
}

export function rememberPlace(title: string, storage: () => Storage = () => window.localStorage): void {
  writeSetting(storage, kHereKey, title);
}

export function hasAutosave(storage: () => Storage = () => window.localStorage): boolean {
  return readSetting(storage, kKeptKey) !== null;
}

export class PlaceAutosave {
  private timer_ = 0;
  private edited_ = false;
  private own_ = false;
  /** A pointer is down: the picture of a copy would hold its drag up. */
  private held_ = false;
  /** Of the place that is edited. */
  private name_ = '';
  private readonly storage_: () => Storage;

  constructor(private readonly parts_: AutosaveParts) {
    this.storage_ = parts_.storage ?? (() => window.localStorage);
    const holds = (held: boolean): void => void (this.held_ = held);
    window.addEventListener('pointerdown', () => holds(true), true);
    for (const end of ['pointerup', 'pointercancel']) window.addEventListener(end, () => holds(false), true);
    window.addEventListener('pagehide', () => this.waiting && this.own_ && this.write(kBehindKey, this.name_));
  }

  get waiting(): boolean {
    return this.timer_ !== 0;
  }

  /** The server says whether the place differs from what was opened. `own`: this page has edited it. */
  setEdited(edited: boolean, name: string, own: boolean): void {
    [this.edited_, this.name_, this.own_] = [edited, name, own];
    if (edited) this.changed();
    else this.cancel();
  }

  /** Something in the place has changed. */
  changed(): void {
    if (!this.edited_) return;
    this.cancel();
    this.timer_ = window.setTimeout(() => (this.held_ ? this.changed() : void this.keep()), kAutosaveAfter);
  }

  /** Before another place is opened: keeps at once what waits. */
  async flush(): Promise<void> {
    if (this.waiting) await this.keep();
  }

  /** Nothing fails here: without a server or room there is no copy. */
  private async keep(): Promise<void> {
    this.cancel();
    try {
      const text = await this.parts_.link.read();
      const { name } = JSON.parse(text) as PlaceDefinition;
      await this.parts_.shelf.autosave(name, text, await this.parts_.picture());
      this.write(kKeptKey, name);
    } catch {
      // The next change tries again.
    }
  }

  private cancel(): void {
    window.clearTimeout(this.timer_);
    this.timer_ = 0;
  }

  /** It is kept on purpose, by that name. */
  saved(name: string): void {
    this.write(kKeptKey, name);
  }

  /** The newest copy of the place that was shown before, where the server's place is another, and the visitor has not seen
   * it. `was`: the title of that place; empty where nobody knows. */
  async lost(was: string): Promise<KeptPlace | null> {
    try {
      const newest = (await this.parts_.shelf.list()).find((one) => (was === '' ? one.auto : one.name === was));
      if (!newest || newest.changed <= this.seen()) return null;
      const [here, kept] = await Promise.all([this.parts_.link.read(), this.parts_.shelf.read(newest.id)]);
      if (here === kept) return null;
      const { name } = JSON.parse(here) as PlaceDefinition;
      const behind = this.read(kBehindKey);
      this.write(kBehindKey, '');
      return name === newest.name && name === behind ? null : newest;
    } catch {
      return null;
    }
  }

  markSeen(place: KeptPlace): void {
    this.write(kSeenKey, String(place.changed));
  }

  private seen(): number {
    return Number(this.read(kSeenKey));
  }

  private read(key: string): string {
    return readSetting(this.storage_, key) ?? '';
  }

  private write(key: string, value: string): void {
    writeSetting(this.storage_, key, value);
  }
}
