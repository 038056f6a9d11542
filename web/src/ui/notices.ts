// Messages to the visitor.

import { NoticeLevel, type Notice } from '../protocol/messages';

/** Something that went wrong on the page's side. */
export function problem(code: string, text: string): Notice {
  return { type: 'Notice', level: NoticeLevel.Error, code, text, hasPlace: false, x: 0, y: 0 };
}

/** What stands under the sentence: the code, and where it happened. */
export function noticeDetail({ code, hasPlace, x, y }: Notice): string {
  const metres = (value: number): string => value.toFixed(1).replace('-', '\u2212');
  return hasPlace ? `${code} \u00b7 at ${metres(x)}, ${metres(y)} m` : code;
}
