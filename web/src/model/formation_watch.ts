// Notices formations that change, whoever changed them: this visitor, another one, or a checkpoint.

import type { GroupInfo } from './studio_state';

export class FormationWatch {
  private known_ = new Map<number, string>();
  private step_ = 0;

  /** Groups that took another formation since the last call; none where the world is new or began anew. */
  observe(groups: readonly GroupInfo[], step: number): readonly GroupInfo[] {
    const anew = step < this.step_;
    this.step_ = step;
    const changed = anew ? [] : groups.filter(({ id, formation }) => (this.known_.get(id) ?? formation) !== formation);
    this.known_ = new Map(groups.map(({ id, formation }) => [id, formation]));
    return changed;
  }

  /** Another world. */
  clear(): void {
    this.known_.clear();
  }
}
