// The present place over HTTP (docs/protocol.md). Every call throws a sentence for the visitor where it fails.

import { byUs } from '../../link/answers';
import { asked } from '../../link/asked';

export class PlaceLink {
  /** The place as its file. */
  async read(): Promise<string> {
    return (await asked('The place could not be read', 'scenario')).text();
  }

  /** Opens a file for everybody. */
  async open(text: string, name: string): Promise<void> {
    const init = { method: 'POST', body: text, headers: { 'Content-Type': 'application/json' } };
    await asked(`“${name}” could not be opened`, byUs(`scenario?name=${encodeURIComponent(name)}`), init);
  }
}
