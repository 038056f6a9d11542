// The formations along a way are loaded when they are opened first.

import { problem } from '../../protocol/problem';
import type { SequenceParts } from './sequence/sequence_controller';

export function openSequenceLazily(parts: SequenceParts): void {
  const { store } = parts;
  let asked = false;
  store.watch(['sequencing'], ({ sequencing }) => {
    if (!sequencing || asked) return;
    asked = true;
    import('./sequence/sequence_controller').then(
      (module) => void new module.SequenceController(parts),
      () => {
        asked = false;
        store.set({ sequencing: false, notice: problem('page', 'The server does not answer: try again.') });
      },
    );
  });
}
