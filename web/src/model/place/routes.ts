// Ways of things that move: from a drawn line, and where they stand at a time.

import type { TimedPath, Vec2, Waypoint } from '../../protocol/generated/commands';
import { distance, type GroundPoint } from '../plane';
import { moved, thing, type Thing } from './things';

/** Points of a route lie so far apart [m]. */
const kRouteStep = 0.5;
/** Length and width of a car, and its height [m]. */
const kCar = { length: 4.2, width: 1.8, height: 1.5 };

/** Where a path leads at a time, as the engine has it. */
export function placeOn({ waypoints, loop }: TimedPath, time: number): Omit<Waypoint, 'time'> {
  const [first, last] = [waypoints[0]!, waypoints[waypoints.length - 1]!];
  const period = last.time - first.time;
  const at = loop && period > 0 && time > first.time ? first.time + ((time - first.time) % period) : time;
  const next = waypoints.findIndex((one) => one.time > at);
  if (next <= 0) return next < 0 ? last : first;
  const [a, b] = [waypoints[next - 1]!, waypoints[next]!];
  const share = (at - a.time) / (b.time - a.time);
  const mix = (from: number, to: number): number => from + (to - from) * share;
  return {
    position: [mix(a.position[0], b.position[0]), mix(a.position[1], b.position[1])],
    angle: mix(a.angle, b.angle),
  };
}

/** The corners turned about their middle. */
function turnedCorners(one: Thing, angle: number): Thing {
  if (angle === 0 || !one.polygon) return one;
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const [mx, my] = areaMiddle(one.polygon);
  return { ...one, polygon: one.polygon.map(([x, y]) => turnedBy([x - mx, y - my], c, s, [mx, my])) };
}

function turnedBy([x, y]: Vec2, c: number, s: number, [mx, my]: Vec2): Vec2 {
  return [mx + c * x - s * y, my + s * x + c * y];
}

/** The centre of area, about which a path turns a thing. */
function areaMiddle(polygon: readonly Vec2[]): Vec2 {
  let [area, mx, my] = [0, 0, 0];
  const [ox, oy] = polygon[0]!;
  polygon.forEach(([x0, y0], k) => {
    const [x1, y1] = polygon[(k + 1) % polygon.length]!;
    const part = (x0 - ox) * (y1 - oy) - (x1 - ox) * (y0 - oy);
    area += part;
    mx += part * (x0 + x1 - 2 * ox);
    my += part * (y0 + y1 - 2 * oy);
  });
  return area === 0 ? [ox, oy] : [ox + mx / (3 * area), oy + my / (3 * area)];
}

/** The thing where it stands at that time of the world [s]; things that do not move are as they are. */
export function standing(one: Thing, time: number): Thing {
  if (!one.path) return one;
  const { position, angle } = placeOn(one.path, time);
  return moved(turnedCorners(one, angle), ...position);
}

/** What has to be told of a thing that stands like this at that time. */
export function defined(one: Thing, time: number): Thing {
  if (!one.path) return one;
  const { position, angle } = placeOn(one.path, time);
  return turnedCorners(moved(one, -position[0], -position[1]), -angle);
}

/** A change of what is told of a thing, for one that stands like this at that time. */
export function changedAt(one: Thing, time: number, change: (one: Thing) => Thing): Thing {
  return standing(change(defined(one, time)), time);
}

/** The loop begun so much later, so that its first point is where it leads at `now`. */
function begunAt(waypoints: readonly Waypoint[], now: number): Waypoint[] {
  const last = waypoints[waypoints.length - 1]!;
  const phase = now % last.time;
  const cut = last.time - phase;
  if (phase < 1e-3 || cut < 1e-3) return [...waypoints];
  const round = last.angle - waypoints[0]!.angle;
  const start = { time: 0, ...placeOn({ waypoints, loop: false }, cut) };
  const after = waypoints.filter(({ time }) => time > cut + 1e-3).map((one) => ({ ...one, time: one.time - cut }));
  const before = waypoints
    .filter(({ time }) => time > 1e-3 && time < cut - 1e-3)
    .map((one) => ({ ...one, time: one.time + phase, angle: one.angle + round }));
  return [start, ...after, ...before, { ...start, time: last.time, angle: start.angle + round }];
}

function thinned(line: readonly GroundPoint[]): GroundPoint[] {
  const kept: GroundPoint[] = [];
  for (const p of line) if (kept.length === 0 || distance(p, kept[kept.length - 1]!) >= kRouteStep) kept.push(p);
  return kept;
}

const headingOf = (a: GroundPoint, b: GroundPoint): number => Math.atan2(b.y - a.y, b.x - a.x);

/** Turns along a way, none of them more than half round. */
function turnsAlong(way: readonly GroundPoint[]): number[] {
  let before = 0;
  const first = headingOf(way[0]!, way[1]!);
  return way.map((p, k) => {
    const next = way[k + 1];
    const heading = (next ? headingOf(p, next) : headingOf(way[k - 1]!, p)) - first;
    return (before += heading - before - 2 * Math.PI * Math.round((heading - before) / (2 * Math.PI)));
  });
}

/** The thing moves along a drawn line and back, or round where the line ends near its beginning. At `now`, a time of the
 * world [s], it is where it stands. `steers`: it heads along its way. */
export function routed(one: Thing, line: readonly GroundPoint[], speed: number, now = 0, steers = false): Thing {
  const kept = thinned(line);
  if (kept.length < 2) return { ...one, path: null };
  const first = kept[0]!;
  const closes = distance(first, kept[kept.length - 1]!) < 3 * kRouteStep && kept.length > 6;
  const there = closes ? [...kept.slice(0, -1), first] : kept;
  const turns = steers ? turnsAlong(there) : there.map(() => 0);
  const out = there.map((p, k) => [p, turns[k]!] as const);
  const way = closes ? out : [...out, ...[...out].reverse().slice(1)];
  let time = 0;
  const waypoints = way.map(([p, angle], k) => {
    if (k > 0) time += distance(p, way[k - 1]![0]) / Math.max(0.05, speed);
    return { time, position: [p.x - first.x, p.y - first.y] as const, angle };
  });
  // A round ends as it began, however sharp its last corner is.
  if (closes) {
    const last = waypoints[waypoints.length - 1]!;
    waypoints[waypoints.length - 1] = { ...last, angle: 2 * Math.PI * Math.round(last.angle / (2 * Math.PI)) };
  }
  return { ...one, path: { waypoints: begunAt(waypoints, now), loop: true } };
}

/** A car that drives along the line; null for a press. */
export function carAlong(line: readonly GroundPoint[], speed: number, now: number): Thing | null {
  const [first, second] = thinned(line);
  if (!first || !second) return null;
  const heading = headingOf(first, second);
  const [c, s] = [Math.cos(heading), Math.sin(heading)];
  const [l, w] = [kCar.length / 2, kCar.width / 2];
  const corners: readonly Vec2[] = [
    [-l, -w],
    [l, -w],
    [l, w],
    [-l, w],
  ];
  const polygon = corners.map((p) => turnedBy(p, c, s, [first.x, first.y]));
  const car = thing('obstacle', { name: 'Car', polygon, centre: [first.x, first.y], height: kCar.height });
  return routed(car, line, speed, now, true);
}
