// What came of the splits that were asked for here, and of orders that were copied in their queue.

import { EventKind, type EventFrame } from '../protocol/messages';

export class UnitNews {
  /** Groups that are to be divided. */
  private splits_: number[] = [];
  /** Orders that stand elsewhere under new ids. */
  private copies_: { readonly group: number; readonly was: number }[] = [];

  /** `copied`: an order goes on under another id. */
  constructor(private readonly copied_: (was: number, now: number) => void = () => undefined) {}

  clear(): void {
    this.splits_ = [];
    this.copies_ = [];
  }

  /** Copies of these orders were asked for. */
  copiesAsked(group: number, ids: readonly number[]): void {
    for (const was of ids) this.copies_.push({ group, was });
  }

  /** A split was asked for; frames tell what came of it. */
  splitAsked(group: number): void {
    this.splits_.push(group);
  }

  /** The server refused something: a split that no frame has told of has not happened. */
  refused(): void {
    this.splits_.pop();
  }

  /** Returns the groups that a split of ours has made. */
  observe(events: readonly EventFrame[]): number[] {
    const made: number[] = [];
    for (const { kind, subject, value } of events) {
      if (kind === EventKind.OrderGiven) this.orderGiven(subject, value);
      if (kind !== EventKind.GroupAdded) continue;
      const split = this.splits_.indexOf(value);
      if (split < 0) continue;
      this.splits_.splice(split, 1);
      made.push(subject);
    }
    return made;
  }

  private orderGiven(group: number, now: number): void {
    const index = this.copies_.findIndex((copy) => copy.group === group);
    if (index >= 0) this.copied_(this.copies_.splice(index, 1)[0]!.was, now);
  }
}
