// Places are loaded when somebody opens their dialog, edits, or has something of theirs to see.

import { couldNotLoad, once } from '../widgets/lazily';
import { hasAutosave, placeBefore, rememberPlace } from './place_autosave';
import type { PlaceController, PlaceParts } from './place_controller';
import { placesWithScenery } from './place_shelf';

export function openPlacesLazily(parts: PlaceParts): void {
  const { store, client } = parts;
  const loaded = once(async () => {
    const module = await import('./place_controller');
    return new module.PlaceController(parts);
  });
  const use = (act: (places: PlaceController) => unknown = () => undefined): void =>
    void loaded().then(act, () => couldNotLoad(store, { places: 'none' }));
  store.watch(['places'], ({ places }) => places !== 'none' && use());
  let edits = false;
  client.on('editHistory', (history) => {
    edits ||= history.edited;
    if (edits) use((one) => one.setHistory(history));
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
    if (asks) use((one) => one.offerKept(was));
  });
  store.watch(['title', 'replaying'], ({ title, replaying }) => {
    if (title !== '' && !replaying) rememberPlace(title);
    if (placesWithScenery(() => window.localStorage).includes(title)) use();
  });
}
