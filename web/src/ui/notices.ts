// Messages to the visitor.

import type { Notice } from '../protocol/messages';

/** What stands under the sentence: the code, and where it happened. */
export function noticeDetail({ code, hasPlace, x, y }: Notice): string {
  const metres = (value: number): string => value.toFixed(1).replace('-', '\u2212');
  return hasPlace ? `${code} \u00b7 at ${metres(x)}, ${metres(y)} m` : code;
}
