// The present place over HTTP (docs/protocol.md). Every call throws a sentence for the visitor where it fails.

import { ask as request } from '../link/answers';
import { plainReason } from '../model/file_trouble';

async function ask(what: string, path: string, init: RequestInit = {}): Promise<string> {
  let answer: Response;
  try {
    answer = await request(path, init);
  } catch {
    throw new Error(`${what}: the server does not answer.`);
  }
  const text = await answer.text();
  if (answer.ok) return text;
  const reason = plainReason(text);
  throw new Error(`${what}: ${reason || answer.statusText || answer.status}.`);
}

export class PlaceLink {
  /** The place as its file. */
  read(): Promise<string> {
    return ask('The place could not be read', 'scenario');
  }

  /** Opens a file for everybody. */
  async open(text: string, name: string): Promise<void> {
    const init = { method: 'POST', body: text, headers: { 'Content-Type': 'application/json' } };
    await ask(`“${name}” could not be opened`, `scenario?name=${encodeURIComponent(name)}`, init);
  }
}
