import { describe, expect, it } from 'vitest';
import type { OrderFrame } from '../protocol/messages';
import { insertEvent, queueChange, reordered, skipped, type QueueState } from './queue_edit';
import { madeOrder } from './test_frames';

function queue(ids: readonly number[], more: Partial<QueueState> = {}): QueueState {
  return { group: 5, orders: ids.map((id) => madeOrder(id, { x: id, y: 0 })), held: false, patrols: false, ...more };
}

/** What the engine would make of the events: ids of copies are those of what they copy, negative. */
function applied(now: QueueState, wanted: QueueState): number[] {
  const { events, copied } = queueChange(now, wanted);
  const ids = now.orders.map(({ id }) => id);
  let copies = 0;
  for (const event of events) {
    if (event.kind === 'queue' && event.edit === 'cancel') ids.splice(ids.indexOf(event.order!), 1);
    if (event.kind !== 'queue' && event.mode === 'insert') ids.splice(event.index!, 0, -copied[copies++]!);
  }
  expect(copies).toBe(copied.length);
  return ids;
}

describe('queueChange', () => {
  it('leads from any queue to any other, and leaves alone what it can', () => {
    let seed = 7;
    const random = (below: number): number => (seed = (seed * 48271) % 2147483647) % below;
    const shuffled = (): number[] => {
      const all = [1, 2, 3, 4, 5, 6].filter(() => random(3) > 0);
      return all
        .map((id) => [random(1000), id] as const)
        .sort((a, b) => a[0] - b[0])
        .map(([, id]) => id);
    };
    for (let k = 0; k < 300; ++k) {
      const [a, b] = [shuffled(), shuffled()];
      expect(applied(queue(a), queue(b)).map(Math.abs)).toEqual(b);
    }
    expect(applied(queue([1, 2, 3]), queue([1, 2, 3]))).toEqual([1, 2, 3]);
    expect(applied(queue([1, 2, 3, 4]), queue([1, 4, 2, 3]))).toEqual([1, -4, 2, 3]);
  });

  it('brings back whether it waits and patrols', () => {
    const { events } = queueChange(queue([1], { held: true }), queue([1], { patrols: true }));
    expect(events).toEqual([
      { kind: 'queue', group: 5, edit: 'resume' },
      { kind: 'queue', group: 5, edit: 'patrol' },
    ]);
  });
});

describe('insertEvent', () => {
  it('says of an order what its fields say', () => {
    const order = madeOrder(3, { x: 4, y: -2, hasFacing: true, facing: 0.5, width: 6, manner: 1, turn: 2 });
    order.route = Float32Array.of(1, 2, 3, 4);
    expect(insertEvent(5, order, 2)).toEqual({
      kind: 'move',
      group: 5,
      mode: 'insert',
      index: 2,
      x: 4,
      y: -2,
      facing: 0.5,
      width: 6,
      route: [
        [1, 2],
        [3, 4],
      ],
      manner: 'free',
      turn: 'keep',
    });
    const guard: OrderFrame = madeOrder(4, { kind: 3, x: 1, y: 2, halfX: 3, halfY: 4 });
    expect(insertEvent(5, guard, 0)).toMatchObject({ kind: 'guard', x: 1, y: 2, halfSize: [3, 4] });
  });

  it('takes the text of an order that says more', () => {
    const event = JSON.stringify({
      events: [{ t: 0, client: 1, kind: 'move', group: 1, mode: 'append', x: 3, y: 4, pace: 0.5 }],
    });
    expect(insertEvent(5, madeOrder(1, { event }), 1)).toEqual({
      kind: 'move',
      x: 3,
      y: 4,
      pace: 0.5,
      group: 5,
      mode: 'insert',
      index: 1,
    });
  });
});

it('an order is put elsewhere, and a patrol comes to what it skips again', () => {
  const ids = (state: QueueState): number[] => state.orders.map(({ id }) => id);
  expect(ids(reordered(queue([1, 2, 3]), 3, 0))).toEqual([3, 1, 2]);
  expect(ids(reordered(queue([1, 2, 3]), 1, 2))).toEqual([2, 3, 1]);
  expect(ids(skipped(queue([1, 2, 3])))).toEqual([2, 3]);
  expect(ids(skipped(queue([1, 2, 3], { patrols: true })))).toEqual([2, 3, 1]);
  expect(ids(skipped(queue([])))).toEqual([]);
});
