// How well letters made of people can be read: what an eye sees of them is compared with every letter of the font.
//
// Dots melt into lines for an eye that is so far away that it no longer tells neighbours apart. A letter is seen that way,
// and so is each letter of the font as it should be. It can be read where it looks like itself, and not almost as much like
// another letter.

import type { GroundPoint } from '../plane';

/** What a letter looks like: how much stands in each cell of a box, in heights of a capital. */
export type Seen = Float64Array;

/** Cells of a capital's height, and the box about a letter's middle. */
const kCells = 20;
const kBox = { left: -0.9, right: 0.9, low: -0.5, high: 1.6 };
const kWide = Math.round((kBox.right - kBox.left) * kCells);
const kTall = Math.round((kBox.high - kBox.low) * kCells);
/** The eye melts what lies within this share of the gap between neighbours. */
const kMelt = 0.5;
/** A letter looks at least so much like itself. */
const kLike = 0.8;
/** Of what sets two letters apart when they are sharp, a letter shows so much. */
const kApart = 0.25;
/** Letters that are as much alike as this even when sharp are one and the same to an eye. */
const kSame = 0.97;

/** A letter as it should be: even samples of its lines or its area, each for so much of a person, and single dots. */
export interface LetterDrawn {
  readonly samples: readonly GroundPoint[];
  /** Between samples of a line, in heights of a capital. */
  readonly step: number;
  /** Single persons. */
  readonly dots: readonly GroundPoint[];
}

export interface LetterSeen {
  readonly char: string;
  /** Where its people stand, in heights of a capital, its baseline at 0. */
  readonly places: readonly GroundPoint[];
}

export interface Legibility {
  readonly reads: boolean;
  /** From 0 to 1: of the letter that is read worst. */
  readonly share: number;
  /** The letters that cannot be read, each once. */
  readonly unread: readonly string[];
}

/** Places as dots in the cells of the box, centred; the first few count as one person each, the others so much. */
function seenOf(places: readonly GroundPoint[], whole = places.length, share = 1): Seen {
  const cells = new Float64Array(kWide * kTall);
  const xs = places.map(({ x }) => x);
  const middle = (Math.min(...xs) + Math.max(...xs)) / 2;
  places.forEach(({ x, y }, k) => {
    const weight = k < whole ? 1 : share;
    // A dot between cells is shared by the four about it, so that it has no grid of its own.
    const [u, v] = [(x - middle - kBox.left) * kCells - 0.5, (y - kBox.low) * kCells - 0.5];
    const [column, row] = [Math.floor(u), Math.floor(v)];
    for (const c of [column, column + 1])
      for (const r of [row, row + 1]) {
        if (c < 0 || r < 0 || c >= kWide || r >= kTall) continue;
        const at = r * kWide + c;
        cells[at] = cells[at]! + weight * (1 - Math.abs(u - c)) * (1 - Math.abs(v - r));
      }
  });
  return cells;
}

/** As a far eye sees it: a normal distribution of this width, in cells, for every dot. */
function melted(seen: Seen, width: number): Seen {
  const reach = Math.ceil(3 * width);
  const weights = Array.from({ length: 2 * reach + 1 }, (_, i) => Math.exp(-((i - reach) ** 2) / (2 * width * width)));
  const along = (from: Seen, step: number, length: number): Seen => {
    const out = new Float64Array(from.length);
    for (let i = 0; i < from.length; ++i) {
      if (from[i] === 0) continue;
      const at = step === 1 ? i % kWide : Math.floor(i / kWide);
      const [first, last] = [Math.max(-reach, -at), Math.min(reach, length - 1 - at)];
      for (let k = first; k <= last; ++k) {
        const to = i + k * step;
        out[to] = out[to]! + from[i]! * weights[k + reach]!;
      }
    }
    return out;
  };
  return along(along(seen, 1, kWide), kWide, kTall);
}

/** However many dots it has. */
function normed(seen: Seen): Seen {
  const size = Math.sqrt(seen.reduce((sum, one) => sum + one * one, 0));
  return size > 0 ? seen.map((one) => one / size) : seen;
}

/** From 0 to 1. */
function likeness(a: Seen, b: Seen): number {
  let sum = 0;
  for (let i = 0; i < a.length; ++i) sum += a[i]! * b[i]!;
  return sum;
}

/** Distances from which a font is seen: each so many times the one before, so that few have to be drawn. */
const kStep = 1.06;

export class LetterReader {
  private readonly seen_ = new Map<string, Seen>();

  /** `draw`: a letter of a font as it should be; `font`: those that every letter could be taken for. */
  constructor(
    private readonly draw_: (char: string) => LetterDrawn,
    private readonly font_: readonly string[],
  ) {}

  /** How the letters of a word are read where neighbours stand so far apart, in heights of a capital. */
  read(letters: readonly LetterSeen[], gap: number): Legibility {
    const others = [...new Set([...this.font_, ...letters.map(({ char }) => char)])];
    const shares = letters.map((letter) => ({ char: letter.char, share: this.share(letter, gap, others) }));
    const unread = [...new Set(shares.filter(({ share }) => share < 1).map(({ char }) => char))];
    const worst = Math.min(1, ...shares.map(({ share }) => share));
    return { reads: letters.length > 0 && unread.length === 0, share: Math.max(0, worst), unread };
  }

  /** A letter of the font, from one of the distances. */
  private seenFrom(step: number, char: string): Seen {
    const key = `${step} ${char}`;
    const known = this.seen_.get(key);
    if (known) return known;
    const width = kStep ** step;
    const { samples, step: length, dots } = this.draw_(char);
    const share = (length * kMelt * kCells) / width;
    const seen = normed(melted(seenOf([...dots, ...samples], dots.length, share), width));
    this.seen_.set(key, seen);
    return seen;
  }

  private share({ char, places }: LetterSeen, gap: number, others: readonly string[]): number {
    if (places.length === 0) return 0;
    const step = Math.max(0, Math.round(Math.log(kMelt * gap * kCells) / Math.log(kStep)));
    const own = this.seenFrom(0, char);
    const shown = normed(melted(seenOf(places), kStep ** step));
    const like = likeness(shown, this.seenFrom(step, char));
    let worst = like / kLike;
    for (const other of others) {
      const alike = likeness(own, this.seenFrom(0, other));
      if (other === char || alike > kSame) continue;
      const apart = (like - likeness(shown, this.seenFrom(step, other))) / (1 - alike);
      worst = Math.min(worst, apart / kApart);
    }
    return worst;
  }
}
