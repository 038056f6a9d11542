// How dense an area is, and how fast people in it walk.

import { insidePolygon, turn, type GroundPoint } from '../plane';
import type { SpeedMemory } from './crowd_steps';
import { Series, type Sample } from './series';

export interface AreaSample extends Sample {
  readonly persons: number;
  /** Persons / area [1/m2]. */
  readonly density: number;
  /** Mean of those in the area; NaN where nobody is [m/s]. */
  readonly speed: number;
}

/** Of a polygon that does not cross itself [m2]. */
export function areaOf(polygon: readonly GroundPoint[]): number {
  const [first] = polygon;
  if (!first) return 0;
  let twice = 0;
  for (let k = 1; k + 1 < polygon.length; ++k) twice += turn(first, polygon[k]!, polygon[k + 1]!);
  return Math.abs(twice) / 2;
}

export class AreaRecord {
  readonly series = new Series<AreaSample>();
  readonly size: number;
  private readonly least_: GroundPoint;
  private readonly most_: GroundPoint;

  constructor(readonly polygon: readonly GroundPoint[]) {
    this.size = areaOf(polygon);
    const [xs, ys] = [polygon.map(({ x }) => x), polygon.map(({ y }) => y)];
    this.least_ = { x: Math.min(...xs), y: Math.min(...ys) };
    this.most_ = { x: Math.max(...xs), y: Math.max(...ys) };
  }

  private holds(x: number, y: number): boolean {
    const { least_: least, most_: most } = this;
    return x >= least.x && x <= most.x && y >= least.y && y <= most.y && insidePolygon({ x, y }, this.polygon);
  }

  observe(memory: SpeedMemory, ring: number): void {
    const middle = memory.middle();
    if (!middle || !this.series.isDue(middle.at.time)) return;
    const { at } = middle;
    let [persons, sum, walkers] = [0, 0, 0];
    for (let i = 0; i < at.x.length; ++i) {
      if (!this.holds(at.x[i]!, at.y[i]!)) continue;
      persons += 1;
      const speed = middle.speed(i, ring);
      if (!Number.isFinite(speed)) continue;
      sum += speed;
      walkers += 1;
    }
    const density = persons / Math.max(1e-9, this.size);
    this.series.add({ time: at.time, persons, density, speed: walkers > 0 ? sum / walkers : NaN });
  }
}
