// An order in a group's queue, as the page has it.

import type { FormationDef, Given, Order, QueuedOrder } from '../protocol/generated/commands';
import type { GroundPoint } from './plane';

/** A formation, as far as it is not what formations are anyway. */
export type FormationWords = Given<FormationDef> & Pick<FormationDef, 'kind'>;

export interface QueueOrder extends Omit<Order, 'formation'> {
  readonly id: number;
  /** As the server tells it, or as far as it was chosen. */
  readonly formation: FormationWords | null;
}

export function queueOrder({ id, order }: QueuedOrder): QueueOrder {
  return { id, ...order };
}

/** Where it leads. */
export function targetOf({ target: [x, y] }: Pick<Order, 'target'>): GroundPoint {
  return { x, y };
}
