// Scenarios by the folder that they lie in.

import type { ScenarioInfo } from '../protocol/messages';

export interface ScenarioGroup {
  /** Empty for those in no folder. */
  readonly title: string;
  readonly scenarios: readonly ScenarioInfo[];
}

/** Folders that ship have titles; others are called by their name. */
const kTitles: Readonly<Record<string, string>> = { paper: 'The paper’s experiments', places: 'Kept here' };

/** In the order of the list. */
export function groupScenarios(scenarios: readonly ScenarioInfo[]): ScenarioGroup[] {
  const folders = new Map<string, ScenarioInfo[]>();
  for (const info of scenarios) {
    const folder = info.name.slice(0, Math.max(0, info.name.lastIndexOf('/')));
    const known = folders.get(folder);
    if (known) known.push(info);
    else folders.set(folder, [info]);
  }
  return [...folders].map(([folder, list]) => ({
    title: Object.hasOwn(kTitles, folder) ? kTitles[folder]! : folder,
    scenarios: list,
  }));
}
