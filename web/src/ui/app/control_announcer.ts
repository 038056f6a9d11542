// Tells of our own controls as they come and grow, and ticks them off in the hint.

import { ControlWatch, kKindNames, kTriedBy } from '../../model/control_watch';
import type { StudioFrame } from '../../model/studio_frame';
import type { HintStep } from '../../model/studio_state';
import type { StudioStore } from '../../model/studio_store';

export class ControlAnnouncer {
  private readonly watch_ = new ControlWatch();

  constructor(
    private readonly store_: StudioStore,
    private readonly hint_: { tried(step: HintStep): void },
    private readonly say_: (text: string) => void,
  ) {}

  /** `own`: our number at the server. */
  observe(frame: StudioFrame, own: number): void {
    for (const { client, kind, index } of this.watch_.observe(frame)) {
      if (client !== own) continue;
      this.hint_.tried(kTriedBy[kind]);
      this.say_(`${kKindNames[kind]} on ${this.store_.state.groups[index]?.name ?? 'the formation'}`);
    }
  }
}
