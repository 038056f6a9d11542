// Queues as they were and as they shall be: the commands that lead from one to the other.

import type { EditQueueCommand, Given, GiveOrderCommand, Order } from '../protocol/generated/commands';
import { queueCommand } from './commands';
import type { QueueOrder } from './queue_order';

export interface QueueState {
  readonly group: number;
  readonly orders: readonly QueueOrder[];
  readonly held: boolean;
  readonly patrols: boolean;
}

/** What leads to a queue: commands, and whose copies they put into the queue, in the order in which they are given. */
export interface QueueChange {
  readonly commands: readonly (GiveOrderCommand | EditQueueCommand)[];
  /** Ids of orders that come back, or stand elsewhere, under new ids. */
  readonly copied: readonly number[];
}

/** Gives an order again, before that of an index. */
export function insertCommand(group: number, order: Given<Order>, index: number): GiveOrderCommand {
  return { kind: 'order', group, mode: 'insert', index, order };
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
  const commands: (GiveOrderCommand | EditQueueCommand)[] = [];
  const copied: number[] = [];
  for (const { id } of now.orders) if (!kept.has(id)) commands.push(queueCommand(group, 'cancel', id));
  wanted.orders.forEach((order, index) => {
    if (kept.has(order.id)) return;
    commands.push(insertCommand(group, order, index));
    copied.push(order.id);
  });
  if (wanted.held !== now.held) commands.push(queueCommand(group, wanted.held ? 'hold' : 'resume'));
  if (wanted.patrols !== now.patrols) commands.push(queueCommand(group, wanted.patrols ? 'patrol' : 'endPatrol'));
  return { commands, copied };
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
