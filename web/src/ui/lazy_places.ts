// Places are loaded when somebody opens their dialog, edits, or has something of theirs to see.

import { problem } from '../protocol/problem';
import { hasAutosave } from './place_autosave';
import type { PlaceDesk, PlaceParts } from './place_desk';
import { placesWithScenery } from './place_shelf';

export function openPlacesLazily(parts: PlaceParts): void {
  const { store, client } = parts;
  let desk: Promise<PlaceDesk> | null = null;
  let waits = true;
  const loaded = (): Promise<PlaceDesk> => {
    desk ??= import('./place_desk').then(({ PlaceDesk: Desk }) => new Desk(parts));
    return desk;
  };
  const failed = (): void => {
    desk = null;
    store.set({ places: 'none', notice: problem('page', 'The server does not answer: try again.') });
  };
  store.watch(['places'], ({ places }) => {
    if (places !== 'none' && !desk) loaded().catch(failed);
  });
  client.on('editHistory', ({ edited }) => {
    if (edited || desk) loaded().then((one) => one.setEdited(edited), failed);
  });
  store.watch(['title'], ({ title }) => {
    if (!desk && placesWithScenery(() => window.localStorage).includes(title)) loaded().catch(failed);
    if (!waits || title === '' || !hasAutosave()) return;
    waits = false;
    loaded().then((one) => one.offerKept(), failed);
  });
}
