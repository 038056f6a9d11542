// What building tells the server: edits of things, at once or while a drag goes on, and what is on the way to it.

import type { StudioClient } from '../../link/studio_client';
import { emptiedGroups } from '../../model/place/areas';
import { PendingChanges } from '../../model/place/pending';
import { defined } from '../../model/place/routes';
import * as things from '../../model/place/things';
import type { PlaceChange, Thing } from '../../model/place/things';
import type { Edit } from '../../protocol/messages';
import { firstOf } from '../orders/history_controller';
import { LiveEdits } from './live_edits';

/** One edit: its name for people, its changes, and things that are shown as it leaves them. */
export interface PlaceEdit {
  readonly label: string;
  readonly changes: readonly PlaceChange[];
  readonly changed: readonly Thing[];
}

/** Changes of one message. */
const kMostChanges = 200;
/** After a refusal what was there is shown again [ms]. */
const kPatience = 1550;

/** The lists of a message. */
function told(changes: readonly PlaceChange[]): Pick<Edit, 'commands' | 'bodies'> {
  return {
    commands: changes.flatMap((one) => (one.kind === 'groupBody' ? [] : [one])),
    bodies: changes.flatMap((one) => (one.kind === 'groupBody' ? [one.edit] : [])),
  };
}

export class BuildEdits {
  private readonly pending_ = new PendingChanges();
  private readonly live_ = new LiveEdits<PlaceEdit>({
    now: () => performance.now(),
    send: (edit, gesture) => this.tell(edit, gesture),
  });
  private gestures_ = Math.floor(Math.random() * 1e9);
  private waits_ = 0;

  /** `shows` is called where what over() gives has changed. */
  constructor(
    private readonly client_: StudioClient,
    private readonly shows_: () => void,
    /** Of the world [s]. */
    private readonly time_: () => number,
  ) {}

  /** What the server is told of a thing that stands like this now. */
  told(one: Thing): Thing {
    return defined(one, this.time_());
  }

  /** The edit that leaves the things like this; those without an id are new. */
  changeOf(label: string, changed: readonly Thing[]): PlaceEdit {
    const change = (one: Thing): PlaceChange => (one.id === 0 ? things.addCommand(one) : things.changeCommand(one));
    return {
      label,
      changes: changed.map((one) => change(this.told(one))),
      changed: changed.filter(({ id }) => id !== 0),
    };
  }

  /** The same where some of them are things of another kind now, and so other things. */
  become(label: string, before: readonly Thing[], after: readonly Thing[]): PlaceEdit {
    const others = before.filter((one, k) => one.kind !== after[k]!.kind);
    const now = after.map((one, k) => (others.includes(before[k]!) ? { ...one, id: 0 } : one));
    const edit = this.changeOf(label, now);
    return { ...edit, changes: [...others.map(things.removeCommand), ...edit.changes] };
  }

  /** What the server shows, with what it has been told since. */
  over(shown: readonly Thing[]): Thing[] {
    return this.pending_.over(shown, performance.now());
  }

  send(edit: PlaceEdit): void {
    if (edit.changes.length > 0) this.tell(edit, edit.changes.length > kMostChanges ? ++this.gestures_ : 0);
  }

  /** Nobody would ever be in the group of a source that is gone. Groups go last, and so come back first. */
  remove(chosen: readonly Thing[], all: readonly Thing[]): void {
    const [one] = chosen;
    const label = chosen.length === 1 ? `Remove ${one!.area?.kind ?? one!.kind}` : 'Remove';
    const removed = [...chosen, ...emptiedGroups(chosen, all)];
    const sources = removed.filter(({ group }) => removed.some(({ kind, id }) => kind === 'group' && id === group));
    const others = removed.filter((gone) => !sources.includes(gone));
    const first = sources.length > 0 && others.length > 0 ? firstOf(label) : label;
    this.send({ label: first, changes: sources.map(things.removeCommand), changed: [] });
    this.send({ label, changes: others.map(things.removeCommand), changed: [] });
  }

  /** A drag begins: all its edits are taken back together. */
  begin(): void {
    this.live_.begin(++this.gestures_);
  }

  /** How the drag leaves things at present. The world follows where that is one message. */
  drag(edit: PlaceEdit): void {
    if (edit.changes.length > 0 && edit.changes.length <= kMostChanges) this.live_.drag(edit);
  }

  end(edit: PlaceEdit): void {
    if (edit.changes.length > 0) this.live_.end(edit);
  }

  /** The drag is given up; `before` is how things were. */
  cancel(before: PlaceEdit): void {
    this.live_.cancel(before);
  }

  /** The server has shown or refused something. */
  answered(): void {
    this.live_.answered();
  }

  /** What the server shows counts from now on. */
  forget(): void {
    this.pending_.clear();
  }

  private tell({ label, changes, changed }: PlaceEdit, gesture: number): void {
    for (let from = 0; from < changes.length; from += kMostChanges)
      this.client_.send({
        type: 'Edit',
        label,
        gesture,
        ...told(changes.slice(from, from + kMostChanges)),
      });
    window.clearTimeout(this.waits_);
    this.waits_ = window.setTimeout(this.shows_, kPatience);
    if (changed.length === 0) return;
    this.pending_.put(changed, performance.now());
    this.shows_();
  }
}
