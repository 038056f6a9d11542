// Formations as dots, 34 by 34.

type Dot = readonly [number, number];

const kSize = 34;
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

export function formationIcon(name: string): SVGSVGElement {
  const dots = (kDots[name] ?? kDots['square']!).map(([x, y]) => {
    return `<circle cx="${x.toFixed(1)}" cy="${y.toFixed(1)}" r="2.2"/>`;
  });
  const template = document.createElement('template');
  template.innerHTML =
    `<svg width="${kSize}" height="${kSize}" viewBox="0 0 ${kSize} ${kSize}" fill="currentColor" aria-hidden="true">` +
    `${dots.join('')}</svg>`;
  return template.content.firstElementChild as SVGSVGElement;
}
