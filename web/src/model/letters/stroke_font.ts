// A font of single lines, for words made of few people: capitals, digits and signs as strokes of a pen.

import type { GroundPoint } from '../plane';

/** A line of the pen, and the corners and ends in it that somebody has to stand on, as indices. */
export interface Stroke {
  readonly points: readonly GroundPoint[];
  readonly nodes: readonly number[];
}

export interface StrokeLetter {
  readonly char: string;
  /** Its left edge and its width, in heights of a capital. */
  readonly x: number;
  readonly width: number;
  readonly strokes: readonly Stroke[];
}

/** Heights of a capital in the drawings below, and of a space. */
const kHigh = 6;
const kSpace = 3;
/** A curve is drawn in so many pieces. */
const kPieces = 8;

/** M moves, L draws a line, Q a curve by its control point; y is up, a capital stands from 0 to 6. */
const kGlyphs: Readonly<Record<string, string>> = {
  A: 'M0 0L.67 2L2 6L3.33 2L4 0M.67 2L3.33 2',
  B: 'M0 0L0 3.2L0 6L2.3 6Q3.7 6 3.7 4.8Q3.7 3.7 2.6 3.2L0 3.2M2.6 3.2Q4.1 2.7 4.1 1.5Q4.1 0 2.3 0L0 0',
  C: 'M4 4.9Q3.4 6 2.2 6Q0 6 0 3Q0 0 2.2 0Q3.4 0 4 1.1',
  D: 'M0 0L0 6L1.6 6Q4.2 6 4.2 3Q4.2 0 1.6 0L0 0',
  E: 'M3.6 6L0 6L0 3L0 0L3.6 0M0 3L3 3',
  F: 'M3.6 6L0 6L0 3L0 0M0 3L3 3',
  G: 'M4 4.9Q3.4 6 2.2 6Q0 6 0 3Q0 0 2.2 0Q4 0 4 1.4L4 2.7L2.3 2.7',
  H: 'M0 0L0 3L0 6M4 0L4 3L4 6M0 3L4 3',
  I: 'M0 0L0 6',
  J: 'M3 6L3 1.8Q3 0 1.5 0Q0 0 0 1.6',
  K: 'M0 0L0 2.4L0 6M4 6L1.4 3.66L0 2.4M1.4 3.66L4 0',
  L: 'M0 6L0 0L3.4 0',
  M: 'M0 0L0 6L2.5 2L5 6L5 0',
  N: 'M0 0L0 6L4.2 0L4.2 6',
  O: 'M2.2 6Q0 6 0 3Q0 0 2.2 0Q4.4 0 4.4 3Q4.4 6 2.2 6',
  P: 'M0 0L0 2.8L0 6L2.2 6Q4 6 4 4.4Q4 2.8 2.2 2.8L0 2.8',
  Q: 'M3.85 .75Q4.4 1.5 4.4 3Q4.4 6 2.2 6Q0 6 0 3Q0 0 2.2 0Q3.3 0 3.85 .75M2.8 1.9L3.85 .75L4.8 -.4',
  R: 'M0 0L0 2.8L0 6L2.2 6Q4 6 4 4.4Q4 2.8 2.2 2.8L0 2.8M2.2 2.8L4 0',
  S: 'M3.8 4.9Q3.4 6 2 6Q.2 6 .2 4.6Q.2 3.3 2 3Q4 2.7 4 1.4Q4 0 2 0Q.4 0 0 1.1',
  T: 'M0 6L2.2 6L4.4 6M2.2 6L2.2 0',
  U: 'M0 6L0 2Q0 0 2 0Q4 0 4 2L4 6',
  V: 'M0 6L2.1 0L4.2 6',
  W: 'M0 6L1.4 0L3 4.4L4.6 0L6 6',
  X: 'M0 0L2 3L4 6M0 6L2 3L4 0',
  Y: 'M0 6L2.1 3L4.2 6M2.1 3L2.1 0',
  Z: 'M0 6L4 6L0 0L4 0',
  '0': 'M1.8 6Q0 6 0 3Q0 0 1.8 0Q3.6 0 3.6 3Q3.6 6 1.8 6',
  '1': 'M0 4.6L1.6 6L1.6 0',
  '2': 'M0 4.6Q.2 6 2 6Q3.8 6 3.8 4.5Q3.8 3.4 2.6 2.4L0 0L4 0',
  '3': 'M0 5Q.6 6 1.9 6Q3.6 6 3.6 4.7Q3.6 3.6 2 3.2M2 3.2Q4 2.8 4 1.5Q4 0 1.9 0Q.4 0 0 1.1',
  '4': 'M3 0L3 1.8L3 6L0 1.8L3 1.8L4.2 1.8',
  '5': 'M3.6 6L.6 6L.3 3.4Q1 3.8 1.9 3.8Q3.9 3.8 3.9 1.9Q3.9 0 1.9 0Q.5 0 0 1',
  '6': 'M3.5 5.6Q2.8 6 2.3 6Q.5 6 .1 2.8M.1 2.8Q-.4 0 2 0Q4 0 4 1.9Q4 3.8 2.1 3.8Q.8 3.8 .1 2.8',
  '7': 'M0 6L3.9 6L1.4 0',
  '8': 'M2 3.2Q.3 3.7 .3 4.7Q.3 6 2 6Q3.7 6 3.7 4.7Q3.7 3.7 2 3.2M2 3.2Q4.1 2.6 4.1 1.5Q4.1 0 2 0Q-.1 0 -.1 1.5Q-.1 2.6 2 3.2',
  '9': 'M.5 .4Q1.2 0 1.7 0Q3.5 0 3.9 3.2M3.9 3.2Q4.4 6 2 6Q0 6 0 4.1Q0 2.2 1.9 2.2Q3.2 2.2 3.9 3.2',
  '.': 'M0 0',
  ',': 'M.5 .4L0 -1',
  ':': 'M0 .8M0 3.6',
  ';': 'M.5 .8L0 -.6M.5 3.6',
  '!': 'M0 6L0 1.9M0 0',
  '?': 'M0 4.8Q.2 6 1.9 6Q3.7 6 3.7 4.5Q3.7 3.5 2.7 2.9Q1.8 2.4 1.8 1.8M1.8 0',
  '-': 'M0 3L2.6 3',
  '+': 'M0 3L1.6 3L3.2 3M1.6 4.6L1.6 3L1.6 1.4',
  '=': 'M0 4L3 4M0 2L3 2',
  '/': 'M0 0L3 6',
  '(': 'M1.2 6.4Q0 5 0 3Q0 1 1.2 -.4',
  ')': 'M0 6.4Q1.2 5 1.2 3Q1.2 1 0 -.4',
  "'": 'M0 6L0 4.4',
  '"': 'M0 6L0 4.4M1.4 6L1.4 4.4',
  '&': 'M4.2 0L3.45 1.01L1.75 3.3L1 4.3Q.5 5 .9 5.5Q1.3 6 1.9 6Q3 6 3 4.9Q3 4.1 1.75 3.3M1.75 3.3Q0 2.3 0 1.4Q0 0 1.7 0Q2.9 0 3.45 1.01L4.2 2.3',
};

/** Signs above or below a letter, about its middle. */
const kMarks: Readonly<Record<string, string>> = {
  '\u0300': 'M-.8 8L.4 7.1',
  '\u0301': 'M-.4 7.1L.8 8',
  '\u0302': 'M-1.1 7.1L0 8L1.1 7.1',
  '\u0303': 'M-1.3 7.2L-.5 7.8L.5 7.2L1.3 7.8',
  '\u0308': 'M-1 7.4M1 7.4',
  '\u030a': 'M0 8.5Q-.9 8.5 -.9 7.7Q-.9 6.9 0 6.9Q.9 6.9 .9 7.7Q.9 8.5 0 8.5',
  '\u030c': 'M-1.1 8L0 7.1L1.1 8',
  '\u0327': 'M0 0L.3 -.8L-.6 -1.5',
};

/** Between two letters, in heights of a capital. */
export const kBetween = 0.35;
/** All that the font has a drawing of. */
export const kStrokeChars: readonly string[] = Object.keys(kGlyphs);

function strokesOf(path: string, dx = 0): Stroke[] {
  const strokes: { points: GroundPoint[]; nodes: number[]; curved: boolean }[] = [];
  for (const [, command, words] of path.matchAll(/([MLQ])([^MLQ]*)/g)) {
    const numbers = words!.trim().split(/\s+/).map(Number);
    const at = (i: number): GroundPoint => ({ x: (numbers[i]! + dx) / kHigh, y: numbers[i + 1]! / kHigh });
    const stroke = strokes[strokes.length - 1];
    if (command === 'M' || !stroke) {
      strokes.push({ points: [at(0)], nodes: [0], curved: false });
      continue;
    }
    const from = stroke.points[stroke.points.length - 1]!;
    // Where two curves meet the pen goes on smoothly: nobody has to stand there.
    if (command === 'Q' && stroke.curved) stroke.nodes.pop();
    stroke.curved = command === 'Q';
    if (command === 'L') stroke.points.push(at(0));
    else stroke.points.push(...curve(from, at(0), at(2)));
    stroke.nodes.push(stroke.points.length - 1);
  }
  return strokes;
}

function curve(from: GroundPoint, control: GroundPoint, to: GroundPoint): GroundPoint[] {
  return Array.from({ length: kPieces }, (_, i) => {
    const t = (i + 1) / kPieces;
    const [a, b, c] = [(1 - t) ** 2, 2 * t * (1 - t), t * t];
    return { x: a * from.x + b * control.x + c * to.x, y: a * from.y + b * control.y + c * to.y };
  });
}

const widthOf = (strokes: readonly Stroke[]): number =>
  Math.max(0, ...strokes.flatMap(({ points }) => points.map(({ x }) => x)));

function letterOf(char: string, marks: readonly string[], x: number): StrokeLetter | null {
  const glyph = kGlyphs[char];
  if (glyph === undefined || marks.some((mark) => !(mark in kMarks))) return null;
  const plain = strokesOf(glyph);
  const width = widthOf(plain);
  const strokes = [...plain, ...marks.flatMap((mark) => strokesOf(kMarks[mark]!, (width * kHigh) / 2))];
  const moved = strokes.map(({ points, nodes }) => ({
    nodes,
    points: points.map((point) => ({ x: point.x + x, y: point.y })),
  }));
  return { char: char + marks.join(''), x, width, strokes: moved };
}

/** Quotes and dashes as the font has them. */
const plainSigns = (words: string): string =>
  words
    .replace(/[‘’´`]/g, "'")
    .replace(/[“”„«»]/g, '"')
    .replace(/[‐-―−]/g, '-');

/**
 * The letters of a word from left to right, with so much between two of them; null where one of them has no drawing.
 * Lower case is written in capitals.
 */
export function strokeLetters(words: string, between = kBetween): StrokeLetter[] | null {
  const letters: StrokeLetter[] = [];
  let x = 0;
  for (const [sign] of plainSigns(words)
    .toUpperCase()
    .normalize('NFD')
    .matchAll(/\P{M}\p{M}*/gu)) {
    const [char, ...marks] = [...sign];
    if (char === ' ') x += kSpace / kHigh + between / 2;
    if (/\s/.test(char!)) continue;
    const letter = letterOf(char!, marks, x);
    if (!letter) return null;
    letters.push(letter);
    x += letter.width + between;
  }
  return letters;
}
