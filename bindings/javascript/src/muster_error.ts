// Failures of the library and of what it is given.

import { Status } from './generated/enums.js';

/** One sentence that names the culprit, and the code of its kind. */
export class MusterError extends Error {
  override readonly name = 'MusterError';

  constructor(
    /** The kind of failure. */
    readonly code: Status,
    sentence: string,
  ) {
    super(sentence);
  }
}

/** A value as messages show it. */
export function shown(value: unknown): string {
  if (value === null || value === undefined) return 'nothing';
  if (typeof value === 'string') return JSON.stringify(value.length > 40 ? `${value.slice(0, 40)}…` : value);
  if (Array.isArray(value)) return 'an array';
  if (typeof value === 'function') return 'a function';
  if (typeof value !== 'object') return String(value);
  const name = (Object.getPrototypeOf(value) as object | null)?.constructor.name ?? 'Object';
  return name === 'Object' ? 'an object' : `${/^[AEIOU]/.test(name) ? 'an' : 'a'} ${name}`;
}

/** `PLACE: found X, expected Y`. */
export function wrongValue(place: string, found: unknown, expected: string): MusterError {
  return new MusterError(Status.InvalidArgument, `${place}: found ${shown(found)}, expected ${expected}`);
}
