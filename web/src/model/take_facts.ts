// What the page knows of takes, and how it writes it.

import type { SpeedPiece, TakeMark, TakeState } from '../protocol/messages';
import { formatClock } from './formatters';

/** A take on the server's shelf, as `GET /takes` tells of it. */
export interface ShelvedTake {
  readonly name: string;
  readonly title: string;
  /** Title of the scenario. */
  readonly scenario: string;
  readonly characters: number;
  readonly steps: number;
  /** [s] */
  readonly stepTime: number;
  /** First and last step of the part that is shown. */
  readonly from: number;
  readonly to: number;
  /** Length of that part. */
  readonly seconds: number;
  /** False: the recording was cut off. */
  readonly finished: boolean;
  /** It is being recorded now. */
  readonly recording: boolean;
  readonly picture: boolean;
  /** Last change, in seconds since 1970. */
  readonly changed: number;
  readonly bytes: number;
  readonly speeds: readonly SpeedPiece[];
}

/** The last step of a part that goes on to the take's end. */
export const kTakeEnd = 0xffffffff;

/** Steps from one to another. */
export interface StepRange {
  readonly from: number;
  readonly to: number;
}

/** The open take. */
export type OpenTake = Omit<TakeState, 'type' | 'open'>;

/** What is said about a take; the server keeps it with the file. */
export interface TakeAbout {
  readonly title: string;
  readonly from: number;
  readonly to: number;
  readonly speeds: readonly SpeedPiece[];
}

/** What people call a take: its title, or scenario. */
export function takeTitle(take: Pick<ShelvedTake, 'title' | 'scenario'>): string {
  return take.title || take.scenario || 'Take';
}

/** "0:24", "1:02:05". */
export function formatLengthOf(seconds: number): string {
  const whole = Math.max(0, Math.round(seconds));
  const [hours, minutes, rest] = [Math.floor(whole / 3600), Math.floor(whole / 60) % 60, whole % 60];
  const two = (value: number): string => String(value).padStart(2, '0');
  return hours > 0 ? `${hours}:${two(minutes)}:${two(rest)}` : `${minutes}:${two(rest)}`;
}

/** "just now", "5 minutes ago", "3 hours ago", "yesterday", or a date. */
export function formatAge(changed: number, now: number): string {
  const minutes = Math.floor((now - changed) / 60);
  if (minutes < 1) return 'just now';
  if (minutes < 60) return minutes === 1 ? 'a minute ago' : `${minutes} minutes ago`;
  const hours = Math.floor(minutes / 60);
  if (hours < 24) return hours === 1 ? 'an hour ago' : `${hours} hours ago`;
  if (hours < 48) return 'yesterday';
  return new Date(changed * 1000).toLocaleDateString('en', { day: 'numeric', month: 'short', year: 'numeric' });
}

/** "4.2 MB". */
export function formatBytes(bytes: number): string {
  if (bytes < 1000) return `${bytes} bytes`;
  const units = ['kB', 'MB', 'GB'];
  let value = bytes / 1000;
  let unit = 0;
  while (value >= 1000 && unit < units.length - 1) {
    value /= 1000;
    unit += 1;
  }
  return `${value < 10 ? value.toFixed(1) : Math.round(value)} ${units[unit]}`;
}

/** A part moved by one of its ends: it stays within the take and at least a fifth of a second long. */
export function trimmed(
  take: Pick<OpenTake, 'steps' | 'stepTime' | 'from' | 'to'>,
  end: 'from' | 'to',
  step: number,
): { readonly from: number; readonly to: number } {
  const least = Math.min(take.steps, Math.max(1, Math.round(0.2 / take.stepTime)));
  const whole = Math.round(step);
  if (end === 'from') return { from: Math.max(0, Math.min(whole, take.to - least)), to: take.to };
  return { from: take.from, to: Math.min(take.steps, Math.max(whole, take.from + least)) };
}

/** The take's pace at that time of it: as TakeAbout::speedAt of the server. */
export function speedAt(speeds: readonly SpeedPiece[], seconds: number): number {
  const piece = speeds.find((one) => seconds >= one.from && seconds < one.to);
  if (!piece) return 1;
  const ease = Math.min(piece.ease, (piece.to - piece.from) / 2);
  if (ease <= 0) return piece.speed;
  const t = Math.min(1, Math.min(seconds - piece.from, piece.to - seconds) / ease);
  return 1 + (piece.speed - 1) * t * t * (3 - 2 * t);
}

/** The steps at which a film of a part has its pictures. */
export function filmSteps(take: OpenTake, fps: number): number[] {
  const steps: number[] = [];
  const samples = 8;
  const end = take.to * take.stepTime + 1e-9;
  for (let time = take.from * take.stepTime; time <= end;) {
    steps.push(Math.min(take.to, Math.round(time / take.stepTime)));
    for (let i = 0; i < samples; ++i) time += speedAt(take.speeds, time + 1e-9) / (fps * samples);
  }
  return steps;
}

/** A further piece at that time, where there is room for one; null where there is none. */
export function withPiece(take: OpenTake, seconds: number, speed: number): SpeedPiece[] | null {
  const end = take.steps * take.stepTime;
  const inside = take.speeds.some((one) => seconds >= one.from - 0.01 && seconds < one.to);
  const next = Math.min(end, ...take.speeds.filter((one) => one.from > seconds).map((one) => one.from));
  const to = Math.min(next, seconds + 2);
  if (inside || to - seconds < 0.2) return null;
  const piece: SpeedPiece = { from: round(seconds), to: round(to), speed, ease: 0.3 };
  return [...take.speeds, piece].sort((a, b) => a.from - b.from);
}

function round(seconds: number): number {
  return Math.round(seconds * 100) / 100;
}

/** How many marks of each kind lie in a take: "12 touches, 3 orders". */
export function countMarks(marks: readonly TakeMark[]): string {
  const names = ['touch', 'order', 'change', 'event'];
  const plural = ['touches', 'orders', 'changes', 'events'];
  return names
    .map((name, kind) => {
      const count = marks.filter((mark) => mark.kind === kind).length;
      return count === 0 ? '' : `${count} ${count === 1 ? name : plural[kind]}`;
    })
    .filter((text) => text !== '')
    .join(', ');
}

/** Of the take around its part so much is shown too, as shares of the part and of the take. */
const kAround = 0.12;
const kNearlyAll = 0.6;

/** The steps that a time line shows: the part and some of what lies around it, or all where the part is most of it. */
export function shownOf({ steps, from, to }: Pick<OpenTake, 'steps' | 'from' | 'to'>): StepRange {
  if (to - from >= kNearlyAll * steps) return { from: 0, to: steps };
  const around = Math.max(1, Math.ceil(kAround * (to - from)));
  return { from: Math.max(0, from - around), to: Math.min(steps, to + around) };
}

/** What the clock of a take shows at a step: the time from the beginning of its part, with a minus before that. */
export function clockAt({ from, stepTime }: Pick<OpenTake, 'from' | 'stepTime'>, step: number): string {
  return `${step < from ? '\u2212' : ''}${formatClock(Math.abs(step - from) * stepTime)}`;
}
