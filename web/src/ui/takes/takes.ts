// Takes travel by plain HTTP: one is downloaded, or a file is opened.

import { ask, save } from '../../link/answers';
import { ShelfLink } from '../../link/shelf_link';

/** A file name for a take of this scenario. */
export function takeName(scenario: string, now: Date): string {
  const plain =
    scenario
      .toLowerCase()
      .replace(/[^a-z0-9]+/g, '-')
      .replace(/^-|-$/g, '') || 'take';
  return `${plain}-${now.toISOString().slice(0, 19).replace(/[:T]/g, '-')}.take`;
}

/** Null where it worked, else a sentence for the visitor. */
export async function downloadTake(scenario: string): Promise<string | null> {
  try {
    const answer = await ask('take');
    if (!answer.ok)
      return answer.status === 404
        ? 'There is no take yet: record one first.'
        : `The take could not be downloaded: ${answer.statusText}.`;
    const url = URL.createObjectURL(await answer.blob());
    void save(url, takeName(scenario, new Date()));
    window.setTimeout(() => URL.revokeObjectURL(url), 10000);
    return null;
  } catch {
    return 'The take could not be downloaded: the server does not answer.';
  }
}

/** Puts a file on the shelf and plays it. Null where it worked, else a sentence for the visitor. */
export async function openTake(file: File): Promise<string | null> {
  try {
    const shelf = new ShelfLink();
    await shelf.open(await shelf.put(file, file.name));
    return null;
  } catch (error) {
    return error instanceof Error ? error.message : String(error);
  }
}
