// The rows of a take's time line: where blocks lie in time and on the screen, and where they may be put.

import type { OpenTake } from './take_facts';
import type { TakeBlock, TakeTrack, TakeTracks } from '../protocol/messages';

/** The part of a take that a time line shows [steps]. */
export interface TimeWindow {
  readonly from: number;
  readonly to: number;
}

/** A row: a group and its blocks. */
export interface TrackRow {
  readonly track: TakeTrack;
  readonly blocks: readonly TakeBlock[];
}

/** What is done to a block, before it is told. */
export interface BlockEdit {
  readonly edit: 'move' | 'copy' | 'stretch';
  readonly id: number;
  /** Where it begins then, or ends where it is stretched. */
  readonly step: number;
}

/** The shortest part that can be shown [s]. */
const kLeastSeconds = 2;
/** From one line of the ruler to the next [CSS px]. */
const kLeastTick = 64;
const kTicks: readonly number[] = [0.1, 0.2, 0.5, 1, 2, 5, 10, 15, 30, 60, 120, 300, 600, 1800, 3600];

export function xOf({ from, to }: TimeWindow, width: number, step: number): number {
  return (width * (step - from)) / Math.max(1e-9, to - from);
}

export function stepAt({ from, to }: TimeWindow, width: number, x: number): number {
  return from + ((to - from) * x) / Math.max(1, width);
}

function within(from: number, length: number, steps: number): TimeWindow {
  const whole = Math.min(length, steps);
  const begin = Math.min(Math.max(0, from), steps - whole);
  return { from: begin, to: begin + whole };
}

/** `factor` times as near, round a step that stays where it is. */
export function zoomed(shown: TimeWindow, steps: number, stepTime: number, factor: number, at: number): TimeWindow {
  const length = shown.to - shown.from;
  const wished = Math.max(kLeastSeconds / stepTime, length / factor);
  return within(at - (wished * (at - shown.from)) / Math.max(1e-9, length), wished, steps);
}

export function panned(shown: TimeWindow, steps: number, by: number): TimeWindow {
  return within(shown.from + by, shown.to - shown.from, steps);
}

/** The same part of a take that has another length; all of it where all was shown. */
export function fitted(shown: TimeWindow, before: number, steps: number): TimeWindow {
  if (shown.to - shown.from >= before) return { from: 0, to: steps };
  return within(shown.from, shown.to - shown.from, steps);
}

/** Lines of the ruler [steps], and seconds between them. */
export function ticksOf(
  { from, to }: TimeWindow,
  width: number,
  { from: zero, stepTime }: Pick<OpenTake, 'from' | 'stepTime'>,
): { readonly steps: readonly number[]; readonly every: number } {
  const seconds = (to - from) * stepTime;
  const every = kTicks.find((one) => (width * one) / Math.max(1e-9, seconds) >= kLeastTick) ?? 7200;
  const steps: number[] = [];
  const [first, last] = [(from - zero) * stepTime, (to - zero) * stepTime];
  for (let k = Math.ceil(first / every - 1e-9); k * every <= last + 1e-9; ++k)
    steps.push(Math.max(0, zero + Math.round((k * every) / stepTime)));
  return { steps, every };
}

/** The nearest of the playhead and whole seconds within that reach [steps]; else the step itself. */
export function snapped(step: number, playhead: number, stepTime: number, reach: number): number {
  const second = Math.round(Math.round(step * stepTime) / stepTime);
  const near = [playhead, second].filter((one) => Math.abs(one - step) <= reach);
  near.sort((a, b) => Math.abs(a - step) - Math.abs(b - step));
  return Math.round(near[0] ?? step);
}

/** Rows with their blocks: the groups by id, and last what concerns the place, where there is something. */
export function rowsOf({ tracks, blocks }: Pick<TakeTracks, 'tracks' | 'blocks'>, steps: number): TrackRow[] {
  const rows = tracks.map((track) => ({ track, blocks: blocks.filter(({ group }) => group === track.group) }));
  const others = blocks.filter(({ group }) => !tracks.some((track) => track.group === group));
  if (others.length > 0) rows.push({ track: { group: 0, name: 'Place', from: 0, to: steps }, blocks: others });
  return rows;
}

/** The line of each block in its row: the first that is free. Each takes at least so many steps. */
export function linesOf(blocks: readonly TakeBlock[], least: number): number[] {
  const ends: number[] = [];
  return blocks.map(({ begin, end }) => {
    const free = ends.findIndex((taken) => taken <= begin);
    const line = free >= 0 ? free : ends.length;
    ends[line] = Math.max(end, begin + least);
    return line;
  });
}

/** Begin and end of a block as an edit leaves them. */
export function edited(block: TakeBlock, edit: BlockEdit | null): { readonly begin: number; readonly end: number } {
  const { begin, end } = block;
  if (edit === null || edit.id !== block.id) return { begin, end };
  if (edit.edit === 'stretch') return { begin, end: Math.max(begin + 1, edit.step) };
  return { begin: edit.step, end: end + edit.step - begin };
}

/** The block of a changed take that was meant: of that group and label, nearest to that step. */
export function foundAgain(
  blocks: readonly TakeBlock[],
  meant: Pick<TakeBlock, 'group' | 'label' | 'begin'>,
): TakeBlock | null {
  const alike = blocks.filter(({ group, label }) => group === meant.group && label === meant.label);
  alike.sort((a, b) => Math.abs(a.begin - meant.begin) - Math.abs(b.begin - meant.begin));
  return alike[0] ?? null;
}
