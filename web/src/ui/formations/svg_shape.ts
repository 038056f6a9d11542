// An SVG file as places: along its lines, and over its areas.

import { cleanSvg } from '../../model/letters/clean_svg';
import type { Stroke } from '../../model/letters/stroke_font';
import { leastDistance, placesApart } from '../../model/letters/stroke_places';
import { maskOfPixels, readSize } from '../../model/picture_mask';
import { distance, type GroundPoint, lengthOf } from '../../model/plane';
import { spreadOver, type Mask } from '../../model/spread';
import { element } from '../widgets/dom';

/** It is read at this size [px]. */
const kSize = 400;
/** A line is sampled so finely [px], by at most so many points. */
const kStep = 2;
const kMostSamples = 3000;
/** Where a line turns by more [rad] within two samples, somebody stands on the corner. */
const kCorner = 0.6;
/** Of a triangular lattice: the share of its square that one takes. */
const kLattice = Math.sqrt(3) / 2;
/** People in areas keep so far from lines, and the nearest two so far from each other, in gaps. */
const kOff = 0.8;
const kNear = 0.6;
const kHidden = 'defs, symbol, clipPath';

export interface SvgPlaces {
  /** About the middle, y up. */
  readonly places: readonly GroundPoint[];
  readonly gap: number;
}

const isNone = (paint: string, opacity: string): boolean => paint === 'none' || Number(opacity) === 0;

/** A line's samples on the picture, divided where the pen was lifted. */
function strokesOf(shape: SVGGeometryElement, frame: DOMRect): Stroke[] {
  const length = shape.getTotalLength();
  const matrix = shape.getScreenCTM();
  if (!(length > 0) || !matrix) return [];
  const scale = Math.sqrt(Math.abs(matrix.a * matrix.d - matrix.b * matrix.c)) || 1;
  const count = Math.min(kMostSamples, Math.max(8, Math.ceil((length * scale) / kStep)));
  const step = (length * scale) / count;
  const strokes: { points: GroundPoint[]; nodes: number[] }[] = [];
  for (let i = 0; i <= count; ++i) {
    const { x, y } = shape.getPointAtLength((length * i) / count).matrixTransform(matrix);
    const point = { x: x - frame.left, y: y - frame.top };
    const last = strokes[strokes.length - 1];
    const before = last?.points[last.points.length - 1];
    if (last && before && distance(before, point) < 1.5 * step + 1e-6) last.points.push(point);
    else strokes.push({ points: [point], nodes: [] });
  }
  return strokes.filter(({ points }) => points.length > 1).map(({ points }) => ({ points, nodes: cornersOf(points) }));
}

function cornersOf(points: readonly GroundPoint[]): number[] {
  const nodes = [0];
  const reach = 2;
  for (let i = reach; i + reach < points.length; ++i) {
    const [a, b, c] = [points[i - reach]!, points[i]!, points[i + reach]!];
    const turn = Math.atan2(c.y - b.y, c.x - b.x) - Math.atan2(b.y - a.y, b.x - a.x);
    if (Math.abs(Math.atan2(Math.sin(turn), Math.cos(turn))) < kCorner) continue;
    if (i - nodes[nodes.length - 1]! > 2 * reach) nodes.push(i);
  }
  return [...nodes, points.length - 1];
}

/** Takes the lines out of a drawing that is in the page. */
function takeLines(svg: Element, frame: DOMRect): Stroke[] {
  const shapes = [...svg.querySelectorAll<SVGGeometryElement>('path, rect, circle, ellipse, line, polyline, polygon')];
  return shapes.flatMap((shape) => {
    const { display, fill, fillOpacity, stroke, strokeOpacity } = getComputedStyle(shape);
    const drawn = display !== 'none' && !isNone(stroke, strokeOpacity) && shape.closest(kHidden) === null;
    const filled = shape.localName !== 'line' && !isNone(fill, fillOpacity);
    if (!drawn || filled) return [];
    const strokes = strokesOf(shape, frame);
    shape.remove();
    return strokes;
  });
}

/** What is left, as cells: what is dark, or all that is painted where nothing is. */
async function areasOf(svg: Element, width: number, height: number): Promise<Mask> {
  const nothing = { width, height, cells: new Uint8Array(width * height) };
  const url = URL.createObjectURL(new Blob([new XMLSerializer().serializeToString(svg)], { type: 'image/svg+xml' }));
  const picture = new Image();
  picture.src = url;
  const ready = await picture.decode().then(
    () => true,
    () => false,
  );
  URL.revokeObjectURL(url);
  const pen = element('canvas', { width, height }).getContext('2d', { willReadFrequently: true });
  if (!ready || !pen) return nothing;
  pen.drawImage(picture, 0, 0, width, height);
  const { data } = pen.getImageData(0, 0, width, height);
  const mask = maskOfPixels(data, width, height);
  if (Array.from(mask.cells).some((cell) => cell > 0)) return mask;
  return { ...nothing, cells: nothing.cells.map((_, i) => (data[4 * i + 3]! > 127 ? 1 : 0)) };
}

/** The size at which it is read, by its view box or what it says of itself. */
function sized(svg: Element): { readonly width: number; readonly height: number } {
  const box = (svg.getAttribute('viewBox') ?? '')
    .trim()
    .split(/[\s,]+/)
    .map(Number);
  const own = ['width', 'height'].map((name) => parseFloat(svg.getAttribute(name) ?? ''));
  const [wide = 300, high = 150] =
    box.length === 4 && box[2]! > 0 && box[3]! > 0 ? box.slice(2) : own.map((n) => n || 300);
  if (!svg.hasAttribute('viewBox')) svg.setAttribute('viewBox', `0 0 ${wide} ${high}`);
  const { width, height } = readSize(wide * 1e3, high * 1e3, kSize);
  svg.setAttribute('width', String(width));
  svg.setAttribute('height', String(height));
  return { width, height };
}

/** Free of those who stand along lines. */
function awayFrom({ width, height, cells }: Mask, places: readonly GroundPoint[], reach: number): Mask {
  const free = Uint8Array.from({ length: width * height }, (_, i) => cells[i] ?? 0);
  for (const { x, y } of places)
    for (let row = Math.max(0, Math.ceil(y - reach)); row < Math.min(height, y + reach); ++row)
      for (let column = Math.max(0, Math.ceil(x - reach)); column < Math.min(width, x + reach); ++column)
        if (Math.hypot(column - x, row - y) < reach) free[row * width + column] = 0;
  return { width, height, cells: free };
}

/** How many people of so many stand along lines, where all stand equally far apart, and that distance. */
function shared(length: number, area: number, count: number): { readonly onLines: number; readonly gap: number } {
  // count = length / gap + area / (kLattice * gap^2)
  const gap = (length + Math.sqrt(length * length + (4 * count * area) / kLattice)) / (2 * count);
  const onLines = area > 0 ? Math.min(count, Math.round(length / Math.max(gap, 1e-9))) : count;
  return { onLines: length > 0 ? onLines : 0, gap };
}

async function placesOf(svg: Element, strokes: readonly Stroke[], count: number): Promise<SvgPlaces | null> {
  const [width, height] = ['width', 'height'].map((name) => Number(svg.getAttribute(name))) as [number, number];
  const mask = await areasOf(svg, width, height);
  const area = Array.from(mask.cells).reduce((sum, cell) => sum + cell, 0);
  const length = strokes.reduce((sum, { points }) => sum + lengthOf(points), 0);
  const { onLines, gap } = shared(length, area, count);
  const lines = onLines > 0 ? placesApart(strokes, onLines) : { places: [], gap };
  if (!lines) return null;
  const rest = count - lines.places.length;
  const areas = rest > 0 ? spreadOver(awayFrom(mask, lines.places, kOff * gap), rest).places : [];
  if (areas.length < rest) return null;
  const middle = { x: (width - 1) / 2, y: (height - 1) / 2 };
  const places = [...lines.places.map(({ x, y }) => ({ x: x - middle.x, y: middle.y - y })), ...areas];
  return { places, gap: Math.min(gap, leastDistance(places) / kNear) };
}

/** So many places in an SVG file; null where it is none, or has no room for them. */
export async function svgPlaces(text: string, count: number): Promise<SvgPlaces | null> {
  const svg = cleanSvg(text);
  if (!svg || count < 1) return null;
  const { width, height } = sized(svg);
  // In a tree of its own, its styles do not reach the page.
  const host = element('div', { 'aria-hidden': 'true', class: 'svg-reading' });
  host.style.cssText = `position:fixed;left:0;top:0;width:${width}px;height:${height}px;opacity:0;pointer-events:none`;
  const shown = document.importNode(svg, true);
  host.attachShadow({ mode: 'closed' }).append(shown);
  document.body.append(host);
  try {
    return await placesOf(shown, takeLines(shown, shown.getBoundingClientRect()), count);
  } finally {
    host.remove();
  }
}
