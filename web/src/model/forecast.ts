// What would come of orders: questions to the server, and what the page makes of the answers.

import type { Given, Order } from '../protocol/generated/commands';
import type { ForecastAsk, ForecastFrame } from '../protocol/messages';
import { isPlaceless } from './goals';
import { pointsOf, type GroundPoint } from './plane';
import { targetOf, type QueueOrder } from './queue_order';

/** An answer. */
export interface Forecast {
  readonly group: number;
  /** Id of an order in the queue; 0 for one that is not given yet. */
  readonly order: number;
  readonly arrives: boolean;
  /** From where it would begin; infinite where it never arrives [s]. */
  readonly seconds: number;
  readonly end: GroundPoint;
  readonly way: readonly GroundPoint[];
}

/** A place and heading from which an order would begin. */
export interface Stand extends GroundPoint {
  /** [rad] */
  readonly facing: number;
}

/** What the questions need to know of a group. */
export interface Asker extends Stand {
  readonly id: number;
  readonly orders: readonly QueueOrder[];
  readonly patrols: boolean;
}

/** Orders that end nowhere, or at no time, that is known before. */
function endsAnywhere(order: Pick<QueueOrder, 'kind'>): boolean {
  return order.kind === 'follow' || isPlaceless(order);
}

export function forecastOf({ group, order, arrives, seconds, x, y, way }: ForecastFrame): Forecast {
  return { group, order, arrives, seconds, end: { x, y }, way: pointsOf(way) };
}

function headingOf(way: readonly GroundPoint[], otherwise: number): number {
  const [a, b] = [way[way.length - 2], way[way.length - 1]];
  return a && b && (a.x !== b.x || a.y !== b.y) ? Math.atan2(b.y - a.y, b.x - a.x) : otherwise;
}

/** Where a group stands once its first `count` orders are done, as far as is known. */
export function standAfter(group: Asker, count: number, known: ReadonlyMap<number, Forecast>): Stand {
  let at: Stand = { x: group.x, y: group.y, facing: group.facing };
  for (const order of group.orders.slice(0, count)) {
    const forecast = known.get(order.id);
    // What cannot be reached is skipped.
    if (endsAnywhere(order) || (forecast && !forecast.arrives)) continue;
    const way = forecast && forecast.way.length > 1 ? forecast.way : [at, targetOf(order)];
    const facing = order.facing ?? headingOf(way, at.facing);
    at = order.kind === 'face' ? { ...at, facing } : { ...targetOf(order), facing };
  }
  return at;
}

/** Time until the first `count` orders are done; null where that is not known, infinite where it never is [s]. */
export function secondsUntil(group: Asker, count: number, known: ReadonlyMap<number, Forecast>): number | null {
  let sum = 0;
  for (const order of group.orders.slice(0, count)) {
    const forecast = known.get(order.id);
    if (endsAnywhere(order)) return Infinity;
    if (!forecast) return null;
    if (forecast.arrives) sum += forecast.seconds;
  }
  return sum;
}

/** The questions about a whole queue. */
export function queueAsks(group: Asker, known: ReadonlyMap<number, Forecast>): ForecastAsk[] {
  return group.orders.flatMap((order, k) => {
    if (endsAnywhere(order)) return [];
    const { x, y, facing } = standAfter(group, k, known);
    return [{ group: group.id, order: order.id, asked: null, placed: k > 0, x, y, facing }];
  });
}

/** The question about an order that is drawn, which would come after the first `count` ones. */
export function drawnAsk(
  group: Asker,
  count: number,
  asked: Given<Order>,
  known: ReadonlyMap<number, Forecast>,
): ForecastAsk {
  const { x, y, facing } = standAfter(group, count, known);
  return { group: group.id, order: 0, asked, placed: count > 0, x, y, facing };
}

/** The question about the way of a patrol back to its first order; null where it has no way back. */
export function returnAsk(group: Asker, known: ReadonlyMap<number, Forecast>): ForecastAsk | null {
  const first = group.orders[0];
  if (!group.patrols || group.orders.length < 2 || !first || endsAnywhere(first)) return null;
  const { x, y, facing } = standAfter(group, group.orders.length, known);
  return { group: group.id, order: first.id, asked: null, placed: true, x, y, facing };
}

/** "0:42", or "12:05"; a dash where it never arrives. */
export function formatSpan(seconds: number): string {
  if (!Number.isFinite(seconds)) return '–';
  const whole = Math.max(0, Math.round(seconds));
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, '0')}`;
}
