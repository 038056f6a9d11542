// Splits, merges and orders of ours that can be undone. The undo of a split is a merge, that of a merge a split by the ids
// that the parts had, that of an order the queue as it was, without what has been done since.

import { EventKind, type EventFrame } from '../protocol/messages';
import { mergeEvent, splitByIdsEvent, type CommandEvent } from './commands';
import { queueChange, type QueueState } from './queue_edit';

interface Split {
  readonly kind: 'split';
  group: number;
  /** The new groups, as far as frames have told of them. */
  parts: number[];
}

interface Merge {
  readonly kind: 'merge';
  into: number;
  /** The group that ended, and who was in it. */
  readonly ended: number;
  readonly ids: readonly number[];
}

/** Orders were given, or queues changed. */
interface Queues {
  readonly kind: 'queues';
  before: readonly QueueState[];
}

type Done = Split | Merge | Queues;

/** What an undo needs to know of the world. */
export interface Units {
  readonly groups: readonly number[];
  members(group: number): readonly number[];
  queue(group: number): QueueState | undefined;
}

/** What may be undone, at most. */
const kMost = 50;

export class UnitHistory {
  private done_: Done[] = [];
  /** Groups that the undo of a merge brings back under a new id. */
  private coming_: { readonly from: number; readonly was: number }[] = [];
  /** Orders that come back, or stand elsewhere, under new ids. */
  private copies_: { readonly group: number; readonly was: number }[] = [];
  /** Orders that are done. */
  private readonly finished_ = new Set<number>();

  /** `copied`: an order goes on under another id. */
  constructor(private readonly copied_: (was: number, now: number) => void = () => undefined) {}

  get canUndo(): boolean {
    return this.done_.some((one) => one.kind !== 'split' || one.parts.length > 0);
  }

  clear(): void {
    this.done_ = [];
    this.coming_ = [];
    this.copies_ = [];
    this.finished_.clear();
  }

  /** Queues are about to change; `before`: as they are. */
  queuesAsked(before: readonly QueueState[]): void {
    if (before.length > 0) this.push({ kind: 'queues', before });
  }

  /** Copies of these orders were asked for. */
  copiesAsked(group: number, ids: readonly number[]): void {
    for (const was of ids) this.copies_.push({ group, was });
  }

  /** A split was asked for; frames tell what came of it. */
  splitAsked(group: number): void {
    this.push({ kind: 'split', group, parts: [] });
  }

  /** A merge was asked for; `ids`: the members of the group that ends. */
  mergeAsked(into: number, ended: number, ids: readonly number[]): void {
    this.push({ kind: 'merge', into, ended, ids });
  }

  /** The server refused something: a split that no frame has told of has not happened. */
  refused(): void {
    const last = this.done_[this.done_.length - 1];
    if (last?.kind === 'split' && last.parts.length === 0) this.done_.pop();
  }

  /** Returns the groups that a split of ours has made. */
  observe(events: readonly EventFrame[]): number[] {
    const made: number[] = [];
    for (const { kind, subject, value } of events) {
      if (kind === EventKind.OrderGiven) this.orderGiven(subject, value);
      if (kind === EventKind.OrderDone || kind === EventKind.OrderSkipped) this.finished_.add(value);
      if (kind !== EventKind.GroupAdded) continue;
      const back = this.coming_.findIndex(({ from }) => from === value);
      if (back >= 0) {
        this.rename(this.coming_.splice(back, 1)[0]!.was, subject);
        made.push(subject);
        continue;
      }
      const split = this.done_.find(
        (one): one is Split => one.kind === 'split' && one.group === value && one.parts.length === 0,
      );
      if (!split) continue;
      split.parts.push(subject);
      made.push(subject);
    }
    return made;
  }

  /** The commands that undo the last one, which is forgotten; none where there is nothing left to undo. */
  undo(units: Units): CommandEvent[] {
    for (let last = this.done_.pop(); last; last = this.done_.pop()) {
      const events = last.kind === 'queues' ? this.restored(last, units) : this.reversed(last, units);
      if (events.length > 0) return events;
    }
    return [];
  }

  private restored({ before }: Queues, units: Units): CommandEvent[] {
    return before.flatMap((queue) => {
      const now = units.queue(queue.group);
      if (!now) return [];
      const there = new Set(now.orders.map(({ id }) => id));
      // In a patrol an order that was done is still there.
      const orders = queue.orders.filter(({ id }) => there.has(id) || !this.finished_.has(id));
      const { events, copied } = queueChange(now, { ...queue, orders });
      this.copiesAsked(queue.group, copied);
      return events;
    });
  }

  private reversed(done: Split | Merge, units: Units): CommandEvent[] {
    const alive = new Set(units.groups);
    if (done.kind === 'split') {
      const parts = [done.group, ...done.parts].filter((id) => alive.has(id));
      return parts.length > 1 ? [mergeEvent(parts, 'asHeld')] : [];
    }
    if (!alive.has(done.into)) return [];
    const there = new Set(units.members(done.into));
    const left = done.ids.filter((id) => there.has(id));
    if (left.length === 0) return [];
    this.coming_.push({ from: done.into, was: done.ended });
    return [splitByIdsEvent(done.into, left)];
  }

  /** A group is back under another id. */
  private rename(was: number, now: number): void {
    const renamed = (id: number): number => (id === was ? now : id);
    for (const one of this.done_) {
      if (one.kind === 'queues') one.before = one.before.map((queue) => ({ ...queue, group: renamed(queue.group) }));
      else if (one.kind === 'merge') one.into = renamed(one.into);
      else [one.group, one.parts] = [renamed(one.group), one.parts.map(renamed)];
    }
  }

  private orderGiven(group: number, now: number): void {
    const index = this.copies_.findIndex((copy) => copy.group === group);
    if (index < 0) return;
    const { was } = this.copies_.splice(index, 1)[0]!;
    for (const one of this.done_) {
      if (one.kind !== 'queues') continue;
      one.before = one.before.map((queue) => ({
        ...queue,
        orders: queue.orders.map((order) => (order.id === was ? { ...order, id: now } : order)),
      }));
    }
    this.copied_(was, now);
  }

  private push(done: Done): void {
    this.done_.push(done);
    if (this.done_.length > kMost) this.done_.shift();
  }
}
