// Requests whose failure is told to the visitor.

import { ask } from './answers';
import { plainReason } from '../model/file_trouble';

/** The answer to a request. Throws a sentence that begins with `what` where it fails. */
export async function asked(what: string, path: string, init: RequestInit = {}): Promise<Response> {
  let answer: Response;
  try {
    answer = await ask(path, init);
  } catch {
    throw new Error(`${what}: the server does not answer.`);
  }
  if (answer.ok) return answer;
  const reason = plainReason(await answer.text());
  throw new Error(`${what}: ${reason || answer.statusText || answer.status}.`);
}
