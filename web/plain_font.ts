// Makes a small font of Inter's Latin letters with what the page itself says: without accents, with the weights that its styles
// use. Any other letter, in a name that somebody typed, brings the whole file (styles/font.css).

import { mkdir, readFile, writeFile } from 'node:fs/promises';
import subset from 'subset-font';
import type { Plugin } from 'vite';

const kWhole = new URL(
  './node_modules/@fontsource-variable/inter/files/inter-latin-wght-normal.woff2',
  import.meta.url,
);
const kPlain = new URL('./node_modules/.muster/inter-plain.woff2', import.meta.url);
/** The same letters as `unicode-range` in styles/font.css. */
const kRanges: readonly (readonly [first: number, last: number])[] = [
  [0x20, 0x7e],
  [0xa0, 0xa0],
  [0xb0, 0xb3],
  [0xb7, 0xb7],
  [0xd7, 0xd7],
  [0x2013, 0x2014],
  [0x2018, 0x201d],
  [0x2026, 0x2026],
  [0x2212, 0x2212],
];
const kLetters = kRanges
  .flatMap(([first, last]) => Array.from({ length: last - first + 1 }, (_, i) => String.fromCodePoint(first + i)))
  .join('');

export function plainFont(): Plugin {
  return {
    name: 'plain-font',
    async buildStart() {
      const font = await subset(await readFile(kWhole), kLetters, {
        targetFormat: 'woff2',
        keepFeatures: ['kern', 'tnum'],
        variationAxes: { wght: { min: 400, max: 700 } },
      });
      await mkdir(new URL('./', kPlain), { recursive: true });
      await writeFile(kPlain, font);
    },
  };
}
