// Edits of people in the open take: their paths as they will be shown, and what buttons make of an edit.

import type { EditClip, EditClock, EditLook, EditPin, PeopleEdit } from '../protocol/messages';
import type { GroundPoint } from './plane';
import type { TakeWay } from './take_path';

/** Between two pins, and between two points of a clock [s]. */
export const kLeastGap = 0.1;
export const kLeastReach = 0.2;
export const kMostReach = 60;
/** Of clips and looks that begin now [s]. */
const kFirstSpan = 3;
const kLeastSpan = 0.5;
/** The slowest and the fastest own clock at its first and last piece. */
const kSlowest = 1 / 3;
const kFastest = 8;

const rounded = (value: number): number => Math.round(value * 1000) / 1000;

/** As pinWeight() of the server: 1 at the pin, 0 at the end of its reach. */
export function pinWeight(share: number): number {
  const s = Math.min(1, Math.max(0, share));
  return 1 - s * s * s * (10 + s * (-15 + 6 * s));
}

/** Where pins move a path at a time of the own clock; each reaches at most to the next one. */
export function pinOffset(pins: readonly EditPin[], own: number): GroundPoint {
  const offset = { x: 0, y: 0 };
  pins.forEach((pin, k) => {
    const after = own - pin.time;
    const beside = after < 0 ? pins[k - 1] : after > 0 ? pins[k + 1] : undefined;
    const reach = beside ? Math.min(pin.seconds, Math.abs(beside.time - pin.time)) : pin.seconds;
    const weight = pinWeight(Math.abs(after) / reach);
    offset.x += pin.x * weight;
    offset.y += pin.y * weight;
  });
  return offset;
}

/** The path as it is shown. */
export function editedPoints({ points, spacing, stepTime }: TakeWay, pins: readonly EditPin[]): GroundPoint[] {
  if (pins.length === 0) return [...points];
  return points.map(({ x, y }, k) => {
    const offset = pinOffset(pins, k * spacing * stepTime);
    return { x: x + offset.x, y: y + offset.y };
  });
}

/** The place on the path at a time of the own clock. */
export function placeAt(way: TakeWay, pins: readonly EditPin[], own: number): GroundPoint | null {
  const last = way.points.length - 1;
  if (last < 0) return null;
  const at = Math.min(last, Math.max(0, own / (way.spacing * way.stepTime)));
  const k = Math.floor(at);
  const [a, b] = [way.points[k]!, way.points[Math.min(k + 1, last)]!];
  const offset = pinOffset(pins, own);
  return { x: a.x + (b.x - a.x) * (at - k) + offset.x, y: a.y + (b.y - a.y) * (at - k) + offset.y };
}

function slopesOf(clock: readonly EditClock[]): number[] {
  const rates = clock.slice(1).map(({ time, own }, k) => (own - clock[k]!.own) / (time - clock[k]!.time));
  const inner = rates.slice(1).map((after, k) => {
    const before = rates[k]!;
    return before + after > 0 ? (2 * before * after) / (before + after) : 0;
  });
  return [Math.min(1, 3 * rates[0]!), ...inner, Math.min(1, 3 * rates.at(-1)!)];
}

/** The own time that is shown at a time of the take. */
export function ownTime(clock: readonly EditClock[], time: number): number {
  const first = clock[0];
  const last = clock.at(-1);
  if (!first || !last) return time;
  if (time <= first.time) return time + first.own - first.time;
  if (time >= last.time) return time + last.own - last.time;
  const k = clock.findIndex((point) => point.time > time) - 1;
  const [a, b] = [clock[k]!, clock[k + 1]!];
  const slopes = slopesOf(clock);
  const span = b.time - a.time;
  const s = (time - a.time) / span;
  const rise = b.own - a.own;
  const [m0, m1] = [slopes[k]! * span, slopes[k + 1]! * span];
  return a.own + s * (m0 + s * (3 * rise - 2 * m0 - m1 + s * (m0 + m1 - 2 * rise)));
}

/** The time of the take at which that own time is shown. */
export function takeTime(clock: readonly EditClock[], own: number): number {
  const first = clock[0];
  const last = clock.at(-1);
  if (!first || !last) return own;
  if (own <= first.own) return own - first.own + first.time;
  if (own > last.own) return own - last.own + last.time;
  let [low, high] = [first.time, last.time];
  for (let i = 0; i < 40; ++i) {
    const middle = (low + high) / 2;
    if (ownTime(clock, middle) < own) low = middle;
    else high = middle;
  }
  return high;
}

/** These people's edit; without content where they have none or different ones. */
export function editOf(edits: readonly PeopleEdit[], people: readonly number[]): PeopleEdit {
  const own = edits.find((edit) => edit.people.includes(people[0] ?? 0));
  const shared = own && people.every((id) => own.people.includes(id));
  const { pins, clock, clips, looks } = shared ? own : { pins: [], clock: [], clips: [], looks: [] };
  return { people: Uint32Array.from(people).sort(), pins, clock, clips, looks };
}

export function isEmpty({ pins, clock, clips, looks }: PeopleEdit): boolean {
  return pins.length + clock.length + clips.length + looks.length === 0;
}

/** With a pin at a time of the own clock, where the path is; `at` becomes its index, or that of one that is there. */
export function withPin(pins: readonly EditPin[], time: number, seconds: number): { pins: EditPin[]; at: number } {
  const there = pins.findIndex((pin) => Math.abs(pin.time - time) < kLeastGap + 1e-6);
  if (there >= 0) return { pins: [...pins], at: there };
  const pin = { time: rounded(time), ...pinOffset(pins, time), seconds };
  const made = [...pins, pin].sort((a, b) => a.time - b.time);
  return { pins: made, at: made.indexOf(pin) };
}

export function movedPin(pins: readonly EditPin[], at: number, to: GroundPoint): EditPin[] {
  return pins.map((pin, k) => (k === at ? { ...pin, x: rounded(to.x), y: rounded(to.y) } : pin));
}

export function reachingPin(pins: readonly EditPin[], at: number, factor: number): EditPin[] {
  const within = (seconds: number): number => Math.min(kMostReach, Math.max(kLeastReach, rounded(seconds)));
  return pins.map((pin, k) => (k === at ? { ...pin, seconds: within(pin.seconds * factor) } : pin));
}

/** What is shown from that time on comes so much later (earlier below 0); until then the clock makes up for it. */
export function laterFrom(clock: readonly EditClock[], time: number, by: number): EditClock[] {
  const own = ownTime(clock, time) - by;
  const before = clock.filter((point) => point.time < time - kLeastGap);
  const after = clock.filter((point) => point.time > time + kLeastGap);
  const span = Math.max(3, 2 * Math.abs(by));
  const begin = { time: rounded(Math.max(0, time - span)), own: ownTime(clock, Math.max(0, time - span)) };
  const first = before.length === 0 ? [begin] : before;
  const made = [...first, { time: rounded(time), own: rounded(own) }];
  return [...made, ...after.map((point) => ({ time: point.time, own: rounded(point.own - by) }))];
}

/** From that time on the clock runs so much faster, for `span` [s]. */
export function fasterFrom(clock: readonly EditClock[], time: number, factor: number, span: number): EditClock[] {
  const [from, to] = [ownTime(clock, time), ownTime(clock, time + span)];
  const gained = (to - from) * (factor - 1);
  const before = clock.filter((point) => point.time < time - kLeastGap);
  const after = clock.filter((point) => point.time > time + span + kLeastGap);
  return [
    ...before,
    { time: rounded(time), own: rounded(from) },
    { time: rounded(time + span), own: rounded(to + gained) },
    ...after.map((point) => ({ time: point.time, own: rounded(point.own + gained) })),
  ];
}

/** True for a clock that the server takes. */
export function runs(clock: readonly EditClock[]): boolean {
  return clock.every(({ time, own }, k) => {
    const before = clock[k - 1];
    if (!before) return own >= 0;
    const rate = (own - before.own) / (time - before.time);
    const least = k === 1 || k === clock.length - 1 ? kSlowest : 0;
    return time - before.time >= kLeastGap && rate >= least && rate <= kFastest;
  });
}

type Part = EditClip | EditLook;

/** With a part that begins now and ends before the next one; null where one is there already. */
export function withPart<T extends Part>(parts: readonly T[], part: T, now: number): T[] | null {
  if (parts.some(({ from, to }) => now >= from && now < to)) return null;
  const next = Math.min(...parts.filter(({ from }) => from > now).map(({ from }) => from));
  const to = Math.min(now + kFirstSpan, next);
  if (to - now < kLeastGap) return null;
  return [...parts, { ...part, from: rounded(now), to: rounded(to) }].sort((a, b) => a.from - b.from);
}

/** With that part so much longer, at most to the next one. */
export function longerPart<T extends Part>(parts: readonly T[], at: number, by: number): T[] {
  const next = parts[at + 1]?.from ?? Infinity;
  return parts.map((part, k) =>
    k === at ? { ...part, to: rounded(Math.min(next, Math.max(part.from + kLeastSpan, part.to + by))) } : part,
  );
}
