// An order in a group's queue, as the page has it.

import type { Order, QueuedOrder } from '../protocol/generated/commands';
import type { GroundPoint } from './plane';

export interface QueueOrder extends Order {
  readonly id: number;
}

export function queueOrder({ id, order }: QueuedOrder): QueueOrder {
  return { id, ...order };
}

/** Where it leads. */
export function targetOf({ target: [x, y] }: Pick<Order, 'target'>): GroundPoint {
  return { x, y };
}
