// Whether this browser began the recording that runs, or that was cut off.

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

export function seenCutOffs(): readonly string[] {
  try {
    return JSON.parse(window.localStorage.getItem(kSeenKey) ?? '[]') as string[];
  } catch {
    return [];
  }
}

export function markCutOffSeen(name: string): void {
  rememberRecording(false);
  writeSetting(() => window.localStorage, kSeenKey, JSON.stringify([...seenCutOffs(), name].slice(-50)));
}
