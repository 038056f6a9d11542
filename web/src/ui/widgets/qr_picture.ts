// A QR code as a picture: black on white in both themes, with the quiet zone that readers need.

const kSvg = 'http://www.w3.org/2000/svg';
/** Modules of white round the code. */
const kQuietZone = 4;

/** `rows` of "1" for dark and "0" for light. */
export function qrPicture(rows: readonly string[]): SVGSVGElement {
  const size = rows.length + 2 * kQuietZone;
  const picture = document.createElementNS(kSvg, 'svg');
  picture.setAttribute('viewBox', `0 0 ${size} ${size}`);
  picture.setAttribute('class', 'qr');
  picture.setAttribute('role', 'img');
  picture.setAttribute('aria-label', 'QR code of the link');
  const ground = document.createElementNS(kSvg, 'rect');
  ground.setAttribute('width', String(size));
  ground.setAttribute('height', String(size));
  ground.setAttribute('fill', '#fff');
  const dark = document.createElementNS(kSvg, 'path');
  dark.setAttribute('fill', '#000');
  dark.setAttribute('shape-rendering', 'crispEdges');
  dark.setAttribute('d', rows.flatMap((row, y) => runs(row).map(([x, n]) => run(x, y, n))).join(''));
  picture.append(ground, dark);
  return picture;
}

function run(x: number, y: number, length: number): string {
  return `M${x + kQuietZone} ${y + kQuietZone}h${length}v1h-${length}z`;
}

/** Where dark begins in a row, and for how long. */
function runs(row: string): [number, number][] {
  return [...row.matchAll(/1+/g)].map((found) => [found.index, found[0].length]);
}
