// Shared by the tests of the panels.

import type { OrderActions } from '../../model/order_actions';

/** Actions that write each call into `calls`: its name, and its values as JSON. */
export function recordingActions(calls: string[]): OrderActions {
  return new Proxy(
    {},
    {
      get:
        (_, name) =>
        (...values: unknown[]) =>
          calls.push([name, ...values.map((value) => JSON.stringify(value))].map(String).join(' ')),
    },
  ) as OrderActions;
}
