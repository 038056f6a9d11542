import { afterEach, beforeEach, expect, it, vi } from 'vitest';
import { LiveEdits } from './live_edits';

let sent: [number, number, number][] = [];
let edits: LiveEdits<number>;

beforeEach(() => {
  vi.useFakeTimers();
  sent = [];
  edits = new LiveEdits({
    now: () => Date.now(),
    send: (what, gesture) => sent.push([what, gesture, Date.now()]),
  });
});
afterEach(() => vi.useRealTimers());

/** A drag that moves every 10 ms, in a world that answers after `answer` ms. */
function drag(moves: number, answer: number): void {
  let told = sent.length;
  for (let k = 1; k <= moves; ++k) {
    edits.drag(k);
    if (sent.length > told) setTimeout(() => edits.answered(), answer);
    told = sent.length;
    vi.advanceTimersByTime(10);
  }
}

it('sends at most one edit in 100 ms, the newest, and all of one drag with one number', () => {
  edits.begin(5);
  drag(100, 20);
  edits.end(101);
  const times = sent.map(([, , at]) => at);
  expect(sent.length).toBeGreaterThanOrEqual(9);
  expect(sent.length).toBeLessThanOrEqual(12);
  expect(Math.min(...times.slice(1, -1).map((at, k) => at - times[k]!))).toBeGreaterThanOrEqual(100);
  expect(new Set(sent.map(([, gesture]) => gesture))).toEqual(new Set([5]));
  expect(sent.at(-1)![0]).toBe(101);
  expect(sent[3]![0]).toBeGreaterThan(sent[2]![0]);
});

it('gives the next drag the number it is told', () => {
  edits.begin(5);
  edits.drag(1);
  edits.end(2);
  edits.begin(6);
  edits.drag(3);
  edits.end(4);
  expect(sent.map(([what, gesture]) => [what, gesture])).toEqual([
    [1, 5],
    [2, 5],
    [4, 6],
  ]);
});

it('waits for a slow world, and goes on where nothing comes', () => {
  edits.begin(5);
  drag(90, 400);
  expect(sent.length).toBeLessThanOrEqual(3);
  const before = sent.length;
  edits.begin(6);
  edits.drag(1);
  vi.advanceTimersByTime(5000);
  edits.drag(2);
  vi.advanceTimersByTime(900);
  const [last] = sent.slice(-1);
  expect(sent.length).toBeGreaterThan(before);
  expect(last![1]).toBe(6);
});

it('sends where a finger rests, once', () => {
  edits.begin(5);
  edits.drag(1);
  edits.answered();
  edits.drag(2);
  expect(sent.length).toBe(1);
  vi.advanceTimersByTime(100);
  expect(sent.map(([what]) => what)).toEqual([1, 2]);
  edits.answered();
  vi.advanceTimersByTime(5000);
  expect(sent.length).toBe(2);
});

it('brings back what has followed when a drag is given up, and nothing else', () => {
  edits.begin(5);
  edits.cancel(0);
  expect(sent).toEqual([]);
  edits.drag(1);
  edits.cancel(0);
  vi.advanceTimersByTime(5000);
  expect(sent.map(([what, gesture]) => [what, gesture])).toEqual([
    [1, 5],
    [0, 5],
  ]);
});
