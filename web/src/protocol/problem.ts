// A message to the visitor that no server sent.

import { NoticeLevel, type Notice } from './messages';

/** Something that went wrong on the page's side. */
export function problem(code: string, text: string): Notice {
  return { type: 'Notice', level: NoticeLevel.Error, code, text, hasPlace: false, x: 0, y: 0 };
}

/** What the page tells, where nothing went wrong. */
export function word(code: string, text: string): Notice {
  return { ...problem(code, text), level: NoticeLevel.Info };
}
