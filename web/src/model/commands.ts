// Orders and changes of units: what a Commands message carries.

import type {
  ChangeGroupCommand,
  EditQueueCommand,
  FormationDef,
  Given,
  GiveOrderCommand,
  MergeGroupsCommand,
  SplitGroupCommand,
} from '../protocol/generated/commands';
import {
  kStanceWords,
  kTurnWords,
  type PartShapeWord,
  type QueueEditWord,
  type StanceWord,
  type TurnWord,
} from '../protocol/generated/words';
import type { GroundPoint } from './plane';

export type { Command, GiveOrderCommand } from '../protocol/generated/commands';
export type { PartShapeWord, QueueEditWord, StanceWord, TurnWord } from '../protocol/generated/words';
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
  readonly formation: Given<FormationDef> | null;
}

function rounded(value: number): number {
  return Math.round(value * 1000) / 1000;
}

function pair({ x, y }: GroundPoint): Pair {
  return [rounded(x), rounded(y)];
}

export function moveCommand(
  group: number,
  to: MoveTarget,
  style: OrderStyle,
  spot: QueueSpot = { mode: style.mode },
): GiveOrderCommand {
  const order = {
    target: pair(to.target),
    facing: to.facing === null ? null : rounded(to.facing),
    width: rounded(Math.max(0, to.width)),
    route: to.route.map(pair),
    formation: to.formation,
    manner: style.manner,
    turn: style.turn,
  };
  return { kind: 'order', group, ...spot, order };
}

export function followCommand(group: number, leader: number, offset: GroundPoint, spot: QueueSpot): GiveOrderCommand {
  return { kind: 'order', group, ...spot, order: { kind: 'follow', group: leader, offset: pair(offset) } };
}

export function guardCommand(
  group: number,
  centre: GroundPoint,
  halfSize: GroundPoint,
  facing: number,
  spot: QueueSpot,
): GiveOrderCommand {
  const order = { kind: 'guard', target: pair(centre), facing: rounded(facing), halfSize: pair(halfSize) } as const;
  return { kind: 'order', group, ...spot, order };
}

/** By those exits; none for all. */
export function leaveCommand(group: number, exits: readonly number[], spot: QueueSpot): GiveOrderCommand {
  return { kind: 'order', group, ...spot, order: { kind: 'leave', exits } };
}

export function waitCommand(group: number, area: number, spot: QueueSpot): GiveOrderCommand {
  return { kind: 'order', group, ...spot, order: { kind: 'wait', area } };
}

export function queueCommand(group: number, edit: QueueEditWord, order = 0): EditQueueCommand {
  return { kind: 'queue', group, edit, order };
}

export function conductCommand(group: number, conduct: ConductFacts): ChangeGroupCommand {
  return { kind: 'changeGroup', group, conduct };
}

/** Those to the left of a line, looking from its first point to its second, leave. */
export function splitByLineCommand(group: number, from: GroundPoint, to: GroundPoint): SplitGroupCommand {
  return { kind: 'split', group, by: 'line', ids: [], points: [pair(from), pair(to)], shape: 'asHeld' };
}

export function mergeCommand(groups: readonly number[], shape: PartShapeWord): MergeGroupsCommand {
  return { kind: 'merge', groups, shape };
}
