import { describe, expect, it } from 'vitest';
import { insertCommand, queueChange, reordered, skipped, type QueueState } from './queue_edit';
import { madeOrder } from './test_frames';

function queue(ids: readonly number[], more: Partial<QueueState> = {}): QueueState {
  return {
    group: 5,
    orders: ids.map((id) => madeOrder(id, { target: [id, 0] })),
    held: false,
    patrols: false,
    ...more,
  };
}

/** What the engine would make of the commands: ids of copies are those of what they copy, negative. */
function applied(now: QueueState, wanted: QueueState): number[] {
  const { commands, copied } = queueChange(now, wanted);
  const ids = now.orders.map(({ id }) => id);
  let copies = 0;
  for (const one of commands) {
    if (one.kind === 'queue' && one.edit === 'cancel') ids.splice(ids.indexOf(one.order!), 1);
    if (one.kind !== 'queue' && one.mode === 'insert') ids.splice(one.index!, 0, -copied[copies++]!);
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
    const { commands } = queueChange(queue([1], { held: true }), queue([1], { patrols: true }));
    expect(commands).toEqual([
      { kind: 'queue', group: 5, edit: 'resume', order: 0 },
      { kind: 'queue', group: 5, edit: 'patrol', order: 0 },
    ]);
  });
});

it('an order is given again as it is, at its place', () => {
  const order = madeOrder(3, { target: [4, -2], facing: 0.5, route: [[1, 2]], pace: 0.5, turn: 'keep' });
  expect(insertCommand(5, order, 2)).toEqual({ kind: 'order', group: 5, mode: 'insert', index: 2, order });
});

it('an order is put elsewhere, and a patrol comes to what it skips again', () => {
  const ids = (state: QueueState): number[] => state.orders.map(({ id }) => id);
  expect(ids(reordered(queue([1, 2, 3]), 3, 0))).toEqual([3, 1, 2]);
  expect(ids(reordered(queue([1, 2, 3]), 1, 2))).toEqual([2, 3, 1]);
  expect(ids(skipped(queue([1, 2, 3])))).toEqual([2, 3]);
  expect(ids(skipped(queue([1, 2, 3], { patrols: true })))).toEqual([2, 3, 1]);
  expect(ids(skipped(queue([])))).toEqual([]);
});
