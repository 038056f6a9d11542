// What building a place works with.

import type { StudioClient } from '../../link/studio_client';
import type { StudioStore } from '../../model/studio_store';
import type { StudioScene } from '../../scene/studio_scene';
import type { HistoryController } from '../orders/history_controller';
import type { LazyCursor } from '../steer/lazy_cursor';

export interface BuildParts {
  readonly history: Pick<HistoryController, 'ask'>;
  readonly client: StudioClient;
  readonly store: StudioStore;
  readonly view: StudioScene;
  readonly page: HTMLElement;
  readonly cursor: LazyCursor;
}
