// The line for words is loaded when somebody opens it first.

import { openLazily } from '../widgets/lazily';
import type { WordsParts } from './words_controller';

export function openWordsLazily(parts: WordsParts): void {
  openLazily(parts.store, 'words', async () => {
    const { WordsController } = await import('./words_controller');
    return new WordsController(parts);
  });
}
