// Motions of the place with the lengths of their plays, which only its file tells.

import { ask } from '../../link/answers';
import type { PlaceClip } from '../../model/place/motions';
import type { PlaceDefinition } from '../../model/place_files/place';

/** Gives the names at once, and the lengths as soon as they are known. */
export function placeClips(known: readonly { readonly name: string }[], take: (clips: PlaceClip[]) => void): void {
  take(known.map(({ name }) => ({ name, length: 0 })));
  const read = async (): Promise<void> => {
    const answer = await ask('scenario');
    const { clips = [] } = (await answer.json()) as PlaceDefinition;
    const lengths = new Map(clips.map(({ name, length = 0, cyclic = true }) => [name, cyclic ? 0 : length]));
    take(known.map(({ name }) => ({ name, length: lengths.get(name) ?? 0 })));
  };
  // Without lengths nothing is said of what fits.
  read().catch(() => undefined);
}
