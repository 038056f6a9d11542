// From a drag on the ground to where each chosen group shall stand: its place, facing and width, and the places to show
// before the button is released.

import type { MoveTarget } from './commands';
import { frontLine, frontOf, isRanked, outlineOf, placed, widened, type GroupShape } from './group_shapes';
import { distance, type GroundPoint } from './plane';

/** A group that gets an order. */
export interface OrderedGroup {
  readonly id: number;
  /** Index into the frame's groups. */
  readonly index: number;
  readonly at: GroundPoint;
  /** [rad] */
  readonly facing: number;
  readonly shape: GroupShape;
}

/** What one group shall do, and how it would stand. */
export interface PlannedMove extends MoveTarget {
  readonly group: number;
  readonly index: number;
  readonly places: readonly GroundPoint[];
  readonly outline: readonly GroundPoint[];
  /** Where the front would be, left to right. */
  readonly front: readonly [GroundPoint, GroundPoint];
}

/** Between the fronts of neighbours in one line [m]. */
const kGap = 1.5;
/** Points of a drawn way lie so far apart [m]. */
const kRouteStep = 1;

function middle(groups: readonly OrderedGroup[]): GroundPoint {
  const total = groups.reduce((sum, { at }) => ({ x: sum.x + at.x, y: sum.y + at.y }), { x: 0, y: 0 });
  return { x: total.x / groups.length, y: total.y / groups.length };
}

/** How a group would stand with its centre at `target`. */
function stand(
  group: OrderedGroup,
  target: GroundPoint,
  facing: number,
  move: Partial<MoveTarget>,
  local: readonly GroundPoint[] = group.shape.places,
): PlannedMove {
  const places = placed(local, target, facing);
  const [left, right] = placed(frontLine(local), target, facing);
  return {
    group: group.id,
    index: group.index,
    target,
    facing: null,
    width: 0,
    route: [],
    formation: null,
    ...move,
    places,
    outline: outlineOf(places),
    front: [left!, right!],
  };
}

/** What makes a group take up a front as wide as it is drawn; shapes that are not of ranks stay as they are. */
function frontOfWidth(shape: GroupShape, width: number): Partial<MoveTarget> {
  if (!isRanked(shape)) return {};
  return shape.formation === 'square' ? { width } : { width, formation: { kind: 'square', spacing: shape.spacing } };
}

/** All go to a point, and keep how they stand to each other. */
export function planPoint(groups: readonly OrderedGroup[], to: GroundPoint): PlannedMove[] {
  const from = middle(groups);
  return groups.map((group) => {
    const target = { x: to.x + group.at.x - from.x, y: to.y + group.at.y - from.y };
    const away = Math.atan2(target.y - group.at.y, target.x - group.at.x);
    return stand(group, target, distance(target, group.at) > 1 ? away : group.facing, {});
  });
}

/**
 * They share a front from left to right by their numbers, in the order in which they stand along it now, so that nobody
 * crosses another's way. They face to its left-hand side.
 */
export function planLine(groups: readonly OrderedGroup[], left: GroundPoint, right: GroundPoint): PlannedMove[] {
  const length = distance(left, right);
  if (length === 0) return planPoint(groups, left);
  const along = { x: (right.x - left.x) / length, y: (right.y - left.y) / length };
  const ahead = { x: -along.y, y: along.x };
  const facing = Math.atan2(ahead.y, ahead.x);
  const order = [...groups].sort((a, b) => a.at.x * along.x + a.at.y * along.y - (b.at.x * along.x + b.at.y * along.y));
  const people = order.reduce((sum, { shape }) => sum + shape.places.length, 0);
  const room = Math.max(0, length - kGap * (order.length - 1));
  let begin = 0;
  return order.map((group) => {
    const width = people > 0 ? (room * group.shape.places.length) / people : 0;
    const local = widened(group.shape, width);
    const [at, back] = [begin + width / 2, frontOf(local)];
    begin += width + kGap;
    const target = {
      x: left.x + along.x * at - ahead.x * back,
      y: left.y + along.y * at - ahead.y * back,
    };
    return stand(group, target, facing, { facing, ...frontOfWidth(group.shape, width) }, local);
  });
}

/** A drawn way with points some distance apart. */
export function thinnedRoute(drawn: readonly GroundPoint[]): GroundPoint[] {
  const route: GroundPoint[] = [];
  for (const point of drawn) {
    const last = route[route.length - 1];
    if (!last || distance(last, point) >= kRouteStep) route.push(point);
  }
  const end = drawn[drawn.length - 1];
  if (end && route[route.length - 1] !== end) route.push(end);
  return route;
}

/** All follow a drawn way, each beside the others as they stand now. */
export function planRoute(groups: readonly OrderedGroup[], drawn: readonly GroundPoint[]): PlannedMove[] {
  const route = thinnedRoute(drawn);
  const end = route[route.length - 1];
  if (!end || route.length < 2) return [];
  const from = middle(groups);
  const before = route[route.length - 2]!;
  const facing = Math.atan2(end.y - before.y, end.x - before.x);
  return groups.map((group) => {
    const shift = { x: group.at.x - from.x, y: group.at.y - from.y };
    const shifted = route.map(({ x, y }) => ({ x: x + shift.x, y: y + shift.y }));
    return stand(group, shifted[shifted.length - 1]!, facing, { route: shifted.slice(0, -1) });
  });
}
