// The shelf of takes over HTTP (docs/protocol.md). Every call throws a sentence for the visitor where it fails.

import { byUs } from './answers';
import { asked } from './asked';
import type { ShelvedTake, TakeAbout } from '../model/take_facts';

/** How far an export is. */
export interface ExportProgress {
  readonly state: 'waiting' | 'running' | 'done' | 'failed';
  /** 0 to 1 */
  readonly share: number;
  readonly file: string;
  readonly bytes: number;
  /** Of an estimate. */
  readonly people?: number;
  readonly problem?: string;
}

export interface ExportWish {
  readonly take: string;
  readonly format: string;
  /** [s] */
  readonly from: number;
  readonly to: number;
  readonly fps: number;
  readonly speeds: boolean;
  /** Ids; left out: all. */
  readonly groups?: readonly number[];
  /** First and last number; left out: all. */
  readonly people?: readonly [number, number];
  /** Only the size is asked for. */
  readonly estimate?: boolean;
}

const jsonOf = (value: unknown): RequestInit => ({
  body: JSON.stringify(value),
  headers: { 'Content-Type': 'application/json' },
});

export class ShelfLink {
  async list(): Promise<readonly ShelvedTake[]> {
    const answer = await asked('The takes could not be listed', 'takes');
    return ((await answer.json()) as { takes: ShelvedTake[] }).takes;
  }

  /** Puts a file on the shelf; its name there. */
  async put(file: Blob, called: string): Promise<string> {
    const init = { method: 'POST', body: file, headers: { 'Content-Type': 'application/octet-stream' } };
    const answer = await asked(`“${called}” could not be opened`, 'takes', init);
    return ((await answer.json()) as { name: string }).name;
  }

  async file(name: string): Promise<Blob> {
    return (await asked('The take could not be copied', takeAddress(name))).blob();
  }

  async open(name: string): Promise<void> {
    await asked('The take could not be opened', byUs(`takes/${name}/open`), { method: 'POST' });
  }

  async edit(name: string, about: TakeAbout): Promise<void> {
    await asked('The take could not be changed', `takes/${name}`, { method: 'PATCH', ...jsonOf(about) });
  }

  async remove(name: string): Promise<void> {
    await asked('The take could not be removed', `takes/${name}`, { method: 'DELETE' });
  }

  async restore(name: string): Promise<void> {
    await asked('The take could not be brought back', `takes/${name}/restore`, { method: 'POST' });
  }

  async putPicture(name: string, picture: Blob): Promise<void> {
    await asked('The picture could not be kept', `takes/${name}/picture`, { method: 'PUT', body: picture });
  }

  async beginExport(wish: ExportWish): Promise<string> {
    const answer = await asked('The take could not be exported', 'exports', { method: 'POST', ...jsonOf(wish) });
    return ((await answer.json()) as { number: string }).number;
  }

  async exportProgress(number: string): Promise<ExportProgress> {
    return (await asked('The export is lost', `exports/${number}`)).json() as Promise<ExportProgress>;
  }

  async cancelExport(number: string): Promise<void> {
    await asked('The export could not be cancelled', `exports/${number}`, { method: 'DELETE' });
  }
}

/** Where a take can be downloaded. */
export function takeAddress(name: string): string {
  return `takes/${name}`;
}

export function pictureAddress(take: Pick<ShelvedTake, 'name' | 'changed'>): string {
  return `takes/${take.name}/picture?${take.changed}`;
}

export function exportAddress(number: string): string {
  return `exports/${number}/file`;
}
