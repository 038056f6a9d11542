// What belongs to takes is loaded when there is one to keep or to watch, or when the visitor has looked around for a moment.

import type { TakeState } from '../../protocol/messages';
import { loadWhen } from '../widgets/lazily';
import type { TakeControllerParts } from './take_controller';

/** After the first picture a recording that was cut off is offered [ms]. */
const kLooksAround = 3000;

/** `seen`: when somebody has seen the first picture. */
export function openTakesLazily(parts: TakeControllerParts, seen: Promise<void>): void {
  const { client, store } = parts;
  let take: TakeState | null = null;
  const load = async (): Promise<void> => {
    const module = await import('./take_controller');
    const controller = new module.TakeController(parts);
    if (take) controller.changed(take);
  };
  const wanted = ['shelf', 'recorded'] as const;
  const now = loadWhen(store, wanted, ({ shelf, recorded }) => shelf || recorded >= 0, load, { shelf: false });
  client.on('takeState', (state) => {
    take = state;
    if (state.open) now();
  });
  void seen.then(() => setTimeout(now, kLooksAround));
}
