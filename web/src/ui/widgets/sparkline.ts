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

const kSamples = 48;
const kWidth = 92;
const kHeight = 14;

/** `limit`: a dashed line, the most that is good; 0 for none. */
export class Sparkline {
  readonly root: SVGSVGElement;
  private readonly line_: SVGPolylineElement;
  private readonly end_: SVGCircleElement;
  private readonly guide_: SVGLineElement;
  private readonly values_: number[] = [];

  constructor(
    private readonly limit_: number,
    private readonly leastTop_: number,
  ) {
    const template = document.createElement('template');
    template.innerHTML =
      `<svg class="spark" viewBox="-2 -3 ${kWidth + 5} ${kHeight + 6}" preserveAspectRatio="none" aria-hidden="true">` +
      `<line class="guide" x1="0" x2="${kWidth}"/><polyline/><circle r="2"/></svg>`;
    this.root = template.content.firstElementChild as SVGSVGElement;
    this.line_ = this.root.querySelector('polyline')!;
    this.end_ = this.root.querySelector('circle')!;
    this.guide_ = this.root.querySelector('line')!;
    if (limit_ <= 0) this.guide_.remove();
  }

  push(value: number): void {
    this.values_.push(Number.isFinite(value) ? value : 0);
    if (this.values_.length > kSamples) this.values_.shift();
    // Some air above the highest value.
    const top = Math.max(this.leastTop_, this.limit_, 1.2 * Math.max(...this.values_));
    const points = sparklinePoints(this.values_, kWidth, kHeight, top);
    this.line_.setAttribute('points', points);
    const last = points.slice(points.lastIndexOf(' ') + 1).split(',');
    this.end_.setAttribute('cx', last[0] ?? '0');
    this.end_.setAttribute('cy', last[1] ?? '0');
    const y = String(kHeight - (this.limit_ / top) * kHeight);
    this.guide_.setAttribute('y1', y);
    this.guide_.setAttribute('y2', y);
  }
}
