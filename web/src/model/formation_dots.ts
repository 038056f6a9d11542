// Formations as dots, 34 by 34: icons, and small marks on the ground.

import type { FormationWords } from './sequence';

export type Dot = readonly [number, number];

export const kSize = 34;
const kMiddle = kSize / 2;

function block(columns: number, rows: number, pitch: number): Dot[] {
  const dots: Dot[] = [];
  for (let row = 0; row < rows; ++row) {
    for (let column = 0; column < columns; ++column) {
      dots.push([kMiddle + (column - (columns - 1) / 2) * pitch, kMiddle + (row - (rows - 1) / 2) * pitch]);
    }
  }
  return dots;
}

/** `from` and `to` in turns, clockwise from the right. */
function arc(radius: number, count: number, from = 0, to = 1): Dot[] {
  const closed = to - from >= 1;
  return Array.from({ length: count }, (_, i) => {
    const angle = 2 * Math.PI * (from + ((to - from) * i) / (closed ? count : count - 1));
    return [kMiddle + radius * Math.cos(angle), kMiddle + radius * Math.sin(angle)] as const;
  });
}

function wedge(): Dot[] {
  const dots: Dot[] = [];
  for (let row = 0; row < 4; ++row) {
    for (let i = 0; i <= row; ++i) dots.push([kMiddle + (i - row / 2) * 7.6, 6.5 + row * 7]);
  }
  return dots;
}

const kLetter: readonly Dot[] = [
  [17, 6],
  [14.6, 11.5],
  [19.4, 11.5],
  [12.2, 17],
  [21.8, 17],
  [17, 19.5],
  [9.8, 22.5],
  [24.2, 22.5],
  [7.4, 28],
  [26.6, 28],
];

const kDrawn: readonly Dot[] = [
  [11, 9.5],
  [7.5, 14],
  [7.5, 19.5],
  [10.5, 24],
  [15.5, 26.5],
  [21, 26],
  [25.5, 22.5],
  [26, 17],
  [22, 13.5],
  [17.5, 15.5],
  [16, 20],
];

const kDots: Readonly<Record<string, readonly Dot[]>> = {
  square: block(4, 4, 7),
  line: block(6, 2, 5.4),
  column: block(2, 6, 5.4),
  wedge: wedge(),
  ring: arc(11.5, 12),
  circle: [...arc(0, 1), ...arc(6.2, 6), ...arc(12.4, 12)],
  crescent: [...arc(12, 8, 0.11, 0.89), ...arc(6.6, 4, 0.2, 0.8)],
  pacman: [...arc(0.01, 1), ...arc(6.4, 5, 0.12, 0.88), ...arc(12.4, 9, 0.11, 0.89)],
  text: kLetter,
  draw: kDrawn,
  more: [
    [8, kMiddle],
    [kMiddle, kMiddle],
    [26, kMiddle],
  ],
};

/** Of shapes of one's own no more dots are shown. */
const kMostDots = 40;
const kRim = 5;

export function dotsOf(name: string): readonly Dot[] {
  return kDots[name] ?? kDots['square']!;
}

function isPairs(value: unknown): value is [number, number][] {
  return Array.isArray(value) && value.length > 0 && Array.isArray(value[0]);
}

/** A formation as an order has it, seen from behind: ahead is up. */
export function dotsOfFormation(formation: FormationWords): readonly Dot[] {
  const own = [formation['points'], formation['outline']].find(isPairs);
  if (!own) return dotsOf(formation.kind);
  const step = Math.max(1, Math.ceil(own.length / kMostDots));
  const seen = own.filter((_, i) => i % step === 0).map(([x, y]): Dot => [-y, -x]);
  const [xs, ys] = [seen.map(([x]) => x), seen.map(([, y]) => y)];
  const [left, top] = [Math.min(...xs), Math.min(...ys)];
  const [width, height] = [Math.max(...xs) - left, Math.max(...ys) - top];
  const scale = (kSize - 2 * kRim) / Math.max(width, height, 1e-6);
  return seen.map(([x, y]) => [kMiddle + scale * (x - left - width / 2), kMiddle + scale * (y - top - height / 2)]);
}
