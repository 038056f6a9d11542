// A short history as a line.

/** Points of an SVG polyline in a box of `width` by `height`, oldest first; `top` is the value at the upper edge. */
export function sparklinePoints(values: readonly number[], width: number, height: number, top: number): string {
  const last = Math.max(1, values.length - 1);
  const scale = top > 0 ? height / top : 0;
  return values
    .map((value, i) => {
      const y = height - Math.min(height, Math.max(0, value * scale));
      return `${((i / last) * width).toFixed(1)},${y.toFixed(1)}`;
    })
    .join(' ');
}

const SAMPLES = 48;
const WIDTH = 92;
const HEIGHT = 14;

/** `limit`: a dashed line, the most that is good; 0 for none. */
export class Sparkline {
  readonly root: SVGSVGElement;
  private readonly line: SVGPolylineElement;
  private readonly end: SVGCircleElement;
  private readonly guide: SVGLineElement;
  private readonly values: number[] = [];

  constructor(private readonly limit: number, private readonly leastTop: number) {
    const template = document.createElement('template');
    template.innerHTML =
      `<svg class="spark" viewBox="-2 -3 ${WIDTH + 5} ${HEIGHT + 6}" preserveAspectRatio="none" aria-hidden="true">` +
      `<line class="guide" x1="0" x2="${WIDTH}"/><polyline/><circle r="2"/></svg>`;
    this.root = template.content.firstElementChild as SVGSVGElement;
    this.line = this.root.querySelector('polyline')!;
    this.end = this.root.querySelector('circle')!;
    this.guide = this.root.querySelector('line')!;
    if (limit <= 0) this.guide.remove();
  }

  push(value: number): void {
    this.values.push(Number.isFinite(value) ? value : 0);
    if (this.values.length > SAMPLES) this.values.shift();
    // Some air above the highest value.
    const top = Math.max(this.leastTop, this.limit, 1.2 * Math.max(...this.values));
    const points = sparklinePoints(this.values, WIDTH, HEIGHT, top);
    this.line.setAttribute('points', points);
    const last = points.slice(points.lastIndexOf(' ') + 1).split(',');
    this.end.setAttribute('cx', last[0] ?? '0');
    this.end.setAttribute('cy', last[1] ?? '0');
    const y = String(HEIGHT - (this.limit / top) * HEIGHT);
    this.guide.setAttribute('y1', y);
    this.guide.setAttribute('y2', y);
  }
}
