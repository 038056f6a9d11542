// Fetches and reads the file of a player; every failure is one sentence.

import { loadCrowd, type LoadedCrowd } from './file/loaded_crowd';
import { DamagedFile } from './file/range_decoder';

/** How messages call a file. */
export function fileName(src: string): string {
  if (src.startsWith('data:') || src.startsWith('blob:')) return 'The file';
  const name = src.replace(/[?#].*$/, '').replace(/^.*\//, '');
  return name === '' ? 'The file' : `“${name.length > 60 ? `…${name.slice(-60)}` : name}”`;
}

/** Loads a file. Fails with an Error that holds a sentence for the visitor. */
export async function loadFile(src: string, signal: AbortSignal): Promise<LoadedCrowd> {
  const name = fileName(src);
  const bytes = await fetched(src, name, signal);
  try {
    return await loadCrowd(bytes, async () => {
      await new Promise((done) => setTimeout(done, 0));
      signal.throwIfAborted();
    });
  } catch (error) {
    if (error instanceof DamagedFile) throw new Error(`${name} cannot be played: ${error.message}.`);
    if (error instanceof RangeError) throw new Error(`${name} cannot be played: this browser has no room for it.`);
    throw error;
  }
}

async function fetched(src: string, name: string, signal: AbortSignal): Promise<Uint8Array> {
  let answer: Response;
  try {
    answer = await fetch(src, { signal });
  } catch (error) {
    if (signal.aborted) throw error;
    const local = location.protocol === 'file:' && !src.startsWith('data:');
    const hint = local ? 'pages that are opened from a disk load no files beside them' : 'the host does not answer';
    throw new Error(`${name} cannot be loaded: ${hint}.`);
  }
  if (!answer.ok)
    throw new Error(`${name} cannot be loaded: the host answers ${answer.status} ${answer.statusText}`.trim() + '.');
  return new Uint8Array(await answer.arrayBuffer());
}
