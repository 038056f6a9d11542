// The line for words is loaded when somebody opens it first.

import { problem } from '../../protocol/problem';
import type { WordsController, WordsParts } from './words_controller';

export function openWordsLazily(parts: Omit<WordsParts, 'frame'>, frame: WordsParts['frame']): void {
  const { store } = parts;
  let controller: WordsController | null = null;
  let loading = false;
  const load = async (): Promise<void> => {
    const module = await import('./words_controller');
    controller = new module.WordsController({ ...parts, frame });
    controller.setOpen(store.state.words);
  };
  store.watch(['words'], ({ words }) => {
    if (controller) return controller.setOpen(words);
    if (!words || loading) return;
    loading = true;
    load()
      .catch(() => store.set({ words: false, notice: problem('page', 'The server does not answer: try again.') }))
      .finally(() => (loading = false));
  });
}
