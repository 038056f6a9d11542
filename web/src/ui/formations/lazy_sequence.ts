// The formations along a way are loaded when they are opened first.

import { loadWhen } from '../widgets/lazily';
import type { SequenceParts } from './sequence/sequence_controller';

export function openSequenceLazily(parts: SequenceParts): void {
  const load = async (): Promise<void> => {
    const module = await import('./sequence/sequence_controller');
    new module.SequenceController(parts);
  };
  loadWhen(parts.store, ['sequencing'], ({ sequencing }) => sequencing, load, { sequencing: false });
}
