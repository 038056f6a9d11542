import { describe, expect, it } from 'vitest';
import { EventKind, type EventFrame } from '../protocol/messages';
import type { QueueState } from './queue_edit';
import { UnitHistory, type Units } from './unit_history';

function added(id: number, from: number): EventFrame {
  return { kind: EventKind.GroupAdded, subject: id, value: from, x: 0, y: 0 };
}

function units(groups: readonly number[], members: readonly number[] = [], queue?: QueueState): Units {
  return { groups, members: () => members, queue: () => queue };
}

describe('UnitHistory', () => {
  it('undoes a split by a merge of its parts, once frames have told of them', () => {
    const history = new UnitHistory();
    history.splitAsked(3);
    expect(history.canUndo).toBe(false);
    expect(history.observe([added(8, 3), added(9, 7)])).toEqual([8]);
    expect(history.canUndo).toBe(true);
    expect(history.undo(units([3, 8]))).toEqual([{ kind: 'merge', groups: [3, 8], shape: 'asHeld' }]);
    expect(history.canUndo).toBe(false);
  });

  it('undoes a merge by a split with the ids that the parts had, of those who live', () => {
    const history = new UnitHistory();
    history.mergeAsked(3, 8, [10, 11, 12]);
    const events = history.undo(units([3], [1, 2, 10, 12]));
    expect(events).toEqual([{ kind: 'split', group: 3, by: 'ids', ids: [10, 12], shape: 'asHeld' }]);
  });

  it('passes over what cannot be undone any more, and undoes the one before', () => {
    const history = new UnitHistory();
    history.mergeAsked(3, 8, [10]);
    history.splitAsked(5);
    history.observe([added(8, 5)]);
    // Group 8 has ended.
    expect(history.undo(units([3, 5], [10]))).toMatchObject([{ kind: 'split', ids: [10] }]);
    expect(history.undo(units([3, 5], [10]))).toEqual([]);
  });

  it('undoes a split after the merge of its parts was undone, though the part has a new id', () => {
    const history = new UnitHistory();
    history.splitAsked(3);
    history.observe([added(8, 3)]);
    history.mergeAsked(3, 8, [10, 11]);
    history.undo(units([3], [1, 10, 11]));
    expect(history.observe([added(9, 3)])).toEqual([9]);
    expect(history.undo(units([3, 9]))).toEqual([{ kind: 'merge', groups: [3, 9], shape: 'asHeld' }]);
  });

  it('forgets a split that the server refused, and keeps those that happened', () => {
    const history = new UnitHistory();
    history.splitAsked(5);
    history.observe([added(8, 5)]);
    history.splitAsked(5);
    history.refused();
    history.refused();
    expect(history.canUndo).toBe(true);
  });
});
