// Whether this browser began the recording that runs, or that was cut off.

import type { ShelvedTake } from '../../model/take_facts';
import { readSetting, writeSetting } from '../widgets/theme';

const kKey = 'muster.recorder';

export function rememberRecording(on: boolean): void {
  writeSetting(() => window.localStorage, kKey, on ? 'on' : '');
}

export function hasRecorded(): boolean {
  return readSetting(() => window.localStorage, kKey) === 'on';
}

/** Cut off recordings that the visitor has seen. */
const kSeenKey = 'muster.cutoff';

function seen(): readonly string[] {
  try {
    return JSON.parse(window.localStorage.getItem(kSeenKey) ?? '[]') as string[];
  } catch {
    return [];
  }
}

export function markCutOffSeen(name: string): void {
  rememberRecording(false);
  writeSetting(() => window.localStorage, kSeenKey, JSON.stringify([...seen(), name].slice(-50)));
}

/** The newest recording that a server did not live to end and that this browser has not told of; it is told of once. */
export function untoldCutOff(takes: readonly ShelvedTake[]): ShelvedTake | null {
  const known = seen();
  const found = takes.find((take) => !take.finished && !take.recording && !known.includes(take.name));
  if (found) markCutOffSeen(found.name);
  return found ?? null;
}
