import { expect, it } from 'vitest';
import { TakeMarkKind } from '../protocol/messages';
import {
  countMarks,
  filmSteps,
  formatAge,
  formatBytes,
  formatLengthOf,
  speedAt,
  takeTitle,
  trimmed,
  withPiece,
  type OpenTake,
} from './take_facts';
import { kOpenTake } from './test_frames';

const take: OpenTake = kOpenTake;

it('writes lengths, ages and sizes', () => {
  expect([0, 24.4, 65, 3725].map(formatLengthOf)).toEqual(['0:00', '0:24', '1:05', '1:02:05']);
  expect(formatAge(1000, 1020)).toBe('just now');
  expect(formatAge(1000, 1000 + 61)).toBe('a minute ago');
  expect(formatAge(1000, 1000 + 5 * 3600)).toBe('5 hours ago');
  expect(formatAge(1000, 1000 + 30 * 3600)).toBe('yesterday');
  expect(formatAge(0, 1e9)).toContain('1970');
  expect([999, 4200, 42_000, 4_200_000, 5e9].map(formatBytes)).toEqual([
    '999 bytes',
    '4.2 kB',
    '42 kB',
    '4.2 MB',
    '5.0 GB',
  ]);
  expect(takeTitle({ title: '', scenario: 'Woodland' })).toBe('Woodland');
  expect(takeTitle({ title: 'Rain', scenario: 'Woodland' })).toBe('Rain');
});

it('keeps a part within the take and at least a fifth of a second long', () => {
  expect(trimmed(take, 'from', -5)).toEqual({ from: 0, to: 540 });
  expect(trimmed(take, 'from', 539)).toEqual({ from: 528, to: 540 });
  expect(trimmed(take, 'to', 9999)).toEqual({ from: 60, to: 600 });
  expect(trimmed(take, 'to', 3)).toEqual({ from: 60, to: 72 });
});

it('eases speeds like the server', () => {
  const speeds = [{ from: 1, to: 3, speed: 0.25, ease: 0.5 }];
  expect(speedAt(speeds, 0.9)).toBe(1);
  expect(speedAt(speeds, 2)).toBe(0.25);
  expect(speedAt(speeds, 1.25)).toBeCloseTo(0.625);
  expect(speedAt(speeds, 3)).toBe(1);
});

it('takes more pictures of slow parts', () => {
  expect(filmSteps(take, 30)).toHaveLength(241);
  expect(filmSteps(take, 30).slice(0, 3)).toEqual([60, 62, 64]);
  expect(filmSteps(take, 30).at(-1)).toBe(540);
  const slow = { ...take, speeds: [{ from: 2, to: 4, speed: 0.5, ease: 0 }] };
  expect(filmSteps(slow, 30)).toHaveLength(301);
});

it('adds a piece only where there is room', () => {
  expect(withPiece(take, 3, 0.5)).toEqual([{ from: 3, to: 5, speed: 0.5, ease: 0.3 }]);
  expect(withPiece(take, 9.95, 0.5)).toBeNull();
  const one = { ...take, speeds: [{ from: 3, to: 5, speed: 0.5, ease: 0.3 }] };
  expect(withPiece(one, 4, 2)).toBeNull();
  expect(withPiece(one, 2, 2)?.map(({ from, to }) => [from, to])).toEqual([
    [2, 3],
    [3, 5],
  ]);
});

it('counts what happens', () => {
  const mark = (kind: TakeMarkKind) => ({ kind, step: 1, length: 0, label: '' });
  expect(countMarks([])).toBe('');
  expect(countMarks([mark(TakeMarkKind.Touch), mark(TakeMarkKind.Touch), mark(TakeMarkKind.Event)])).toBe(
    '2 touches, 1 event',
  );
});
