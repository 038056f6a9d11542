// The browser's shelf of places: scenario files with pictures, and the models that are shown in them.

import type { KeptPlace } from '../../model/place_files/kept_place';
import type { PlaceDefinition } from '../../model/place_files/place';
import { factsOf } from '../../model/place_files/place_drawing';
import type { SceneryModel } from '../../model/place_files/scenery';
import { openDrawers, type Drawers } from './place_drawers';

/** Places that were kept by themselves: older ones make room. */
const kMostAutosaves = 5;
/** Names of places with models, so that others need no look into the database. */
const kSceneryKey = 'muster.scenery';

/** The file with another name in it; the same text where it has that name. */
export function withName(text: string, name: string): string {
  const place = JSON.parse(text) as PlaceDefinition;
  return place.name === name ? text : JSON.stringify({ ...place, name });
}

function factsIn(text: string): string {
  try {
    return factsOf(JSON.parse(text) as PlaceDefinition);
  } catch {
    return '';
  }
}

export class PlaceShelf {
  constructor(
    private readonly drawers_: Drawers = openDrawers(),
    private readonly storage_: () => Storage = () => window.localStorage,
    private readonly now_: () => number = () => Date.now() / 1000,
  ) {}

  get lasting(): boolean {
    return this.drawers_.lasting;
  }

  /** The newest first. */
  async list(): Promise<readonly KeptPlace[]> {
    const all = (await this.drawers_.all('places')) as readonly KeptPlace[];
    return [...all].sort((a, b) => b.changed - a.changed);
  }

  /** Keeps a file by its name; what was kept by that name is replaced. Throws where there is no room. */
  async save(name: string, text: string, picture: Blob | null): Promise<KeptPlace> {
    const known = (await this.list()).find((one) => one.name === name && !one.auto);
    return this.keep(known?.id ?? crypto.randomUUID(), name, withName(text, name), picture, false);
  }

  /** Keeps what is being edited; each place has one such copy. */
  async autosave(name: string, text: string, picture: Blob | null): Promise<KeptPlace> {
    const kept = await this.keep(`auto ${name}`, name, text, picture, true);
    const old = (await this.list()).filter((one) => one.auto).slice(kMostAutosaves);
    for (const { id } of old) await this.remove(id);
    return kept;
  }

  async read(id: string): Promise<string> {
    const found = (await this.drawers_.get('files', id)) as { readonly text: string } | undefined;
    if (!found) throw new Error('The browser has lost this place.');
    return found.text;
  }

  async rename(id: string, name: string): Promise<void> {
    const place = (await this.list()).find((one) => one.id === id);
    if (place) await this.keep(id, name, withName(await this.read(id), name), place.picture, false);
  }

  /** Returns what brings it back. */
  async remove(id: string): Promise<() => Promise<void>> {
    const drawers = this.drawers_;
    const [place, file] = [await drawers.get('places', id), await drawers.get('files', id)];
    await drawers.remove('places', id);
    await drawers.remove('files', id);
    return async () => {
      if (!place || !file) return;
      await drawers.put('files', file as { id: string });
      await drawers.put('places', place as { id: string });
    };
  }

  // Models, by the name of the place that they stand in.

  /** Empty at once where there is none. */
  async scenery(place: string): Promise<readonly SceneryModel[]> {
    if (!this.placesWithScenery().includes(place)) return [];
    const found = (await this.drawers_.get('scenery', place)) as { models: SceneryModel[] } | undefined;
    return found?.models ?? [];
  }

  async keepScenery(place: string, models: readonly SceneryModel[]): Promise<void> {
    const drawers = this.drawers_;
    if (models.length > 0) await drawers.put('scenery', { id: place, models } as { id: string });
    else await drawers.remove('scenery', place);
    const others = this.placesWithScenery().filter((one) => one !== place);
    try {
      this.storage_().setItem(kSceneryKey, JSON.stringify(models.length > 0 ? [...others, place] : others));
    } catch {
      // Without storage models are shown until the page is left.
    }
  }

  private placesWithScenery(): readonly string[] {
    return placesWithScenery(this.storage_);
  }

  private async keep(id: string, name: string, text: string, picture: Blob | null, auto: boolean): Promise<KeptPlace> {
    const drawers = this.drawers_;
    const place: KeptPlace = { id, name, changed: this.now_(), facts: factsIn(text), picture, auto };
    await drawers.put('files', { id, text } as { id: string });
    await drawers.put('places', place);
    return place;
  }
}

export function placesWithScenery(storage: () => Storage): readonly string[] {
  try {
    return JSON.parse(storage().getItem(kSceneryKey) ?? '[]') as string[];
  } catch {
    return [];
  }
}
