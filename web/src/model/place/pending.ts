// Changes of things that the server has been told and has not shown yet: whoever takes hold of a thing takes it as they
// left it.

import { changeCommand, sameThing, type Thing } from './things';

/** So long the server may take until what it shows counts, for instance where it refused a change [ms]. */
const kPatience = 1500;
/** Numbers that differ less than that are the same. */
const kClose = 1e-6;

function alike(a: unknown, b: unknown): boolean {
  if (typeof a === 'number' && typeof b === 'number') return Math.abs(a - b) <= kClose * (1 + Math.abs(a));
  if (typeof a !== 'object' || typeof b !== 'object' || a === null || b === null) return a === b;
  const [left, right] = [Object.entries(a), b as Readonly<Record<string, unknown>>];
  return left.length === Object.keys(b).length && left.every(([key, value]) => alike(value, right[key]));
}

export class PendingChanges {
  private things_: readonly Thing[] = [];
  private since_ = 0;

  /** The server has just been told that the things are to be like this. */
  put(changed: readonly Thing[], now: number): void {
    const others = this.things_.filter((one) => !changed.some((other) => sameThing(one, other)));
    this.things_ = [...others, ...changed];
    this.since_ = now;
  }

  /** What the server shows now, with what it has been told since. */
  over(shown: readonly Thing[], now: number): Thing[] {
    if (now - this.since_ > kPatience) this.things_ = [];
    this.things_ = this.things_.filter((one) => {
      const there = shown.find((other) => sameThing(one, other));
      return there !== undefined && !alike(changeCommand(one), changeCommand(there));
    });
    return shown.map((one) => this.things_.find((other) => sameThing(one, other)) ?? one);
  }

  /** What the server shows counts from now on. */
  clear(): void {
    this.things_ = [];
  }
}
