// Orders and changes of units as events of gesture files: what a Commands message carries.

import {
  kStanceWords,
  kTurnWords,
  type CommandEvent,
  type EditQueueEvent,
  type GiveOrderEvent,
  type MergeGroupsEvent,
  type PartShapeWord,
  type QueueEditWord,
  type SetConductEvent,
  type SplitGroupEvent,
  type StanceWord,
  type TurnWord,
} from '../protocol/generated/commands';
import type { GroundPoint } from './plane';

export type { CommandEvent, PartShapeWord, QueueEditWord, StanceWord, TurnWord } from '../protocol/generated/commands';
/** Manners that the page offers. */
export type MannerWord = 'march' | 'free';
/** Where orders go that have no spot of their own. */
export type QueueModeWord = 'replace' | 'append';
/** Where a new order stands in a queue; an index counts from 0. */
export type QueueSpot =
  { readonly mode: 'replace' } | { readonly mode: 'append' } | { readonly mode: 'insert'; readonly index: number };
type Pair = readonly [number, number];

/** In the order of their values on the wire. */
export const kManners: readonly MannerWord[] = ['march', 'free'];
export const kTurns = kTurnWords;
export const kStances = kStanceWords;

/** How orders are given until they are given otherwise. */
export interface OrderStyle {
  readonly manner: MannerWord;
  readonly turn: TurnWord;
  readonly mode: QueueModeWord;
}

export interface ConductFacts {
  readonly stance: StanceWord;
  readonly cohesion: number;
  readonly squeeze: number;
  readonly avoids: boolean;
}

/** Where a group shall go. */
export interface MoveTarget {
  readonly target: GroundPoint;
  /** [rad]; null for the heading of the last stretch. */
  readonly facing: number | null;
  /** Of the front [m]; 0 to keep it. */
  readonly width: number;
  readonly route: readonly GroundPoint[];
  /** Which formation to take up; null to keep it. */
  readonly formation: { readonly kind: string; readonly spacing: number } | null;
}

/** An order of a group. */
export type GroupEvent = GiveOrderEvent;

function rounded(value: number): number {
  return Math.round(value * 1000) / 1000;
}

function pair({ x, y }: GroundPoint): Pair {
  return [rounded(x), rounded(y)];
}

export function moveEvent(
  group: number,
  to: MoveTarget,
  style: OrderStyle,
  spot: QueueSpot = { mode: style.mode },
): GroupEvent {
  const [x, y] = pair(to.target);
  return {
    kind: 'move',
    group,
    ...spot,
    x,
    y,
    ...(to.facing === null ? {} : { facing: rounded(to.facing) }),
    ...(to.width > 0 ? { width: rounded(to.width) } : {}),
    ...(to.route.length > 0 ? { route: to.route.map(pair) } : {}),
    ...(to.formation ? { formation: to.formation } : {}),
    manner: style.manner,
    turn: style.turn,
  };
}

export function followEvent(group: number, leader: number, offset: GroundPoint, spot: QueueSpot): GroupEvent {
  return { kind: 'follow', group, ...spot, leader, offset: pair(offset) };
}

export function guardEvent(
  group: number,
  centre: GroundPoint,
  halfSize: GroundPoint,
  facing: number,
  spot: QueueSpot,
): GroupEvent {
  const [x, y] = pair(centre);
  return { kind: 'guard', group, ...spot, x, y, facing: rounded(facing), halfSize: pair(halfSize) };
}

/** By those exits; none for all. */
export function leaveEvent(group: number, exits: readonly number[], spot: QueueSpot): GroupEvent {
  return { kind: 'leave', group, ...spot, ...(exits.length > 0 ? { exits } : {}) };
}

export function waitEvent(group: number, area: number, spot: QueueSpot): GroupEvent {
  return { kind: 'wait', group, ...spot, area };
}

export function queueEvent(group: number, edit: QueueEditWord, order = 0): EditQueueEvent {
  return { kind: 'queue', group, edit, ...(order > 0 ? { order } : {}) };
}

export function conductEvent(group: number, conduct: ConductFacts): SetConductEvent {
  return { kind: 'conduct', group, ...conduct };
}

/** Those to the left of a line, looking from its first point to its second, leave. */
export function splitByLineEvent(group: number, from: GroundPoint, to: GroundPoint): SplitGroupEvent {
  return { kind: 'split', group, by: 'line', points: [pair(from), pair(to)], shape: 'asHeld' };
}

export function mergeEvent(groups: readonly number[], shape: PartShapeWord): MergeGroupsEvent {
  return { kind: 'merge', groups, shape };
}

/** The text of a Commands message. */
export function commandText(events: readonly CommandEvent[]): string {
  return JSON.stringify(events);
}
