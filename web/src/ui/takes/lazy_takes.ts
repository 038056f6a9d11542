// What belongs to takes is loaded when there is one to keep or to watch, or when the visitor has looked around for a moment.

import type { TakeState } from '../../protocol/messages';
import { problem } from '../../protocol/problem';
import type { TakeController, TakeControllerParts } from './take_controller';

/** After the first picture a recording that was cut off is offered [ms]. */
const kLooksAround = 3000;

/** `seen`: when somebody has seen the first picture. */
export function openTakesLazily(parts: TakeControllerParts, seen: Promise<void>): void {
  const { client, store } = parts;
  let controller: TakeController | null = null;
  let loading = false;
  let take: TakeState | null = null;
  const load = (): void => {
    if (controller || loading) return;
    loading = true;
    import('./take_controller')
      .then((module) => {
        controller = new module.TakeController(parts);
        if (take) controller.changed(take);
      })
      .catch(() => store.set({ shelf: false, notice: problem('page', 'The server does not answer: try again.') }))
      .finally(() => (loading = false));
  };
  client.on('takeState', (state) => {
    take = state;
    if (state.open) load();
  });
  store.watch(['shelf', 'recorded'], ({ shelf, recorded }) => (shelf || recorded >= 0) && load());
  void seen.then(() => setTimeout(load, kLooksAround));
}
