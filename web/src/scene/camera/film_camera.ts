// The camera of a film: key frames along a take, between which it moves with ease, and cuts.

import type { CameraKey as ToldKey } from '../../protocol/messages';
import { isPose, type CameraPose } from './camera_controls';

export interface CameraKey {
  /** Of the take. */
  readonly step: number;
  readonly pose: CameraPose;
  /** The camera is here at once, and rests before. */
  readonly cut?: boolean;
}

/** What the camera shows from one cut to the next [steps]. */
export interface Shot {
  readonly from: number;
  readonly to: number;
}

/** Keys nearer to each other than this are one [steps]. */
const kSameKey = 6;
const kMostKeys = 200;

/** From still to still. */
function eased(share: number): number {
  return share * share * (3 - 2 * share);
}

function between(a: CameraPose, b: CameraPose, share: number): CameraPose {
  const mix = (from: number, to: number): number => from + share * (to - from);
  const turn = Math.atan2(Math.sin(b.turn - a.turn), Math.cos(b.turn - a.turn));
  return {
    targetX: mix(a.targetX, b.targetX),
    targetY: mix(a.targetY, b.targetY),
    // As many times nearer in each moment: otherwise a zoom seems to hurry at its near end.
    distance: Math.exp(mix(Math.log(a.distance), Math.log(b.distance))),
    turn: a.turn + share * turn,
    pitch: mix(a.pitch, b.pitch),
  };
}

/** Where the camera is at a moment; before the first key and behind the last it rests there. Null without keys. */
export function poseAt(keys: readonly CameraKey[], step: number): CameraPose | null {
  const next = keys.findIndex((key) => key.step > step);
  if (keys.length === 0) return null;
  if (next < 0) return keys[keys.length - 1]!.pose;
  if (next === 0) return keys[0]!.pose;
  const [a, b] = [keys[next - 1]!, keys[next]!];
  if (b.cut) return a.pose;
  return between(a.pose, b.pose, eased((step - a.step) / (b.step - a.step)));
}

/** With a key at this moment, in place of one that is as good as there. Keys ascend. */
export function withKey(keys: readonly CameraKey[], step: number, pose: CameraPose, cut = false): CameraKey[] {
  const others = keys.filter((key) => Math.abs(key.step - step) >= kSameKey);
  return [...others, { step, pose: { ...pose }, cut }].sort((a, b) => a.step - b.step).slice(0, kMostKeys);
}

export function withoutKey(keys: readonly CameraKey[], step: number): CameraKey[] {
  return keys.filter((key) => key.step !== step);
}

/** The key of that moment at another one. */
export function withKeyAt(keys: readonly CameraKey[], step: number, to: number): CameraKey[] {
  const key = keys.find((one) => one.step === step);
  return key ? withKey(withoutKey(keys, step), to, key.pose, key.cut) : [...keys];
}

export function withCut(keys: readonly CameraKey[], step: number, cut: boolean): CameraKey[] {
  return keys.map((key) => (key.step === step ? { ...key, cut } : key));
}

/** The shots of a part of a take. */
export function shotsOf(keys: readonly CameraKey[], from: number, to: number): Shot[] {
  if (keys.length === 0) return [];
  const cuts = keys.filter((key) => key.cut && key.step > from && key.step < to).map(({ step }) => step);
  return [from, ...cuts].map((begin, k) => ({ from: begin, to: cuts[k] ?? to }));
}

/** As the take keeps them. */
export function toldKeys(keys: readonly CameraKey[]): ToldKey[] {
  return keys.map(({ step, pose, cut = false }) => {
    const { targetX: x, targetY: y, distance, turn, pitch } = pose;
    return { step, x, y, distance, turn, pitch, cut };
  });
}

export function keysOf(told: readonly ToldKey[]): CameraKey[] {
  return told.map(({ step, x, y, distance, turn, pitch, cut }) => {
    return { step, pose: { targetX: x, targetY: y, distance, turn, pitch }, cut };
  });
}

function isKey(value: unknown): value is CameraKey {
  const { step, pose } = (value ?? {}) as { step?: unknown; pose?: unknown };
  return Number.isInteger(step) && (step as number) >= 0 && isPose(pose) && pose.distance > 0;
}

/** Keys from what a browser has kept; what is none is left out. */
export function readKeys(text: string | null): CameraKey[] {
  try {
    const kept: unknown = JSON.parse(text ?? '[]');
    const keys = Array.isArray(kept) ? kept.filter(isKey) : [];
    return keys.sort((a, b) => a.step - b.step).slice(0, kMostKeys);
  } catch {
    return [];
  }
}
