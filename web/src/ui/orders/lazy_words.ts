// The line for words is loaded when somebody opens it first.

import { openLazily } from '../widgets/lazily';
import type { WordsParts } from './words_controller';

export function openWordsLazily(parts: WordsParts): void {
  openLazily(parts.store, 'words', async () => {
    const module = await import('./words_controller');
    return new module.WordsController(parts);
  });
}
