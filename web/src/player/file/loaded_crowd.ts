// A whole file of a player, ready to be drawn.

import { readCrowd, type Crowd } from './crowd_reader';
import { readClips, readFigures, type Figures, type PlayedClip } from './figures_reader';
import { DamagedFile } from './range_decoder';
import { readPlayerFile, type PlayerHead } from './player_file';
import { readScene, type Scene } from './scene_reader';

export interface LoadedCrowd {
  readonly head: PlayerHead;
  readonly figures: Figures;
  readonly clips: readonly PlayedClip[];
  readonly scene: Scene;
  readonly crowd: Crowd;
  /** From the first frame to the last [s]. */
  readonly duration: number;
}

/** Reads a file. Fails with DamagedFile, which says what is wrong. */
export async function loadCrowd(bytes: Uint8Array, wait?: () => Promise<void>): Promise<LoadedCrowd> {
  const file = readPlayerFile(bytes);
  const { head } = file;
  const figures = readFigures(file.body);
  const clips = readClips(file.clip, head.clips, figures.skeleton.parents.length);
  const scene = readScene(file.land, head.things);
  const crowd = await readCrowd(file.crowd, head, clips, wait);
  for (const { body } of crowd.people) if (!figures.bodies[body]) throw new DamagedFile(`found no body ${body}`);
  return { head, figures, clips, scene, crowd, duration: (head.frames - 1) / head.fps };
}
