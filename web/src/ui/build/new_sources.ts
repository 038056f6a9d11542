// A source whose people join a new group: the group comes first, then the source that names it.

import { joinedSource, newArrivals } from '../../model/place/areas';
import { addCommand, type Thing } from '../../model/place/things';
import type { SceneFacts } from '../../protocol/scene';
import { firstOf } from '../orders/history_controller';
import type { PlaceEdit } from './build_edits';

const kLabel = 'Add source';

export class NewSources {
  private source_: Thing | null = null;

  constructor(private readonly send_: (edit: PlaceEdit) => void) {}

  forget(): void {
    this.source_ = null;
  }

  /** True where one of them is such a source: its group is on the way. */
  begin(made: readonly Thing[]): boolean {
    const source = made.find(({ area, group }) => area?.kind === 'source' && group === 0);
    if (!source) return false;
    this.source_ = source;
    this.send_({ label: firstOf(kLabel), changes: [newArrivals(source)], changed: [] });
    return true;
  }

  /** True where the group has come: the source is next. */
  follow(scene: SceneFacts, known: readonly Thing[], sameWorld: boolean): boolean {
    const made = this.source_ && sameWorld ? joinedSource(this.source_, scene, known) : null;
    if (made || !sameWorld) this.source_ = null;
    if (made) this.send_({ label: kLabel, changes: [addCommand(made)], changed: [] });
    return made !== null;
  }
}
