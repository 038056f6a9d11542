// Places are loaded when somebody opens their dialog, edits, or has something of theirs to see.

import { problem } from '../../protocol/problem';
import { hasAutosave, placeBefore, rememberPlace } from './place_autosave';
import type { PlaceController, PlaceParts } from './place_controller';
import { placesWithScenery } from './place_shelf';

export function openPlacesLazily(parts: PlaceParts): void {
  const { store, client } = parts;
  let controller: Promise<PlaceController> | null = null;
  const loaded = (): Promise<PlaceController> => {
    controller ??= import('./place_controller').then((module) => new module.PlaceController(parts));
    return controller;
  };
  const failed = (): void => {
    controller = null;
    store.set({ places: 'none', notice: problem('page', 'The server does not answer: try again.') });
  };
  store.watch(['places'], ({ places }) => {
    if (places !== 'none' && !controller) loaded().catch(failed);
  });
  client.on('editHistory', (history) => {
    if (history.edited || controller) loaded().then((one) => one.setHistory(history), failed);
  });
  // Another place has its welcome, too: a server is asked once.
  let isNew = true;
  let was = placeBefore();
  client.on('link', ({ phase }) => {
    if (phase === 'open' || isNew) return;
    isNew = true;
    was = store.state.title;
  });
  client.on('welcome', () => {
    const asks = isNew && hasAutosave();
    isNew = false;
    if (asks) loaded().then((one) => one.offerKept(was), failed);
  });
  store.watch(['title', 'replaying'], ({ title, replaying }) => {
    if (title !== '' && !replaying) rememberPlace(title);
    if (!controller && placesWithScenery(() => window.localStorage).includes(title)) loaded().catch(failed);
  });
}
