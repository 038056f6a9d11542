// Queues as they were and as they shall be: the commands that lead from one to the other.

import {
  kOrderKindWords,
  type EditQueueEvent,
  type Fields,
  type GiveOrderEvent,
  type OrderKindWord,
} from '../protocol/generated/commands';
import type { OrderFrame } from '../protocol/messages';
import { kManners, kTurns, queueEvent } from './commands';

export interface QueueState {
  readonly group: number;
  readonly orders: readonly OrderFrame[];
  readonly held: boolean;
  readonly patrols: boolean;
}

/** An order without its group and place in a queue. */
export type OrderContent = Fields & { readonly kind: OrderKindWord };

/** What an event says beside its order. */
const kFrameOfEvent = ['t', 'client', 'group', 'mode', 'index'];

/** What commands lead to: events, and whose copies they put into the queue, in the order in which they are given. */
export interface QueueChange {
  readonly events: readonly (GiveOrderEvent | EditQueueEvent)[];
  /** Ids of orders that come back, or stand elsewhere, under new ids. */
  readonly copied: readonly number[];
}

function pairs(numbers: ArrayLike<number>): [number, number][] {
  return Array.from({ length: numbers.length >> 1 }, (_, i) => [numbers[2 * i]!, numbers[2 * i + 1]!]);
}

/** An order as an event of a gesture file, without its group and place. */
export function orderContent(order: OrderFrame): OrderContent {
  if (order.event) {
    const file = JSON.parse(order.event) as { events: Fields[] };
    const rest: Record<string, unknown> = { ...file.events[0] };
    for (const name of kFrameOfEvent) delete rest[name];
    return { ...rest, kind: kOrderKindWords[order.kind] };
  }
  const kind = kOrderKindWords[order.kind];
  const moves = order.kind === 0;
  return {
    kind,
    ...(moves || (order.kind === 3 && !order.group && !order.character) ? { x: order.x, y: order.y } : {}),
    ...(order.hasFacing ? { facing: order.facing } : {}),
    ...(order.width > 0 ? { width: order.width } : {}),
    ...(order.route.length > 0 ? { route: pairs(order.route) } : {}),
    ...(moves ? { manner: kManners[order.manner], turn: kTurns[order.turn] } : {}),
    ...(order.group ? { leader: order.group } : {}),
    ...(order.character ? { character: order.character } : {}),
    ...(order.halfX > 0 || order.halfY > 0 ? { halfSize: [order.halfX, order.halfY] } : {}),
  };
}

/** Gives an order again, before that of an index. */
export function insertEvent(group: number, order: OrderFrame, index: number): GiveOrderEvent {
  return { ...orderContent(order), group, mode: 'insert', index };
}

/** The longest list of ids that stand in the same order in both. */
function inOrder(a: readonly number[], b: readonly number[]): Set<number> {
  const best: number[][] = Array.from({ length: a.length + 1 }, () => new Array<number>(b.length + 1).fill(0));
  for (let i = a.length - 1; i >= 0; --i)
    for (let k = b.length - 1; k >= 0; --k)
      best[i]![k] = a[i] === b[k] ? best[i + 1]![k + 1]! + 1 : Math.max(best[i + 1]![k]!, best[i]![k + 1]!);
  const kept = new Set<number>();
  for (let i = 0, k = 0; i < a.length && k < b.length;) {
    if (a[i] === b[k]) {
      kept.add(a[i]!);
      [i, k] = [i + 1, k + 1];
    } else if (best[i + 1]![k]! >= best[i]![k + 1]!) ++i;
    else ++k;
  }
  return kept;
}

/** From the queue of now to another one; orders that stand alike in both are left alone. */
export function queueChange(now: QueueState, wanted: QueueState): QueueChange {
  const { group } = now;
  const kept = inOrder(
    now.orders.map(({ id }) => id),
    wanted.orders.map(({ id }) => id),
  );
  const events: (GiveOrderEvent | EditQueueEvent)[] = [];
  const copied: number[] = [];
  for (const { id } of now.orders) if (!kept.has(id)) events.push(queueEvent(group, 'cancel', id));
  wanted.orders.forEach((order, index) => {
    if (kept.has(order.id)) return;
    events.push(insertEvent(group, order, index));
    copied.push(order.id);
  });
  if (wanted.held !== now.held) events.push(queueEvent(group, wanted.held ? 'hold' : 'resume'));
  if (wanted.patrols !== now.patrols) events.push(queueEvent(group, wanted.patrols ? 'patrol' : 'endPatrol'));
  return { events, copied };
}

/** The queue with the order of an id at another index. */
export function reordered(queue: QueueState, id: number, index: number): QueueState {
  const moved = queue.orders.find((order) => order.id === id);
  if (!moved) return queue;
  const orders = queue.orders.filter((order) => order !== moved);
  orders.splice(index, 0, moved);
  return { ...queue, orders };
}

/** The queue without the order that is carried out; a patrol comes to it again. */
export function skipped(queue: QueueState): QueueState {
  const [first, ...rest] = queue.orders;
  return { ...queue, orders: first && queue.patrols ? [...rest, first] : rest };
}
