// A sequence of formations that a group takes up one after another along its way (SPEC M7). An order takes up its
// formation when it begins, so a way with a formation in its middle is two orders: one to a joint, one on from there.

import type { Vec2 } from '../protocol/generated/commands';
import { kFormationKindWords, type FormationKindWord } from '../protocol/generated/words';
import { distance, type GroundPoint, lengthOf } from './plane';
import { targetOf, type FormationWords, type QueueOrder } from './queue_order';

export type { FormationWords } from './queue_order';

/** The shape of that name; a square where there is none. */
export function formationKind(name: string): FormationKindWord {
  return kFormationKindWords.find((word) => word === name) ?? 'square';
}

/** Where along the way a formation is taken up [m]. */
export interface Station {
  readonly at: number;
  readonly formation: FormationWords;
}

/** A stretch of a way, and the order at its end. */
export interface WayLeg {
  readonly order: QueueOrder;
  readonly points: readonly GroundPoint[];
  /** Joints lie in it: it is the way of several orders. */
  readonly joined?: boolean;
}

/** An order to a joint is done when so many are there, and is known by this: usual shares are 0.95. */
export const kJointShare = 0.305;
const kUsualShare = 0.95;
/** Stations lie at least so far apart, and from joints of the way [m]. */
export const kLeastGap = 0.5;

function isJoint({ kind, share }: QueueOrder): boolean {
  return kind === 'move' && isJointShare(share);
}

function isJointShare(share: number): boolean {
  return Math.abs(share - kJointShare) < 1e-6;
}

/** An order that goes nowhere and takes up a formation: the last one of a sequence. */
function isEnd({ order, points }: WayLeg, index: number): boolean {
  return index > 0 && order.kind === 'move' && lengthOf(points) < kLeastGap && order.formation !== null;
}

export function stationsOf(legs: readonly WayLeg[]): Station[] {
  let at = 0;
  return legs.flatMap(({ order, points }) => {
    const [{ formation }, here] = [order, at];
    at += lengthOf(points);
    return formation ? [{ at: here, formation }] : [];
  });
}

/** The legs without the joints of sequences. */
export function plainLegs(legs: readonly WayLeg[]): WayLeg[] {
  const plain: WayLeg[] = [];
  let before: GroundPoint[] = [];
  let route: Vec2[] = [];
  legs.forEach((leg, k) => {
    const { order, points } = leg;
    const last = k === legs.length - 1;
    if (last && isEnd(leg, k) && before.length === 0) return;
    const whole = [...before, ...(before.length > 0 ? points.slice(1) : points)];
    if (isJoint(order) && legs.slice(k + 1).some((next) => !isEnd(next, k + 1))) {
      before = whole;
      if (order.route.length > 0) route.push(...order.route, order.target);
      return;
    }
    const drawn = route.length > 0 ? { ...order, route: [...route, ...order.route] } : order;
    plain.push({ order: drawn, points: whole, joined: before.length > 0 });
    [before, route] = [[], []];
  });
  return plain;
}

/** Stations in their order along a way of this length, with room between them. */
export function arranged(stations: readonly Station[], length: number): Station[] {
  const sorted = [...stations].sort((a, b) => a.at - b.at);
  let least = 0;
  const forward = sorted.map((station) => {
    const at = Math.max(least, Math.min(length, station.at));
    least = at + kLeastGap;
    return { ...station, at };
  });
  let most = length;
  return forward
    .reverse()
    .map((station) => {
      const at = Math.max(0, Math.min(most, station.at));
      most = at - kLeastGap;
      return { ...station, at };
    })
    .reverse();
}

/** The point so far along a way, and the heading there. */
export function alongWay(points: readonly GroundPoint[], at: number): GroundPoint & { readonly facing: number } {
  let left = at;
  for (let i = 0; i + 1 < points.length; ++i) {
    const [a, b] = [points[i]!, points[i + 1]!];
    const length = distance(a, b);
    const facing = Math.atan2(b.y - a.y, b.x - a.x);
    if (left <= length || i + 2 === points.length) {
      const t = length > 0 ? Math.min(1, left / length) : 0;
      return { x: a.x + t * (b.x - a.x), y: a.y + t * (b.y - a.y), facing };
    }
    left -= length;
  }
  return { ...(points[0] ?? { x: 0, y: 0 }), facing: 0 };
}

const rounded = (value: number): number => Math.round(value * 1000) / 1000;

/** The corners of a drawn way between two distances along it. */
function routeBetween(points: readonly GroundPoint[], from: number, to: number): Vec2[] {
  let gone = 0;
  return points.flatMap((point, i): Vec2[] => {
    gone += i > 0 ? distance(points[i - 1]!, point) : 0;
    return gone > from + 1e-6 && gone < to - 1e-6 ? [[rounded(point.x), rounded(point.y)]] : [];
  });
}

/** A leg in pieces: `cuts` are distances along it, `formations` those that its pieces begin with. */
function pieces(
  { order, points, joined }: WayLeg,
  cuts: readonly number[],
  formations: readonly (FormationWords | null)[],
  id: () => number,
): QueueOrder[] {
  const ends = [...cuts, lengthOf(points)];
  const first = formations[0] ?? null;
  const same = JSON.stringify(order.formation) === JSON.stringify(first);
  if (cuts.length === 0 && same && !joined && !isJointShare(order.share)) return [order];
  const isDrawn = order.route.length > 0;
  return ends.map((end, k) => {
    const last = k === ends.length - 1;
    const formation = formations[k] ?? null;
    const at = last ? targetOf(order) : alongWay(points, end);
    return {
      ...order,
      id: id(),
      target: order.kind === 'move' ? [rounded(at.x), rounded(at.y)] : order.target,
      ...(last ? arrival(order, formation) : { share: kJointShare, facing: null, width: 0 }),
      route: isDrawn ? routeBetween(points, k === 0 ? 0 : ends[k - 1]!, end) : [],
      formation,
    };
  });
}

/** Share and width at the end of a leg; shapes that are not of ranks have no width to give. */
function arrival({ share, width }: QueueOrder, formation: FormationWords | null): Pick<QueueOrder, 'share' | 'width'> {
  const isRanked = formation === null || formation.kind === 'square';
  return { share: isJointShare(share) ? kUsualShare : share, width: isRanked ? width : 0 };
}

/** The queue in which a group takes up these formations along its way. */
export function withStations(legs: readonly WayLeg[], stations: readonly Station[]): QueueOrder[] {
  const plain = plainLegs(legs);
  const total = plain.reduce((sum, { points }) => sum + lengthOf(points), 0);
  const placed = arranged(stations, total);
  let next = 0;
  const id = (): number => --next;
  let from = 0;
  const orders = plain.flatMap((leg, k) => {
    const to = from + lengthOf(leg.points);
    const isLast = k === plain.length - 1;
    const inside = placed.filter(({ at }) => at > from + kLeastGap && at < to - kLeastGap && leg.order.kind === 'move');
    const begins = placed.filter(({ at }) => at <= from + kLeastGap && at > (k === 0 ? -1 : from - kLeastGap)).pop();
    const cuts = inside.map(({ at }) => at - from);
    const atEnd = isLast ? placed.filter(({ at }) => at >= to - kLeastGap && at > from + kLeastGap).pop() : undefined;
    from = to;
    const parts = pieces(leg, cuts, [begins?.formation ?? null, ...inside.map(({ formation }) => formation)], id);
    return atEnd ? [...parts, endOf(leg.order, atEnd.formation, id())] : parts;
  });
  return orders;
}

/** Whom an order is about, and where from: nobody, for a move. */
const kNobody = { group: 0, character: 0, offset: [0, 0], halfSize: [0, 0] } as const;

/** The formation that is taken up where the way ends. */
function endOf(order: QueueOrder, formation: FormationWords, id: number): QueueOrder {
  return { ...order, ...kNobody, id, kind: 'move', formation, route: [], width: 0, share: kUsualShare };
}
