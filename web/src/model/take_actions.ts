// What the panels of takes can ask for.

import type { SpeedPiece } from '../protocol/messages';
import type { ShelvedTake } from './take_facts';

export interface TakeActions {
  /** A finger or key takes the playhead of the open take. */
  beginScrub(): void;
  seek(step: number): void;
  endScrub(): void;
  /** Another part of the open take, or other speeds. */
  setPart(from: number, to: number): void;
  setSpeeds(speeds: readonly SpeedPiece[]): void;
  setLoop(loop: boolean): void;
  /** Directs from the shown moment on; `keep`: on top of what was recorded. */
  takeAgain(keep: boolean): void;
  leaveTake(): void;
  /** Opens a take of the shelf; `trim` takes the visitor to its ends. */
  openTake(name: string, trim?: boolean): void;
  /** The dialog for files of other programs, pictures and films; the open take where no name is given. */
  exportTake(name?: string): void;
  saveTake(take: ShelvedTake): void;
  renameTake(take: ShelvedTake, title: string): void;
  removeTake(take: ShelvedTake): void;
  restoreTake(take: ShelvedTake): void;
  closeCard(): void;
  closeShelf(): void;
}
