// Words in the page's own font, for crowds large enough to fill its letters.

import { LetterReader, type LetterDrawn } from '../../model/letters/legibility';
import { centred, type WordPlaces } from '../../model/letters/words';
import type { GroundPoint } from '../../model/plane';
import { spreadOver, type Mask } from '../../model/spread';

/** Size of the font in the picture that is spread over, and free round the words [cells]. */
const kSize = 72;
const kMargin = 4;
/** With fewer people for a letter than this, letters are thin. */
const kThin = 26;
const kDark = 110;
const kAlphabet = 'ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789';

interface Picture {
  readonly mask: Mask;
  readonly letters: readonly { readonly char: string; readonly left: number; readonly right: number }[];
  /** Row of the baseline, and the height of a capital [cells]. */
  readonly baseline: number;
  readonly high: number;
}

function pictureOf(words: string, weight: number): Picture | null {
  const canvas = document.createElement('canvas');
  const pen = canvas.getContext('2d', { willReadFrequently: true });
  if (!pen) return null;
  const font = `${weight} ${kSize}px "Inter Variable", Inter, system-ui, sans-serif`;
  pen.font = font;
  const signs = [...words];
  const edges = signs.map((_, i) => kMargin + pen.measureText(signs.slice(0, i).join('')).width);
  const end = kMargin + pen.measureText(words).width;
  const high = pen.measureText('H').actualBoundingBoxAscent;
  [canvas.width, canvas.height] = [Math.ceil(end) + kMargin, Math.ceil(1.4 * kSize)];
  const baseline = Math.round(1.05 * kSize);
  pen.font = font;
  pen.fillText(words, kMargin, baseline);
  const { data, width, height } = pen.getImageData(0, 0, canvas.width, canvas.height);
  const cells = Uint8Array.from({ length: width * height }, (_, i) => (data[4 * i + 3]! > kDark ? 1 : 0));
  const letters = signs
    .map((char, i) => ({ char, left: edges[i]!, right: edges[i + 1] ?? end }))
    .filter(({ char }) => char.trim() !== '');
  return { mask: { width, height, cells }, letters, baseline, high };
}

/** From cells about the middle of the picture to heights of a capital above the baseline. */
function inCapitals({ mask, baseline, high }: Picture, { x, y }: GroundPoint): GroundPoint {
  const [column, row] = [x + (mask.width - 1) / 2, (mask.height - 1) / 2 - y];
  return { x: column / high, y: (baseline - row) / high };
}

function drawnLetter(char: string, weight: number): LetterDrawn {
  const picture = pictureOf(char, weight);
  const samples: GroundPoint[] = [];
  const { width = 0, height = 0, cells = [] } = picture?.mask ?? {};
  for (let row = 0; row < height; row += 2)
    for (let column = 0; column < width; column += 2)
      if (cells[row * width + column])
        samples.push(inCapitals(picture!, { x: column - (width - 1) / 2, y: (height - 1) / 2 - row }));
  return { samples, step: 1, dots: [] };
}

const readers = new Map<number, LetterReader>();

function readerOf(weight: number): LetterReader {
  const known = readers.get(weight);
  if (known) return known;
  const drawn = new Map<string, LetterDrawn>();
  const draw = (char: string): LetterDrawn => {
    const letter = drawn.get(char) ?? drawnLetter(char, weight);
    drawn.set(char, letter);
    return letter;
  };
  const reader = new LetterReader(draw, [...kAlphabet]);
  readers.set(weight, reader);
  return reader;
}

/** A letter that no font has: browsers draw the same box in place of each such letter. */
const kNoLetter = '\u{10ffff}';

/** The first letter that no font of this browser has a drawing of; null where there is none. */
export function missingLetter(words: string): string | null {
  const drawing = (char: string): string => Array.from(pictureOf(char, 750)?.mask.cells ?? []).join('');
  const box = drawing(kNoLetter);
  return [...words].find((char) => char.trim() !== '' && drawing(char) === box) ?? null;
}

/** Words spread over the letters of the font; null where they have no room for so many. */
export function outlineWords(words: string, count: number): WordPlaces | null {
  const perLetter = count / Math.max(1, words.replace(/\s/g, '').length);
  const weight = perLetter < kThin ? 250 : 750;
  const picture = pictureOf(words, weight);
  const spread = picture && spreadOver(picture.mask, count);
  if (!picture || !spread || count < 1 || spread.places.length < count) return null;
  const places = spread.places.map((place) => inCapitals(picture, place));
  const letters = picture.letters.map(({ char, left, right }) => {
    const [from, to] = [left / picture.high, right / picture.high];
    return { char, places: places.filter(({ x }) => x >= from && x < to) };
  });
  const gap = spread.gap / picture.high;
  return { places: centred(places), gap, legibility: readerOf(weight).read(letters, gap) };
}

/** From so many people for a letter on, letters of the font are tried. */
const kFull = 26;
/** So many more people are tried, in steps, where only the font has a drawing of a letter. */
const kSteps = 14;

/** The words as they are read best: in letters of the font where there are people for these, else by `lines`. */
export function bestWords(words: string, count: number, lines: WordPlaces | null): WordPlaces | null {
  const letters = words.replace(/\s/g, '').length;
  if (letters === 0) return null;
  const outline = !lines || count >= kFull * letters ? outlineWords(words, count) : null;
  return outline?.legibility.reads || !lines ? outline : lines;
}

/** With how many people words can be read that have no single lines; 0 where that is not known. */
export function outlinePeopleFor(words: string, count: number): number {
  let tried = Math.max(count, kFull);
  for (let i = 0; i < kSteps; ++i, tried = Math.ceil(1.25 * tried))
    if (outlineWords(words, tried)?.legibility.reads) return tried;
  return 0;
}
