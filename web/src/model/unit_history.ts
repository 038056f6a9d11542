// Splits and merges of ours that can be undone. The undo of a split is a merge, that of a merge a split by the ids that
// the parts had.

import { EventKind, type EventFrame } from '../protocol/messages';
import { mergeEvent, splitByIdsEvent, type CommandEvent } from './commands';

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

type Done = Split | Merge;

/** What may be undone, at most. */
const kMost = 50;

export class UnitHistory {
  private done_: Done[] = [];
  /** Groups that the undo of a merge brings back under a new id. */
  private coming_: { readonly from: number; readonly was: number }[] = [];

  get canUndo(): boolean {
    return this.done_.some((one) => one.kind === 'merge' || one.parts.length > 0);
  }

  clear(): void {
    this.done_ = [];
    this.coming_ = [];
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
  undo(groups: readonly number[], members: (group: number) => readonly number[]): CommandEvent[] {
    for (let last = this.done_.pop(); last; last = this.done_.pop()) {
      const events = this.reversed(last, new Set(groups), members);
      if (events.length > 0) return events;
    }
    return [];
  }

  private reversed(
    done: Done,
    alive: ReadonlySet<number>,
    members: (group: number) => readonly number[],
  ): CommandEvent[] {
    if (done.kind === 'split') {
      const parts = [done.group, ...done.parts].filter((id) => alive.has(id));
      return parts.length > 1 ? [mergeEvent(parts, 'asHeld')] : [];
    }
    if (!alive.has(done.into)) return [];
    const there = new Set(members(done.into));
    const left = done.ids.filter((id) => there.has(id));
    if (left.length === 0) return [];
    this.coming_.push({ from: done.into, was: done.ended });
    return [splitByIdsEvent(done.into, left)];
  }

  /** A group is back under another id. */
  private rename(was: number, now: number): void {
    const renamed = (id: number): number => (id === was ? now : id);
    for (const one of this.done_) {
      if (one.kind === 'merge') one.into = renamed(one.into);
      else [one.group, one.parts] = [renamed(one.group), one.parts.map(renamed)];
    }
  }

  private push(done: Done): void {
    this.done_.push(done);
    if (this.done_.length > kMost) this.done_.shift();
  }
}
