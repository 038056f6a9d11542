// A QR code as a picture: black on white in both themes, with the quiet zone that readers need.

import type { VNode } from 'preact';

/** Modules of white round the code. */
const kQuietZone = 4;

/** The dark modules of a row that begin at `x`. */
function run(x: number, y: number, length: number): string {
  return `M${x + kQuietZone} ${y + kQuietZone}h${length}v1h-${length}z`;
}

/** `rows` of "1" for dark and "0" for light. */
export function QrPicture({ rows }: { readonly rows: readonly string[] }): VNode {
  const size = rows.length + 2 * kQuietZone;
  const runs = rows.flatMap((row, y) => [...row.matchAll(/1+/g)].map((dark) => run(dark.index, y, dark[0].length)));
  return (
    <svg viewBox={`0 0 ${size} ${size}`} class="qr" role="img" aria-label="QR code of the link">
      <rect width={size} height={size} fill="#fff" />
      <path fill="#000" shape-rendering="crispEdges" d={runs.join('')} />
    </svg>
  );
}
